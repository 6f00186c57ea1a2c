#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Mesh/Detail/TriangleSurfaceSDF.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Triangles/QueryBox.hpp>

#include <algorithm>
#include <cmath>

// Box queries of meshes.

namespace cutwater {

namespace {

// Words of a hint: the class plus one of all boxes within; the location of their triangles.
constexpr std::size_t kKnown = 0;
constexpr std::size_t kPlace = 1;

}  // namespace

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
  const double far = maxComponent(abs(result.center));
  // Cheaper than the radius, which is smaller.
  double size = result.slack;
  for (const auto& half : result.halfAxis) size += 2 * maxComponent(abs(half));
  if (far + size < kTooLarge) return result;
  if (!(far + result.radius() < kTooLarge)) return {};
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
  // The distance to the triangles changes at most as fast as the point moves, and is at most that
  // to any one of their points; the sign is whatever its own bound allows.
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
    // Farther away the ball around the box is as good, and more triangles would compete.
    constexpr T kFar = 4;
    if (distance > box.innerRadius() && distance < kFar * box.radius()) {
      least =
          std::max(least, static_cast<T>(gapTo(*q, scale * double{distance}) / scale) - rounding);
    }
  }
  if (least > 0 && hasNoJump(box.bounds())) {
    return hit.distance < 0 ? Interval<T>{-most, -least} : Interval<T>{least, most};
  }
  if (signJumps_) return {-most, most};
  return {std::max(range.lower, -most), std::min(range.upper, most)};
}

template <std::floating_point T>
std::optional<BoxClass> TriangleSurfaceSDF<T>::classUnlessClear(const OrientedBox<T>& box,
                                                                BoxHint* hint) const {
  BoxHint none;
  auto& words = (hint != nullptr ? hint : &none)->words;
  if (words[kKnown] != 0) return static_cast<BoxClass>(words[kKnown] - 1);
  const auto q = scaled(box);
  const auto overlap = q ? overlapWith(*q, words[kPlace]) : BoxOverlap::Possible;
  if (overlap == BoxOverlap::Certain && signs_.isSound()) return BoxClass::Cut;
  if (overlap == BoxOverlap::None && isJumpFree(q->bounds())) return {};
  if (overlap == BoxOverlap::Possible && q && signs_.isSound() && QueryBox(*q).hasInside()) {
    return BoxClass::Unknown;  // only touched, within rounding: no value in it could tell more
  }
  return SignedDistanceFunction<T>::localClassify(box, hint);
}

template <std::floating_point T>
BoxClass TriangleSurfaceSDF<T>::classOfClear(const OrientedBox<T>& box, const Vec3<T>& p,
                                             const Nearest& nearest, BoxHint* hint) const {
  const auto found = side(p, nearest) < 0 ? BoxClass::Inside : BoxClass::Outside;
  if (hint == nullptr || signJumps_) return found;
  // Boxes within this one get the same class if there is room even for their rounding.
  const auto q = scaled(box);
  const double room = std::sqrt(double{nearest.distanceSquared}) - 8 * double{nearest.error};
  const double rounding = 4 * q->slack + 0x1p-40 * (1 + maxComponent(abs(q->center)));
  if (room > 1.01 * q->radius() + rounding) {
    hint->words[kKnown] = static_cast<std::uint32_t>(found) + 1;
  }
  return found;
}

template <std::floating_point T>
BoxClass TriangleSurfaceSDF<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  if (const auto known = classUnlessClear(box, hint)) return *known;
  const Vec3<T> p = scaled(box.center);
  return classOfClear(box, p, nearest(p), hint);
}

template <std::floating_point T>
void TriangleSurfaceSDF<T>::localClasses(std::span<const OrientedBox<T>> boxes,
                                         std::span<BoxClass> classes,
                                         std::span<BoxHint> hints) const {
  const auto hint = [&](std::size_t i) { return hints.empty() ? nullptr : &hints[i]; };
  // Boxes that no triangle meets; their signs are queried together.
  Scratch<std::size_t, kBatch> clear;
  Scratch<Vec3<T>, kBatch> p;
  Scratch<Nearest, kBatch> nearest;
  for (std::size_t begin = 0; begin < boxes.size(); begin += kBatch) {
    const auto end = std::min(begin + kBatch, boxes.size());
    std::size_t count = 0;
    for (auto i = begin; i < end; ++i) {
      if (const auto known = classUnlessClear(boxes[i], hint(i))) {
        classes[i] = *known;
      } else {
        clear[count] = i;
        p[count++] = scaled(boxes[i].center);
      }
    }
    this->nearest(p.first(count), nearest.first(count));
    for (std::size_t k = 0; k < count; ++k) {
      const auto i = clear[k];
      classes[i] = classOfClear(boxes[i], p[k], nearest[k], hint(i));
    }
  }
}

// The rest of the class is instantiated where it is defined.
#define CUTWATER_DEFINE(T)                                                                        \
  template auto TriangleSurfaceSDF<T>::scaled(const OrientedBox<T>&)                              \
      const->std::optional<OrientedBox<double>>;                                                  \
  template double TriangleSurfaceSDF<T>::gapTo(const OrientedBox<double>&, double) const;         \
  template Interval<T> TriangleSurfaceSDF<T>::localBounds(const OrientedBox<T>&, BoxHint*) const; \
  template std::optional<BoxClass> TriangleSurfaceSDF<T>::classUnlessClear(const OrientedBox<T>&, \
                                                                           BoxHint*) const;       \
  template BoxClass TriangleSurfaceSDF<T>::classOfClear(const OrientedBox<T>&, const Vec3<T>&,    \
                                                        const Nearest&, BoxHint*) const;          \
  template BoxClass TriangleSurfaceSDF<T>::localClassify(const OrientedBox<T>&, BoxHint*) const;
CUTWATER_DEFINE(float)
CUTWATER_DEFINE(double)
#undef CUTWATER_DEFINE
template void TriangleSurfaceSDF<float>::localClasses(std::span<const OrientedBox<float>>,
                                                      std::span<BoxClass>,
                                                      std::span<BoxHint>) const;
template void TriangleSurfaceSDF<double>::localClasses(std::span<const OrientedBox<double>>,
                                                       std::span<BoxClass>,
                                                       std::span<BoxHint>) const;

}  // namespace cutwater
