#pragma once

#include <Cutwater/Render/Image.hpp>

#include <array>

/// Colours by how they look; for the parts of this folder only.
namespace cutwater::detail {

/// A colour by lightness, chroma and hue (degrees) in Oklab.
struct Lch {
  double lightness, chroma, hue;
};

[[nodiscard]] Rgb toRgb(const Lch& color);

/// Amounts of red, green and blue light from 0 to 1, as lighting adds them.
using Light = std::array<double, 3>;

[[nodiscard]] Light toLight(const Rgb& color);
/// Of more than 1 the screen shows 1.
[[nodiscard]] Rgb toRgb(const Light& light);

}  // namespace cutwater::detail
