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
auto TriangleSurfaceSDF<T>::overlapWith(const OrientedBox<double>& box) const -> Overlap {
  const QueryBox query(box);
  auto result = Overlap::None;
  overlapping(box, [&](std::span<const std::uint32_t> ids) {
    for (const auto id : ids) {
      if (id == kNone) break;
      const auto corners = query.toBox(surface_.corners(id));
      if (query.isApart(corners)) continue;
      result = query.meets(corners) ? Overlap::Certain : Overlap::Possible;
      if (result == Overlap::Certain) return false;
    }
    return true;
  });
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
bool TriangleSurfaceSDF<T>::localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const {
  const auto q = scaled(box);
  if (!q) {  // too far away: the surface is a point
    return SignedDistanceFunction<T>::localFacetsIn(box, visit);
  }
  const QueryBox query(*q);
  overlapping(*q, [&](std::span<const std::uint32_t> ids) {
    for (const auto id : ids) {
      if (id == kNone) break;
      if (query.isApart(query.toBox(surface_.corners(id)))) continue;
      if (!visit(facet(id, query))) return false;
    }
    return true;
  });
  return true;
}

template <std::floating_point T>
SurfaceFacet<T> TriangleSurfaceSDF<T>::facet(std::uint32_t id, const QueryBox& box) const {
  const auto normalOf = [this](std::uint32_t triangle) {
    const auto [a, b, c] = surface_.corners(triangle);
    return Vec3<T>(normalized(cross(b - a, c - a)));
  };
  SurfaceFacet<T> result{triangle(id), normalOf(id), {}, surface_.owner(id)};
  const auto corners = surface_.corners(id);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto neighbour = surface_.neighbours[id][i];
    const auto& first = corners[i];
    const auto& second = corners[(i + 1) % 3];
    if (neighbour == kNone || box.isApart(box.toBox({first, second, second}))) continue;
    result.across[i] = normalOf(neighbour);
  }
  return result;
}

template <std::floating_point T>
BoxClass TriangleSurfaceSDF<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  if (hint != nullptr && hint->words[0] != 0) return static_cast<BoxClass>(hint->words[0] - 1);
  const auto q = scaled(box);
  const auto overlap = q ? overlapWith(*q) : Overlap::Possible;
  if (overlap == Overlap::Certain && signs_.isSound()) return BoxClass::Cut;
  if (overlap != Overlap::None || !isJumpFree(q->bounds())) {
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
  template auto TriangleSurfaceSDF<T>::overlapWith(const OrientedBox<double>&) const->Overlap;    \
  template double TriangleSurfaceSDF<T>::gapTo(const OrientedBox<double>&, double) const;         \
  template Interval<T> TriangleSurfaceSDF<T>::localBounds(const OrientedBox<T>&, BoxHint*) const; \
  template bool TriangleSurfaceSDF<T>::localFacetsIn(const OrientedBox<T>&, FacetVisitor<T>)      \
      const;                                                                                      \
  template SurfaceFacet<T> TriangleSurfaceSDF<T>::facet(std::uint32_t, const QueryBox&) const;    \
  template BoxClass TriangleSurfaceSDF<T>::localClassify(const OrientedBox<T>&, BoxHint*) const;
CUTWATER_DEFINE(float)
CUTWATER_DEFINE(double)
#undef CUTWATER_DEFINE

}  // namespace cutwater
