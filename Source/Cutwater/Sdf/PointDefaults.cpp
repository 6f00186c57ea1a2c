#include <Cutwater/Core/Detail/Epsilon.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Sdf/Detail/FacetSamples.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

// Default answers about points, segments and the surface.

namespace cutwater {

template <std::floating_point T>
bool SignedDistanceFunction<T>::localGainsFromNeighbours() const {
  bool result = false;
  forEachOperand([&](const SignedDistanceFunction& operand) {
    result = result || operand.localGainsFromNeighbours();
  });
  return result;
}

template <std::floating_point T>
void SignedDistanceFunction<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                                     std::span<T> distances) const {
  for (std::size_t i = 0; i < points.size(); ++i) distances[i] = localSignedDistance(points[i]);
}

template <std::floating_point T>
bool SignedDistanceFunction<T>::localSignedDistancesWithin(std::span<const Vec3<T>> /*points*/,
                                                           T /*limit*/,
                                                           std::span<T> /*distances*/) const {
  return false;
}

template <std::floating_point T>
Vec3<T> SignedDistanceFunction<T>::localGradient(const Vec3<T>& point) const {
  // Truncation grows with delta^2, rounding with 1/delta: cbrt(eps) of the size balances them.
  const T scale = length(point) + localGuarantee().size;
  const T delta = std::cbrt(detail::kEps<T>) * (scale > 0 ? scale : T(1));
  const auto g = detail::centredDifferences<T>(
                     [this](const Vec3<T>& p) { return localSignedDistance(p); }, point, delta) /
                 (2 * delta);
  return isFinite(g) ? g : Vec3<T>{};
}

template <std::floating_point T>
SurfacePoint<T> SignedDistanceFunction<T>::localClosestPoint(const Vec3<T>& point) const {
  return detail::projectedPoint<T>(
      {.value = [this](const Vec3<T>& p) { return localSignedDistance(p); },
       .gradient = [this](const Vec3<T>& p) { return localGradient(p); },
       .owner = [this](const Vec3<T>& p) { return localOwner(p); },
       .guarantee = localGuarantee()},
      point);
}

template <std::floating_point T>
void SignedDistanceFunction<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                                   std::span<SurfacePoint<T>> results) const {
  for (std::size_t i = 0; i < points.size(); ++i) results[i] = localClosestPoint(points[i]);
}

template <std::floating_point T>
CrossingCount SignedDistanceFunction<T>::localCrossings(const Segment<T>& segment,
                                                        CrossingVisitor<T> visit) const {
  return detail::isolatedCrossings<T>(
      {.value = [this](const Vec3<T>& p) { return localSignedDistance(p); },
       .gradient = [this](const Vec3<T>& p) { return localGradient(p); },
       .owner = [this](const Vec3<T>& p) { return localOwner(p); },
       .guarantee = localGuarantee()},
      segment, visit);
}

template <std::floating_point T>
void SignedDistanceFunction<T>::crossingsByValues(std::span<const Segment<T>> segments,
                                                  std::span<CrossingCount> counts,
                                                  CrossingsVisitor<T> visit) const {
  detail::isolatedCrossings<T>(
      {.value = [this](const Vec3<T>& p) { return localSignedDistance(p); },
       .gradient = [this](const Vec3<T>& p) { return localGradient(p); },
       .owner = [this](const Vec3<T>& p) { return localOwner(p); },
       .guarantee = localGuarantee()},
      [this](std::span<const Vec3<T>> points, std::span<T> values) {
        localSignedDistances(points, values);
      },
      segments, counts, visit);
}

template <std::floating_point T>
bool SignedDistanceFunction<T>::localFacetsIn(const OrientedBox<T>& box,
                                              FacetVisitor<T> visit) const {
  detail::sampleFacets<T>([this](const Vec3<T>& p) { return localClosestPoint(p); }, box, visit);
  return false;
}

template <std::floating_point T>
Box<T> SignedDistanceFunction<T>::localClearanceBox() const {
  const auto promise = localGuarantee();
  const bool isExact = promise.outside == Quality::Exact && promise.domain == Box<T>::everywhere();
  const auto box = localBoundingBox();
  return isExact && !box.empty() ? box : Box<T>::everywhere();
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type
#define CUTWATER_INSTANTIATE(T)                                                                    \
  template bool SignedDistanceFunction<T>::localGainsFromNeighbours() const;                       \
  template void SignedDistanceFunction<T>::localSignedDistances(std::span<const Vec3<T>>,          \
                                                                std::span<T>) const;               \
  template bool SignedDistanceFunction<T>::localSignedDistancesWithin(std::span<const Vec3<T>>, T, \
                                                                      std::span<T>) const;         \
  template Vec3<T> SignedDistanceFunction<T>::localGradient(const Vec3<T>&) const;                 \
  template SurfacePoint<T> SignedDistanceFunction<T>::localClosestPoint(const Vec3<T>&) const;     \
  template void SignedDistanceFunction<T>::localClosestPoints(std::span<const Vec3<T>>,            \
                                                              std::span<SurfacePoint<T>>) const;   \
  template CrossingCount SignedDistanceFunction<T>::localCrossings(const Segment<T>&,              \
                                                                   CrossingVisitor<T>) const;      \
  template void SignedDistanceFunction<T>::crossingsByValues(                                      \
      std::span<const Segment<T>>, std::span<CrossingCount>, CrossingsVisitor<T>) const;           \
  template bool SignedDistanceFunction<T>::localFacetsIn(const OrientedBox<T>&, FacetVisitor<T>)   \
      const;                                                                                       \
  template Box<T> SignedDistanceFunction<T>::localClearanceBox() const;
// NOLINTEND(bugprone-macro-parentheses)
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

}  // namespace cutwater
