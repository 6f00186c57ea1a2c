#include <Cutwater/Render/Detail/Oklch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cutwater::detail {

namespace {

// IEC 61966-2-1.

std::uint8_t encoded(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * s));
}

double decoded(std::uint8_t code) {
  const double s = code / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

}  // namespace

/// B. Ottosson, "A perceptual color space for image processing", 2020: Oklab to linear sRGB.
Rgb toRgb(const Lch& color) {
  const double angle = color.hue * std::numbers::pi / 180;
  const double a = color.chroma * std::cos(angle);
  const double b = color.chroma * std::sin(angle);
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(color.lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(color.lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(color.lightness - 0.0894841775 * a - 1.2914855480 * b);
  return toRgb(Light{4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                     -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                     -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s});
}

Light toLight(const Rgb& color) {
  return {decoded(color.red), decoded(color.green), decoded(color.blue)};
}

Rgb toRgb(const Light& light) {
  return {encoded(light[0]), encoded(light[1]), encoded(light[2])};
}

}  // namespace cutwater::detail
