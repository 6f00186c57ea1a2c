#pragma once

#include <Cutwater/Render/Image.hpp>

namespace cutwater {

/// The colour of a signed distance: blue inside, darker the deeper; from cream to a warm brown
/// outside. Lightness falls linearly with the distance on either side, in Oklab, so that equal
/// steps of distance look equal, also in grey; a step in lightness at 0 shows the surface.
///
/// @param fraction from -1, deepest inside, to 1, farthest outside; 0 is outside.
[[nodiscard]] Rgb signedDistanceColor(double fraction);

}  // namespace cutwater
