#pragma once

#include <Cutwater/Core/OrientedBox.hpp>
#include <Cutwater/Sdf/Guarantee.hpp>

#include <optional>

namespace cutwater::detail {

/// See SignedDistanceFunction::localConcavity(): of the distance to a circle, or to part of one. In
/// the half-plane of a point it is the distance to a point, which is convex; along the circle, at
/// the distance y from its axis, the second derivative is at least -1/y. `toAxis`: y at the centre
/// of the box. None if the box may reach the axis.
template <std::floating_point T>
[[nodiscard]] std::optional<T> concavityAround(T toAxis, const OrientedBox<T>& box,
                                               const Guarantee<T>& guarantee) {
  const T radius = box.radius();
  const T least = toAxis - radius - guarantee.error(length(box.center) + radius);
  if (!(least > 0)) return {};
  return (1 + 4 * std::numeric_limits<T>::epsilon()) / least;
}

}  // namespace cutwater::detail
