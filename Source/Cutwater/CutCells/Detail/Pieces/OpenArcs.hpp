#pragma once

#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>

namespace cutwater {

/// Which face of its cell a fragment lies in.
struct OpenFace {
  bool isOpen = false;  ///< its triangle is one of an open patch
  int axis = -1;        ///< -1: it lies in none, or its triangle is a wall
  bool isHigh = false;

  [[nodiscard]] bool isFace() const { return axis >= 0; }
};

/// By comparisons of the triangle's corners with the planes of the cell.
[[nodiscard]] OpenFace openFaceOf(const TileSurface& surface, const GridPlanes& planes,
                                  const TileFragment& fragment);

/// Adds the arcs of open patches: of each piece, one for each connected part that a patch has in a
/// face of its cell. Notes what lies in none.
void addOpenArcs(const TileSurface& surface, const GridPlanes& planes, const CellMask* wanted,
                 CellPieces& out);

}  // namespace cutwater
