#include <Cutwater/Core/OrientedBox.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// A power of two; in this unit squares of the lengths neither overflow nor underflow.
template <std::floating_point T>
T unitFor(const std::array<Vec3<T>, 3>& lengths) {
  const T longest = maxComponent(max(abs(lengths[0]), max(abs(lengths[1]), abs(lengths[2]))));
  constexpr T kLarge = sizeof(T) == sizeof(float) ? T(0x1p60) : T(0x1p500);
  return longest > kLarge ? kLarge : longest < 1 / kLarge ? 1 / kLarge : T(1);
}

}  // namespace

template <std::floating_point T>
OrientedBox<T> OrientedBox<T>::of(const Box<T>& box) {
  const Vec3<T> half = T(0.5) * box.upper - T(0.5) * box.lower;
  OrientedBox result;
  result.center = box.center();
  result.halfAxis = {Vec3<T>{half.x, 0, 0}, Vec3<T>{0, half.y, 0}, Vec3<T>{0, 0, half.z}};
  // The centre, the half lengths and their sums each round by an ulp of the box's coordinates.
  result.slack =
      4 * std::numeric_limits<T>::epsilon() * length(max(abs(box.lower), abs(box.upper)));
  return result;
}

template <std::floating_point T>
T OrientedBox<T>::innerRadius() const {
  // The half axes are orthogonal.
  const T unit = unitFor(halfAxis);
  const auto squared = [unit](const Vec3<T>& half) { return lengthSquared(half / unit); };
  const T least = std::min({squared(halfAxis[0]), squared(halfAxis[1]), squared(halfAxis[2])});
  return unit * std::sqrt(least) * (1 - 8 * std::numeric_limits<T>::epsilon());
}

template <std::floating_point T>
T OrientedBox<T>::radius() const {
  const T unit = unitFor(halfAxis);
  T squared = 0;
  for (const auto& half : halfAxis) squared += lengthSquared(half / unit);
  return unit * std::sqrt(squared) * (1 + 8 * std::numeric_limits<T>::epsilon()) + slack;
}

template <std::floating_point T>
Interval<T> OrientedBox<T>::distancesFrom(const Vec3<T>& p) const {
  const Vec3<T> d = p - center;
  Vec3<T> rest = d;  // across axes of zero length
  T nearest = 0;
  T farthest = 0;
  for (const auto& half : halfAxis) {
    const T extent = length(half);
    if (!(extent > 0)) continue;
    const Vec3<T> axis = half / extent;
    const T along = dot(d, axis);
    rest = rest - along * axis;
    const T beyond = std::max(std::abs(along) - extent, T(0));
    const T across = std::abs(along) + extent;
    nearest += beyond * beyond;
    farthest += across * across;
  }
  const T beside = lengthSquared(rest);
  const T rounding = slack + 16 * std::numeric_limits<T>::epsilon() * (length(d) + radius());
  return {std::max(std::sqrt(nearest + beside) - rounding, T(0)),
          std::sqrt(farthest + beside) + rounding};
}

template <std::floating_point T>
Vec3<T> OrientedBox<T>::corner(int i) const {
  Vec3<T> result = center;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& half = halfAxis[static_cast<std::size_t>(axis)];
    result += (i >> axis & 1) != 0 ? half : -half;
  }
  return result;
}

template <std::floating_point T>
Box<T> OrientedBox<T>::bounds() const {
  const T twice = 1 + 4 * std::numeric_limits<T>::epsilon();
  const Vec3<T> reach = twice * (abs(halfAxis[0]) + abs(halfAxis[1]) + abs(halfAxis[2]));
  // The sums themselves round by an ulp of the centre, for which `slack` has room.
  return Box<T>{center - reach, center + reach}.grown(slack);
}

template <std::floating_point T>
bool OrientedBox<T>::isWithin(const Box<T>& domain) const {
  if (domain == Box<T>::everywhere()) return true;
  return domain.covers(bounds());
}

template struct OrientedBox<float>;
template struct OrientedBox<double>;

}  // namespace cutwater
