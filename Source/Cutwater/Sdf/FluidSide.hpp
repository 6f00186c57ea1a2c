#pragma once

#include <cstdint>

namespace cutwater {

/// The side of a solid's surface on which an application computes the flow.
enum class FluidSide : std::uint8_t {
  Outside,  ///< around the solid: a hull, a wing
  Inside,   ///< within it: the solid is the shape of a room or of the bore of a pipe
};

/// Where a closed box lies, in terms of the flow.
enum class FluidClass : std::uint8_t {
  Fluid,    ///< certainly no surface in the box, which is all fluid
  Body,     ///< certainly no surface in the box, which has no fluid
  Cut,      ///< certainly some surface in the box
  Unknown,  ///< nothing proven: treat as Cut
};

}  // namespace cutwater
