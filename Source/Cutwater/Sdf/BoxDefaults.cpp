#include <Cutwater/Sdf/Detail/BoxDescent.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <algorithm>
#include <array>

// Default answers about boxes.

namespace cutwater {

namespace {

/// The half of a box along each of its axes on one side of its centre: bit i of `side` chooses the
/// upper one. The slack grows by the rounding of the new centre.
template <std::floating_point T>
OrientedBox<T> part(const OrientedBox<T>& box, int side) {
  OrientedBox<T> result = box;
  result.exact.reset();
  for (std::size_t i = 0; i < 3; ++i) {
    result.halfAxis[i] = T(0.5) * box.halfAxis[i];
    result.center += (side >> i & 1) != 0 ? result.halfAxis[i] : -result.halfAxis[i];
  }
  result.slack += 4 * std::numeric_limits<T>::epsilon() * (length(box.center) + box.radius());
  return result;
}

/// The axes along which a box has no thickness, as bits.
template <std::floating_point T>
int flatAxes(const OrientedBox<T>& box) {
  int flat = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (box.halfAxis[i] == Vec3<T>{}) flat |= 1 << i;
  }
  return flat;
}

/// An upper bound of the exact values in the box: f + k |p|^2 / 2, where that is convex, is
/// greatest at a corner.
template <std::floating_point T>
T highestIn(const OrientedBox<T>& box, T concavity, const Guarantee<T>& guarantee,
            FunctionRef<T(const Vec3<T>&)> value) {
  const T radius = box.radius();
  if (!(concavity * radius <= 1)) return std::numeric_limits<T>::infinity();
  T highest = -std::numeric_limits<T>::infinity();
  for (int i = 0; i < 8; ++i) {
    const T atCorner = value(box.corner(i));
    if (std::isnan(atCorner)) return std::numeric_limits<T>::infinity();  // squares overflow
    highest = std::max(highest, atCorner);
  }
  // Of the value, of the corner's place, and of the values to be enclosed.
  constexpr T kRoundings = 8;
  const T rounding = kRoundings * guarantee.error(length(box.center) + radius);
  return highest + T(0.5) * concavity * radius * radius + 2 * box.slack + rounding;
}

}  // namespace

template <std::floating_point T>
std::optional<T> SignedDistanceFunction<T>::localLipschitzIn(const OrientedBox<T>& box) const {
  const auto promise = localGuarantee();
  return box.isWithin(promise.domain) ? promise.lipschitz : std::nullopt;
}

template <std::floating_point T>
Interval<T> SignedDistanceFunction<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  const auto promise = localGuarantee();
  if (!promise.lipschitz || !box.isWithin(promise.domain)) return Interval<T>::everything();
  const T atCenter = localSignedDistance(box.center);
  const auto around = detail::boundsAround(atCenter, box, promise);
  // Farther away the ball around the box is as good.
  constexpr T kFar = 4;
  if (!(std::abs(atCenter) < kFar * box.radius())) return around;
  const auto concavity = localConcavity(box);
  if (!concavity) return around;
  const auto value = [this](const Vec3<T>& p) { return localSignedDistance(p); };
  const auto gradient = [this](const Vec3<T>& p) { return localGradient(p); };
  const auto least = detail::leastIn<T>({value, gradient, promise}, box, atCenter, concavity);
  return {std::max(around.lower, least.lower),
          std::min(around.upper, highestIn<T>(box, *concavity, promise, value))};
}

template <std::floating_point T>
BoxClass SignedDistanceFunction<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto range = localBounds(box, hint);
  if (range.lower > 0) return BoxClass::Outside;
  if (range.upper < 0) return BoxClass::Inside;

  if (!box.isWithin(localGuarantee().domain)) return BoxClass::Unknown;
  return holdsNearestPoint(box) || holdsBothSides(box) ? BoxClass::Cut : classOfUndecided(box);
}

/// Whether the ball about the centre that reaches the nearest surface point fits into the box.
template <std::floating_point T>
bool SignedDistanceFunction<T>::holdsNearestPoint(const OrientedBox<T>& box) const {
  if (!(box.innerRadius() > 0)) return false;
  const auto promise = localGuarantee();
  const T rounding = promise.error(length(box.center) + box.radius());
  const T atCenter = localSignedDistance(box.center);
  const bool sideIsSure = std::abs(atCenter) > rounding || promise.inside == promise.outside;
  const T reach = std::abs(atCenter) + rounding + box.slack;
  return sideIsSure && promise.quality(atCenter) == Quality::Exact && std::isfinite(reach) &&
         reach <= box.innerRadius();
}

