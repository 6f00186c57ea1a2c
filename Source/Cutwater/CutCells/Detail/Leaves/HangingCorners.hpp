#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>

namespace cutwater {

/// Makes edges of polygons along an axis go through the corners of others that lie on them, which
/// they have where leaves of other levels are across an edge of a leaf. So the mesh of all pieces
/// closes, edge by edge. An edge gets corners of the leaves around it alone.
void insertHangingCorners(const LeafGrid& grid, CutLeaves& leaves);

}  // namespace cutwater
