#pragma once

// Optional, for programs that use Eigen. The library's own interface does not use it, because
// Eigen's headers take a second to parse and its types change their layout with the user's flags.

#include <Cutwater/Core/RigidTransform.hpp>

#include <Eigen/Geometry>

namespace cutwater {

/// The Eigen vector of a Vec3. In the other direction conversion is implicit.
template <std::floating_point T>
[[nodiscard]] Eigen::Matrix<T, 3, 1> toEigen(const Vec3<T>& v) {
  return {v.x, v.y, v.z};
}

/// The transformation from local to world coordinates.
template <std::floating_point T>
[[nodiscard]] Eigen::Transform<T, 3, Eigen::Isometry> toEigen(const RigidTransform<T>& transform) {
  Eigen::Transform<T, 3, Eigen::Isometry> result;
  result.setIdentity();
  for (int i = 0; i < 3; ++i) result.linear().col(i) = toEigen(transform.axis(i));
  result.translation() = toEigen(transform.offset());
  return result;
}

}  // namespace cutwater
