#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Interval.hpp>

/// The exact signed distance of an axis-aligned box, shared by the cuboid and the rounded box.
///
///     d_i = max(lower_i - p_i, p_i - upper_i)
///     f(p) = |max(d, 0)| + min(max_i d_i, 0)
namespace cutwater::detail {

template <std::floating_point T>
[[nodiscard]] T boxDistance(const Box<T>& box, const Vec3<T>& p);

/// The range of the distance over another such box: it grows away from the middle on each axis.
template <std::floating_point T>
[[nodiscard]] Interval<T> boxDistances(const Box<T>& box, const Box<T>& range);

/// The gradient; zero where it is not defined: on edges, and inside where several faces are equally
/// near.
template <std::floating_point T>
[[nodiscard]] Vec3<T> boxGradient(const Box<T>& box, const Vec3<T>& p);

/// The section radial <= `radius`, lower <= axial <= upper of a cylinder as a box, to be queried at
/// the point (radial, axial, 0).
template <std::floating_point T>
[[nodiscard]] Box<T> rectangle(T radius, T lower, T upper) {
  return {{-radius, lower, -Box<T>::kInf}, {radius, upper, Box<T>::kInf}};
}

}  // namespace cutwater::detail
