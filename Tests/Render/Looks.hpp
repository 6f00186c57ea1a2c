#pragma once

#include <Cutwater/Render/Detail/SphereTracer.hpp>

#include <vector>

namespace cutwater::test {

/// A square picture of the cube [-1.2, 1.2]^3 from one side, a ray through each pixel's middle.
class Look {
 public:
  static constexpr int kSide = 96;
  static constexpr double kHalf = 1.2;
  static constexpr double kPixel = 2 * kHalf / kSide;

  explicit Look(const View& view, double fieldOfView = 0)
      : camera(view, cube(), {0.5 * kSide, 0.5 * kSide, kSide, kSide}, fieldOfView) {}

  static Box<double> cube() { return {{-kHalf, -kHalf, -kHalf}, {kHalf, kHalf, kHalf}}; }
  static detail::PicturePoint middle(int x, int y) { return {x + 0.5, y + 0.5}; }

  /// Row by row.
  template <typename T>
  [[nodiscard]] std::vector<detail::SurfaceSample> at(
      const SignedDistanceFunction<T>& solid, std::span<const CutPlane> cuts = {},
      const detail::TraceOptions& options = {}) const {
    const detail::KeptRegion region(cube(), cuts, false);
    const detail::SphereTracer<T> tracer(solid, region, camera, options);
    std::vector<detail::SurfaceSample> samples(kSide * kSide);
    for (int y = 0; y < kSide; ++y) {
      std::vector<detail::PicturePoint> row;
      for (int x = 0; x < kSide; ++x) row.push_back(middle(x, y));
      const auto first = static_cast<std::size_t>(y) * kSide;
      const auto seen = std::span(samples).subspan(first, kSide);
      tracer.trace(row, {}, seen);
      if (options.occlusionRadius > 0) tracer.light(row, seen);
    }
    return samples;
  }

  [[nodiscard]] detail::Ray ray(std::size_t sample) const {
    const auto [x, y] = middle(static_cast<int>(sample) % kSide, static_cast<int>(sample) / kSide);
    return camera.ray(x, y);
  }

  detail::Camera camera;
};

inline std::size_t hits(std::span<const detail::SurfaceSample> samples) {
  std::size_t count = 0;
  for (const auto& sample : samples) count += sample.isHit() ? 1 : 0;
  return count;
}

}  // namespace cutwater::test
