#include <Cutwater/Render/Detail/Occlusion.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Heights above the surface in units of the radius, and their weights.
constexpr std::array kHeights{1.0, 0.6, 0.35, 0.18, 0.08};
constexpr std::array kWeights{0.30, 0.25, 0.20, 0.15, 0.10};
constexpr double kOpen = 0.98;  // of the height, is as good as all of it

}  // namespace

template <std::floating_point T>
std::vector<float> Occlusion<T>::openness(std::span<const Foot> feet) const {
  constexpr auto kCount = kHeights.size();
  std::vector<Vec3<T>> points;
  for (const auto& foot : feet) {
    for (const double height : kHeights) {
      points.emplace_back(foot.point + height * options_.radius * foot.normal);
    }
  }
  std::vector<T> values(points.size());
  solid_.signedDistances(points, values, {.threads = 1, .progress = {}});
  std::vector<double> free(points.size());  // in heights
  for (std::size_t i = 0; i < free.size(); ++i) {
    const double height = kHeights[i % kCount] * options_.radius;
    free[i] = freeAbout(values[i], points[i], height) / height;
  }
  if (distance_.isKnown() && !distance_.isExact()) lookCloser(points, free);
  std::vector<float> open(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < kCount; ++k) {
      sum += kWeights[k] * std::clamp(free[i * kCount + k], 0.0, 1.0);
    }
    open[i] = static_cast<float>(sum);
  }
  return open;
}

/// How far the surface is from a point at this height. What was cut away does not count.
template <std::floating_point T>
double Occlusion<T>::freeAbout(T value, const Vec3<T>& p, double height) const {
  double free = value < 0 ? 0 : height;
  if (distance_.isKnown()) {
    free = distance_(value, p, 0);
  } else if (options_.hasFacets) {
    free = std::abs(static_cast<double>(value));
  }
  return std::max(free, region_.clearance(Vec3<double>(p)));
}

/// Replaces bounds that would darken by distances to points of the surface, in heights: where a
/// bound comes from what an operator has cut off, nothing is there.
template <std::floating_point T>
void Occlusion<T>::lookCloser(std::span<const Vec3<T>> points, std::span<double> free) const {
  std::vector<std::size_t> doubtful;
  std::vector<Vec3<T>> places;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (!(free[i] > 0 && free[i] < kOpen)) continue;
    doubtful.push_back(i);
    places.push_back(points[i]);
  }
  std::vector<SurfacePoint<T>> found(places.size());
  solid_.closestPoints(places, found, {.threads = 1, .progress = {}});
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto i = doubtful[k];
    const double height = kHeights[i % kHeights.size()] * options_.radius;
    const auto distance = static_cast<double>(length(places[k] - found[k].point));
    if (std::isfinite(distance)) free[i] = std::max(free[i], distance / height);
  }
}

template class Occlusion<float>;
template class Occlusion<double>;

}  // namespace cutwater::detail
