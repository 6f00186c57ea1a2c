#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafTile.hpp>

namespace cutwater {

/// Cuts the leaves of an octree by a solid that is no mesh, and sets the classes of all of them.
[[nodiscard]] std::vector<LeafTile> cutLeafTiles(const FluidField& field, const LeafGrid& grid,
                                                 const SolidCutterOptions& how,
                                                 const CutOptions& options,
                                                 std::span<FluidClass> classes);

}  // namespace cutwater
