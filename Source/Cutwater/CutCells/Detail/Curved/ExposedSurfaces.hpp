#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// Those of some surfaces that may be wall in a box, or a rectangle across an axis. Others are left
/// out as far as that is certain: what meets the box only inside of other bodies, as struts do
/// where they meet in a node.
[[nodiscard]] std::vector<const FluidField*> exposedIn(const FluidField& field,
                                                       const Box<double>& box,
                                                       std::span<const FluidField* const> surfaces);

}  // namespace cutwater