/// Whether two of its points are certainly on different sides; jumps count as surface. A corner of
/// this box is within its slack of a corner of the box of the query.
template <std::floating_point T>
bool SignedDistanceFunction<T>::holdsBothSides(const OrientedBox<T>& box) const {
  const int flat = flatAxes(box);
  bool inside = false;
  bool outside = false;
  const auto look = [&](const Vec3<T>& p) {
    const auto around = localBounds({.center = p, .halfAxis = {}, .slack = box.slack}, nullptr);
    inside = inside || around.upper < 0;
    outside = outside || around.lower > 0;
  };
  look(box.center);
  for (const int corner : {0, 7, 1, 6, 2, 5, 3, 4}) {  // opposite ones are rarely on the same side
    if (inside && outside) break;
    if ((corner & flat) == 0) look(box.corner(corner));
  }
  return inside && outside;
}

template <std::floating_point T>
BoxClass SignedDistanceFunction<T>::classOfUndecided(const OrientedBox<T>& box) const {
  if (!localGuarantee().lipschitz) return BoxClass::Unknown;
  const auto concavity = localConcavity(box);
  const auto value = [this](const Vec3<T>& p) { return localSignedDistance(p); };
  if (concavity && highestIn<T>(box, *concavity, localGuarantee(), value) < 0) {
    return BoxClass::Inside;
  }
  const auto found = classByDescent(box, concavity);
  // Parts of the box know no more of a convex function than the box does.
  return found != BoxClass::Unknown || concavity == T(0) ? found : classOfParts(box);
}

/// The class of a box from a descent, or ascent, to the other side from where its centre is: Cut if
/// it certainly arrives there, Outside if there certainly is no other side.
template <std::floating_point T>
BoxClass SignedDistanceFunction<T>::classByDescent(const OrientedBox<T>& box,
                                                   std::optional<T> concavity) const {
  const T atCenter = localSignedDistance(box.center);
  const T side = atCenter < 0 ? T(-1) : T(1);
  const auto value = [&](const Vec3<T>& p) { return side * localSignedDistance(p); };
  const auto gradient = [&](const Vec3<T>& p) { return side * localGradient(p); };
  const auto promise = localGuarantee();
  const detail::Slopes<T> slopes{value, gradient, promise};
  if (side < 0) concavity.reset();
  const auto least = detail::leastIn(slopes, box, side * atCenter, concavity);
  if (least.lower > 0) return BoxClass::Outside;

  // A place found is in the box up to its slack.
  const T certain =
      2 * (promise.error(length(box.center) + box.radius()) + *promise.lipschitz * box.slack);
  if (!(least.upper < -certain)) return BoxClass::Unknown;
  bool hasThisSide = side * atCenter > certain;
  for (int i = 0; i < 8 && !hasThisSide; ++i) hasThisSide = value(box.corner(i)) > certain;
  return hasThisSide ? BoxClass::Cut : BoxClass::Unknown;
}

/// The class of a box from the bounds in its octants and, where these are undecided, in theirs.
template <std::floating_point T>
BoxClass SignedDistanceFunction<T>::classOfParts(const OrientedBox<T>& box) const {
  constexpr int kDepth = 2;
  const int flat = flatAxes(box);
  bool inside = false;
  bool outside = false;
  bool unknown = false;
  // Depth first; the octants of one level wait while one of them is divided.
  struct Level {
    OrientedBox<T> box;
    int next = 0;
  };
  std::array<Level, kDepth> levels{Level{box}};
  for (int depth = 0; depth >= 0 && !(inside && outside);) {
    auto& level = levels[static_cast<std::size_t>(depth)];
    while (level.next < 8 && (level.next & flat) != 0) ++level.next;
    if (level.next == 8) {
      --depth;
      continue;
    }
    const auto octant = part(level.box, level.next++);
    const auto range = localBounds(octant, nullptr);
    if (range.lower > 0) {
      outside = true;
    } else if (range.upper < 0) {
      inside = true;
    } else if (depth + 1 < kDepth) {
      levels[static_cast<std::size_t>(++depth)] = {octant};
    } else {
      unknown = true;
    }
  }
  if (inside && outside) return BoxClass::Cut;
  if (unknown) return BoxClass::Unknown;
  return inside ? BoxClass::Inside : BoxClass::Outside;
}

#define CUTWATER_INSTANTIATE(T)                                                                \
  template std::optional<T> SignedDistanceFunction<T>::localLipschitzIn(const OrientedBox<T>&) \
      const;                                                                                   \
  template Interval<T> SignedDistanceFunction<T>::localBounds(const OrientedBox<T>&, BoxHint*) \
      const;                                                                                   \
  template BoxClass SignedDistanceFunction<T>::localClassify(const OrientedBox<T>&, BoxHint*)  \
      const;                                                                                   \
  template bool SignedDistanceFunction<T>::holdsNearestPoint(const OrientedBox<T>&) const;     \
  template bool SignedDistanceFunction<T>::holdsBothSides(const OrientedBox<T>&) const;        \
  template BoxClass SignedDistanceFunction<T>::classByDescent(const OrientedBox<T>&,           \
                                                              std::optional<T>) const;         \
  template BoxClass SignedDistanceFunction<T>::classOfParts(const OrientedBox<T>&) const;      \
  template BoxClass SignedDistanceFunction<T>::classOfUndecided(const OrientedBox<T>&) const;
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

}  // namespace cutwater
