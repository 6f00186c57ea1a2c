#pragma once

#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>

namespace cutwater {

/// The walls of cells in which triangles meet, so that they fit together but for slivers: corners
/// are those of the outlines around the cell where these are near, corners that are one but for
/// rounding are the same bits, and edges go through all corners on them. `outlines`: of the arcs.
[[nodiscard]] WallPolygons conformedWalls(const TileSurface& surface, const CellPieces& content,
                                          const CutCells::Polygons& outlines);

}  // namespace cutwater
