#include <Cutwater/Render/Detail/Occlusion.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Heights above the surface in units of the radius, and their weights.
constexpr std::array kHeights{1.0, 0.6, 0.35, 0.18, 0.08};
constexpr std::array kWeights{0.30, 0.25, 0.20, 0.15, 0.10};
constexpr double kOpen = 0.98;     // of the height, is as good as all of it
constexpr double kArrived = 0.02;  // of the height: there is the surface
constexpr int kMostSteps = 16;     // towards it

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

/// Replaces bounds that would darken by how far it is to the surface towards which values fall.
/// Where a bound comes from what an operator has cut off, nothing is there.
template <std::floating_point T>
void Occlusion<T>::lookCloser(std::span<const Vec3<T>> points, std::span<double> free) const {
  struct Walk {
    std::size_t index;
    double height;
    Vec3<T> direction;
  };
  std::vector<Walk> walks;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (!(free[i] > 0 && free[i] < kOpen)) continue;
    const auto slope = solid_.gradient(points[i]);
    const double height = kHeights[i % kHeights.size()] * options_.radius;
    if (lengthSquared(slope) > 0) walks.push_back({i, height, -normalized(slope)});
  }
  std::vector<Vec3<T>> places;
  std::vector<T> values;
  for (int step = 0; step < kMostSteps && !walks.empty(); ++step) {
    places.clear();
    for (const auto& [i, height, direction] : walks) {
      places.push_back(points[i] + static_cast<T>(free[i] * height) * direction);
    }
    values.resize(places.size());
    solid_.signedDistances(places, values, {.threads = 1, .progress = {}});
    std::size_t kept = 0;
    for (std::size_t k = 0; k < walks.size(); ++k) {
      const auto [i, height, direction] = walks[k];
      const double further = distance_(values[k], places[k], 0) / height;
      if (!(further > kArrived)) continue;
      free[i] += further;
      if (free[i] < kOpen) walks[kept++] = walks[k];
    }
    walks.resize(kept);
  }
}

template class Occlusion<float>;
template class Occlusion<double>;

}  // namespace cutwater::detail
