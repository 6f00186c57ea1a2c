#pragma once

#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>

namespace cutwater {

/// Sums up the volumes of the leaves that are all fluid, and of those without fluid.
inline void sumWholeLeaves(const LeafGrid& grid, CutLeaves& leaves) {
  DoubleDouble fluid;
  DoubleDouble body;
  for (std::uint32_t leaf = 0; leaf < leaves.classes.size(); ++leaf) {
    if (leaves.classes[leaf] == FluidClass::Fluid) fluid += grid.volume(leaf);
    if (leaves.classes[leaf] == FluidClass::Body) body += grid.volume(leaf);
  }
  leaves.wholeFluid = static_cast<double>(fluid);
  leaves.wholeBody = static_cast<double>(body);
}

}  // namespace cutwater
