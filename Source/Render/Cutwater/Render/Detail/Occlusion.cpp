#include <Cutwater/Render/Detail/Occlusion.hpp>

#include <algorithm>
#include <array>

namespace cutwater::detail {

namespace {

/// Heights above the surface in units of the radius, and their weights.
constexpr std::array kHeights{1.0, 0.6, 0.35, 0.18, 0.08};
constexpr std::array kWeights{0.30, 0.25, 0.20, 0.15, 0.10};

}  // namespace

template <std::floating_point T>
std::vector<float> Occlusion<T>::openness(std::span<const Foot> feet) const {
  std::vector<Vec3<T>> points;
  for (const auto& foot : feet) {
    for (const double height : kHeights) {
      points.emplace_back(foot.point + height * radius_ * foot.normal);
    }
  }
  std::vector<T> values(points.size());
  solid_.signedDistances(points, values, {.threads = 1, .progress = {}});
  std::vector<float> open(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < kHeights.size(); ++k) {
      const auto at = i * kHeights.size() + k;
      sum += kWeights[k] * freePart(values[at], points[at], kHeights[k] * radius_);
    }
    open[i] = static_cast<float>(sum);
  }
  return open;
}

/// The fraction of the height above the surface that is free. What was cut away counts as free.
template <std::floating_point T>
double Occlusion<T>::freePart(T value, const Vec3<T>& p, double height) const {
  double free = distance_(value, p, 0);
  if (!distance_.isKnown()) free = value < 0 ? 0 : height;
  return std::clamp(std::max(free, region_.clearance(Vec3<double>(p))) / height, 0.0, 1.0);
}

template class Occlusion<float>;
template class Occlusion<double>;

}  // namespace cutwater::detail
