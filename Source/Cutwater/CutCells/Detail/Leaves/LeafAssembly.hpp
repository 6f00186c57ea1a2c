#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafTile.hpp>

namespace cutwater {

/// The rows of the leaves of an octree, from tiles in any order.
[[nodiscard]] CutLeaves assembledLeaves(const CutSurface& surface, const LeafGrid& grid,
                                        std::span<const LeafTile> tiles,
                                        std::vector<FluidClass> classes, const CutOptions& options);

}  // namespace cutwater
