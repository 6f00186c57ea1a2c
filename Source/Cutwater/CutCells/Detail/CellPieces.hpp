#pragma once

#include <Cutwater/CutCells/Detail/FacePieces.hpp>

namespace cutwater {

/// A connected part of the fluid in a cell.
struct CellPiece {
  std::uint32_t cell = 0;
  double volume = 0;
  Vec3<double> centroid;
  Vec3<double> areaVector;  ///< of the wall, out of the fluid
  double area = 0;          ///< of the wall
  Vec3<double> wallCentroid;
};

/// An open part of a face, and the pieces on both sides of it: kNone where a cell is not cut, or
/// not in the box.
struct PieceArc {
  std::uint32_t face = 0;
  std::uint32_t below = kNone;
  std::uint32_t above = kNone;
  double area = 0;
  Vec3<double> centroid;
};

/// The pieces of the cells that a surface meets, in the order of cells, and what connects them, in
/// the order of faces.
struct CellPieces {
  std::vector<CellPiece> pieces;
  std::vector<PieceArc> arcs;
};

/// Joins what bounds each piece, and sums up moments by the divergence theorem: each triangle, and
/// each open part of a face, adds its distance from a point of the piece times the integral of the
/// monomial over it.
[[nodiscard]] CellPieces findCellPieces(const TileSurface& surface, const EdgeStretches& stretches,
                                        const FacePieces& faces, const GridPlanes& planes);

}  // namespace cutwater
