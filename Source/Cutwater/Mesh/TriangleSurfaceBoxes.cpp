#include <Cutwater/Mesh/QueryBox.hpp>
#include <Cutwater/Mesh/TriangleSurfaceSDF.hpp>
#include <Cutwater/Sdf/Defaults.hpp>

#include <algorithm>
#include <cmath>

// What a mesh answers about boxes.

namespace cutwater {

template <std::floating_point T>
auto TriangleSurfaceSDF<T>::scaled(const OrientedBox<T>& box) const
    -> std::optional<OrientedBox<double>> {
  constexpr double kTooLarge = 0x1p20;
  const double scale{surface_.scale};
  OrientedBox<double> result;
  result.center = scale * Vec3<double>(box.center);
  for (std::size_t i = 0; i < 3; ++i) {
    result.halfAxis[i] = scale * Vec3<double>(box.halfAxis[i]);
  }
  result.slack = scale * double{box.slack};
  if (!(maxComponent(abs(result.center)) + result.radius() < kTooLarge)) return {};
  return result;
}

template <std::floating_point T>
double TriangleSurfaceSDF<T>::gapTo(const OrientedBox<double>& box, double limit) const {
  const QueryBox query(box);
  double least = limit;
  around(box, limit, [&](std::span<const std::uint32_t> ids) {
    for (const auto id : ids) {
      if (id == kNone) break;
      least = std::min(least, query.gap(query.toBox(surface_.corners(id)), least));
    }
    return least;
  });
  return least;
}

template <std::floating_point T>
Interval<T> TriangleSurfaceSDF<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  // The distance to the triangles changes at most as fast as the point, and is at most that to any
  // one point of them; the sign is what its own bound allows.
  auto promise = localGuarantee();
  promise.lipschitz = T(1);
  const auto hit = localClosestPoint(box.center);
  const auto range = detail::boundsAround(hit.distance, box, promise);
  T least = std::max({T(0), range.lower, -range.upper});
  T most = std::max(-range.lower, range.upper);
  if (const auto q = scaled(box)) {
    const double scale{surface_.scale};
    const T rounding = 4 * promise.error(length(box.center) + box.radius());
    const auto reaches = q->distancesFrom(scale * Vec3<double>(hit.point));
    most = std::min(most, static_cast<T>(reaches.upper / scale) + rounding);
    const T distance = std::abs(hit.distance) + rounding;
    // Farther away the ball around the box is as good, and more triangles compete.
    constexpr T kFar = 4;
    if (distance > box.innerRadius() && distance < kFar * box.radius()) {
      least =
          std::max(least, static_cast<T>(gapTo(*q, scale * double{distance}) / scale) - rounding);
    }
  }
  if (least > 0 && hasNoJump(box.bounds())) {
    return hit.distance < 0 ? Interval<T>{-most, -least} : Interval<T>{least, most};
  }
  if (!signs_.isClosed()) return {-most, most};
  return {std::max(range.lower, -most), std::min(range.upper, most)};
}

template <std::floating_point T>
BoxClass TriangleSurfaceSDF<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  if (hint != nullptr && hint->words[0] != 0) return static_cast<BoxClass>(hint->words[0] - 1);
  const auto q = scaled(box);
  const auto overlap = q ? overlapWith(*q) : BoxOverlap::Possible;
  if (overlap == BoxOverlap::Certain && signs_.isSound()) return BoxClass::Cut;
  if (overlap != BoxOverlap::None || !isJumpFree(q->bounds())) {
    return SignedDistanceFunction<T>::localClassify(box, hint);
  }
  const Vec3<T> p = scaled(box.center);
  const auto nearest = this->nearest(p);
  const auto found = side(p, nearest) < 0 ? BoxClass::Inside : BoxClass::Outside;
  // Of boxes within this one the same is found if there is room even for their rounding.
  const double room = std::sqrt(double{nearest.distanceSquared}) - 8 * double{nearest.error};
  const double rounding = 4 * q->slack + 0x1p-40 * (1 + maxComponent(abs(q->center)));
  if (hint != nullptr && signs_.isClosed() && room > 1.01 * q->radius() + rounding) {
    hint->words[0] = static_cast<std::uint32_t>(found) + 1;
  }
  return found;
}

// The rest of the class is instantiated where it is defined.
#define CUTWATER_DEFINE(T)                                                                        \
  template auto TriangleSurfaceSDF<T>::scaled(const OrientedBox<T>&)                              \
      const->std::optional<OrientedBox<double>>;                                                  \
  template double TriangleSurfaceSDF<T>::gapTo(const OrientedBox<double>&, double) const;         \
  template Interval<T> TriangleSurfaceSDF<T>::localBounds(const OrientedBox<T>&, BoxHint*) const; \
  template BoxClass TriangleSurfaceSDF<T>::localClassify(const OrientedBox<T>&, BoxHint*) const;
CUTWATER_DEFINE(float)
CUTWATER_DEFINE(double)
#undef CUTWATER_DEFINE

}  // namespace cutwater
