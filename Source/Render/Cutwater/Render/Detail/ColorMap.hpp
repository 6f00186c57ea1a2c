#pragma once

#include <Cutwater/Render/Image.hpp>

namespace cutwater::detail {

/// The colour of a signed distance: blue inside, darker with depth; from cream to a warm brown
/// outside. On either side, lightness in Oklab falls linearly with the distance, so that equal
/// steps of distance look equal, even in grey; a step in lightness at 0 shows the surface.
///
/// @param fraction from -1, deepest inside, to 1, farthest outside; 0 is outside.
[[nodiscard]] Rgb signedDistanceColor(double fraction);

/// The colour of the share of a cell that is fluid: from a dark violet at 0 over green to a light
/// yellow at 1. Lightness rises linearly with it.
[[nodiscard]] Rgb fluidFractionColor(double fraction);

}  // namespace cutwater::detail
