#include <Cutwater/Render/ColorMap.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cutwater {

namespace {

/// A colour by lightness, chroma and hue (degrees) in Oklab.
struct Lch {
  double lightness, chroma, hue;
};

std::uint8_t encoded(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * s));
}

/// B. Ottosson, "A perceptual color space for image processing", 2020: Oklab to linear sRGB; and
/// IEC 61966-2-1 for its encoding.
Rgb toRgb(const Lch& color) {
  const double angle = color.hue * std::numbers::pi / 180;
  const double a = color.chroma * std::cos(angle);
  const double b = color.chroma * std::sin(angle);
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(color.lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(color.lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(color.lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

/// Lightness and hue go straight from `near` to `far`; chroma bulges by `bulge` in the middle.
Lch along(const Lch& near, const Lch& far, double bulge, double t) {
  const auto mix = [t](double a, double b) { return a + t * (b - a); };
  return {mix(near.lightness, far.lightness),
          mix(near.chroma, far.chroma) + bulge * 4 * t * (1 - t), mix(near.hue, far.hue)};
}

constexpr int kSteps = 512;  // per side: finer than 8 bits show

std::array<Rgb, kSteps + 1> side(const Lch& near, const Lch& far, double bulge) {
  std::array<Rgb, kSteps + 1> colors;
  for (int i = 0; i <= kSteps; ++i) {
    colors[static_cast<std::size_t>(i)] =
        toRgb(along(near, far, bulge, static_cast<double>(i) / kSteps));
  }
  return colors;
}

}  // namespace

Rgb signedDistanceColor(double fraction) {
  static const auto inside = side({0.86, 0.060, 225}, {0.37, 0.120, 262}, 0.035);
  static const auto outside = side({0.985, 0.018, 95}, {0.50, 0.120, 38}, 0.045);
  const double t = std::min(std::abs(fraction), 1.0);
  const auto& colors = fraction < 0 ? inside : outside;
  return colors[static_cast<std::size_t>(std::lround(t * kSteps))];
}

}  // namespace cutwater
