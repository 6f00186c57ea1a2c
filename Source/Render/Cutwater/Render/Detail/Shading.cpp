#include <Cutwater/Render/Detail/Shading.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

// Brightness of each light on a white surface that faces it.
constexpr double kSky = 0.46;
constexpr double kGround = 0.20;
constexpr double kKey = 0.62;
constexpr double kFill = 0.10;
constexpr double kGloss = 0.07;

constexpr double kHatchSpacing = 9;  // pixels at scale 1
constexpr double kHatchWidth = 1.3;  // the same
constexpr double kHatchOpacity = 0.30;
constexpr Rgb kHatchInk{70, 52, 30};

/// How narrow highlights are.
double toGlossPower(double x) {
  const double squared = x * x, fourth = squared * squared, eighth = fourth * fourth;
  return eighth * eighth * eighth;
}

/// A direction in the viewer's frame: to the right, up, towards the viewer.
Vec3<double> seen(const View& view, double right, double up, double back) {
  return normalized(right * view.right() + up * view.up + back * view.back);
}

}  // namespace

Shading::Shading(const View& view, double scale)
    : view_(view),
      scale_(scale),
      key_(seen(view, -0.45, 0.70, 0.80)),
      fill_(seen(view, 0.90, -0.10, 0.50)),
      gloss_(normalized(key_ + view.back)) {}

Rgb Shading::surface(const SurfaceSample& sample, const Rgb& color) const {
  const Vec3<double> normal(sample.normal);
  const double open{sample.open};
  const double above = 0.5 + 0.5 * dot(normal, view_.up);
  const double sky = kGround + above * (kSky - kGround);
  const double key = kKey * std::max(dot(normal, key_), 0.0);
  const double fill = kFill * std::max(dot(normal, fill_), 0.0);
  // Corners get less of the sky than of the lamps.
  const double diffuse = sky * open + (key + fill) * (0.45 + 0.55 * open);
  const double gloss = kGloss * open * toGlossPower(std::max(dot(normal, gloss_), 0.0));
  auto light = toLight(color);
  for (auto& part : light) part = part * diffuse + gloss;
  return toRgb(light);
}

Rgb Shading::cutFace(const Rgb& color, const PicturePoint& at) const {
  const double spacing = kHatchSpacing * scale_;
  const double across = (at.x + at.y) * std::sqrt(0.5);
  const double fromLine = std::abs(std::remainder(across, spacing));
  const double coverage = std::clamp(0.5 * kHatchWidth * scale_ - fromLine + 0.5, 0.0, 1.0);
  return blended(color, kHatchInk, kHatchOpacity * coverage);
}

}  // namespace cutwater::detail
