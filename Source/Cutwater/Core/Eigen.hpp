#pragma once

// Optional: for programs that use Eigen. The library's own interface does not, because Eigen's
// headers cost a second to parse and its types change their layout with the user's flags.

#include <Cutwater/Core/RigidTransform.hpp>

#include <Eigen/Geometry>

namespace cutwater {

/// Eigen vectors convert to Vec3 by themselves; this is the way back.
template <std::floating_point T>
[[nodiscard]] Eigen::Matrix<T, 3, 1> toEigen(const Vec3<T>& v) {
  return {v.x, v.y, v.z};
}

/// World from local coordinates.
template <std::floating_point T>
[[nodiscard]] Eigen::Transform<T, 3, Eigen::Isometry> toEigen(const RigidTransform<T>& transform) {
  Eigen::Transform<T, 3, Eigen::Isometry> result;
  result.setIdentity();
  for (int i = 0; i < 3; ++i) result.linear().col(i) = toEigen(transform.axis(i));
  result.translation() = toEigen(transform.offset());
  return result;
}

}  // namespace cutwater
