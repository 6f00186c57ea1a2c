#pragma once

#include <Cutwater/CutCells/Detail/Faces/FacePieces.hpp>
#include <Cutwater/CutCells/Detail/Tiles/SideStretches.hpp>

#include <array>

namespace cutwater {

/// The pieces of a face as a cell in 2D, where triangles meet on it: its open parts, joined where
/// they meet in a stretch of one of its edges. In floating point, as FaceRegions.
struct RectanglePieces {
  RectanglePieces(const FacePieces& faces, const SideStretches& sides, std::uint32_t face);

  std::vector<FacePiece> pieces;         ///< their areas and centroids
  std::vector<FaceRegions::Wall> walls;  ///< those in edges, too; `part` is the piece
  /// By side, see edgeOfFace(), and stretch: the piece, or kNone.
  std::array<std::vector<std::uint32_t>, 4> ofStretches;
};

}  // namespace cutwater
