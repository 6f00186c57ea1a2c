#pragma once

#include <Cutwater/Render/Image.hpp>

#include <array>

/// Colours by their appearance; for use within this folder only.
namespace cutwater::detail {

/// A colour by lightness, chroma and hue (degrees) in Oklab.
struct Lch {
  double lightness, chroma, hue;
};

[[nodiscard]] Rgb toRgb(const Lch& color);

/// Amounts of red, green and blue light from 0 to 1, as lighting adds them.
using Light = std::array<double, 3>;

[[nodiscard]] Light toLight(const Rgb& color);
/// Values above 1 are shown as 1.
[[nodiscard]] Rgb toRgb(const Light& light);

}  // namespace cutwater::detail
