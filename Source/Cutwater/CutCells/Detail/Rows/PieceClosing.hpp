#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>

namespace cutwater {

/// Closes the pieces of cells in which triangles meet, edge by edge: where their polygons, which
/// were divided in floating point, leave gaps without area between them, such as where one has a
/// corner within an edge of another, these become polygons of the last part of the wall; of a piece
/// without a wall, a part of the outline of an open patch.
void closePieces(CutCells& cells);
void closePieces(CutLeaves& leaves);

}  // namespace cutwater
