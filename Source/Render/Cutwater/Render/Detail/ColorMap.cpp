#include <Cutwater/Render/Detail/ColorMap.hpp>
#include <Cutwater/Render/Detail/Oklch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Lightness and hue vary linearly from `near` to `far`; chroma is larger by `bulge` in the middle.
Lch along(const Lch& near, const Lch& far, double bulge, double t) {
  const auto mix = [t](double a, double b) { return a + t * (b - a); };
  return {mix(near.lightness, far.lightness),
          mix(near.chroma, far.chroma) + bulge * 4 * t * (1 - t), mix(near.hue, far.hue)};
}

constexpr int kSteps = 512;  // per side: finer than 8 bits resolve

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

Rgb fluidFractionColor(double fraction) {
  static const auto colors = side({0.36, 0.130, 300}, {0.95, 0.100, 100}, 0.02);
  const double t = std::clamp(fraction, 0.0, 1.0);
  return colors[static_cast<std::size_t>(std::lround(t * kSteps))];
}

}  // namespace cutwater::detail
