#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>

namespace cutwater {

/// The bit of a cell's face, see CutCells::Cells::wallFaces.
constexpr std::uint8_t bitOfFace(int axis, bool isHigh) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(2 * axis + (isHigh ? 1 : 0)));
}

/// Notes which faces of their cells hold parts of the pieces' walls, by exact comparisons of the
/// triangles' corners with the cells. In cells where triangles meet, only a triangle in a face has
/// a wall there; which part of it is one was found in floating point.
void noteWallFaces(const TileSurface& surface, const GridPlanes& planes, CellPieces& content);

/// The same in a plane z = const, for a trace of a triangle on it: the side of a rectangle, given
/// as a cell, that holds a part of the trace; 0 if none does.
[[nodiscard]] std::uint8_t wallSideOf(const TileSurface& surface, const GridPlanes& planes,
                                      const TilePlace& cell, std::uint32_t triangle, double z);

}  // namespace cutwater
