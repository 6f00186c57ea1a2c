#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Faces/FacePieces.hpp>
#include <Cutwater/CutCells/Detail/Pieces/PieceSums.hpp>

#include <utility>
#include <vector>

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
  /// The open patch of which it is a part: it has a piece on one side, and leads out on the other.
  std::uint32_t patch = kNone;

  [[nodiscard]] bool isOpenPatch() const { return patch != kNone; }
};

/// A fragment of an open patch that cannot be a part of an arc: it lies in no plane of its cell.
struct OpenMisfit {
  std::uint32_t triangle = 0;
  std::uint32_t cell = 0;
  Vec3<double> point;
};

/// Convex polygons of walls and of open patches, with normals into the fluid: of each one its piece
/// and its patch.
struct WallPolygons {
  /// In place of a patch: what makes up the arc of an open patch, plus the arc.
  static constexpr std::uint32_t kOfArc = 0x80000000;

  [[nodiscard]] static bool isOfArc(std::uint32_t patch) {
    return patch >= kOfArc && patch != kNone;
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> of;
  CutCells::Polygons polygons;
};

/// The pieces of the cells that a surface meets, in the order of cells, and what connects them, in
/// the order of faces; arcs of open patches follow, in the order of cells.
struct CellPieces {
  /// In place of an arc: of an open patch, but without area.
  static constexpr std::uint32_t kNoArea = kNone - 1;

  std::vector<CellPiece> pieces;
  std::vector<PieceWall> walls;
  std::vector<PieceArc> arcs;
  std::vector<std::uint32_t> ofFragments;  ///< the piece of each fragment, or kNone
  /// The arc of which each fragment of an open patch is a part, or kNoArea; of walls kNone. Empty
  /// if no patch is open.
  std::vector<std::uint32_t> openArcOf;
  std::vector<OpenMisfit> misfits;

  /// Whether a fragment is a part of a wall.
  [[nodiscard]] bool isWall(std::size_t fragment) const {
    return openArcOf.empty() || openArcOf[fragment] == kNone;
  }
  /// In cells where triangles meet, whose fragments have no piece; in the order of these cells.
  WallPolygons meetingWalls;
};

/// An open part of a face of a piece's cell, but for those of open patches.
struct PieceSide {
  std::uint32_t piece = 0;
  int face = 0;  ///< of the cell: twice the axis, and 1 for the one above
  std::uint32_t arc = 0;
};

/// Sorted by piece; those of a cell in the order of its faces, wherever the tile begins.
[[nodiscard]] std::vector<PieceSide> sidesOf(const CellPieces& content, const TileNumbers& numbers);

/// Joins what bounds each piece of the cells that are wanted, and measures it.
[[nodiscard]] CellPieces findCellPieces(const TileSurface& surface, const EdgeStretches& stretches,
                                        const FacePieces& faces, const GridPlanes& planes,
                                        const CellMask* wanted = nullptr);

}  // namespace cutwater
