#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Faces/FacePieces.hpp>
#include <Cutwater/CutCells/Detail/Pieces/PieceSums.hpp>

#include <utility>

namespace cutwater {

/// An open part of a face, and the pieces on both sides of it: kNone where a cell is not cut, or
/// not in the box.
struct PieceArc {
  std::uint32_t face = 0;
  std::uint32_t below = kNone;
  std::uint32_t above = kNone;
  double area = 0;
  Vec3<double> centroid;
  bool isNothing = false;  ///< a point, which counts for nothing
  bool isDropped = false;  ///< a piece beside it is one
};

/// Convex polygons of walls, with normals into the fluid: of each one its piece and its patch.
struct WallPolygons {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> of;
  CutCells::Polygons polygons;
};

/// The pieces of the cells that a surface meets, in the order of cells, and what connects them, in
/// the order of faces.
struct CellPieces {
  std::vector<CellPiece> pieces;
  std::vector<PieceWall> walls;
  std::vector<PieceArc> arcs;
  std::vector<std::uint32_t> ofFragments;  ///< the piece of each fragment, or kNone
  /// In cells where triangles meet, whose fragments have no piece; in the order of these cells.
  WallPolygons meetingWalls;
};

/// Joins what bounds each piece of the cells that are wanted, and measures it.
[[nodiscard]] CellPieces findCellPieces(const TileSurface& surface, const EdgeStretches& stretches,
                                        const FacePieces& faces, const GridPlanes& planes,
                                        const CellMask* wanted = nullptr);

}  // namespace cutwater
