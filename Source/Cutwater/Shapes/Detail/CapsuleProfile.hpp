#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater::detail {

/// Exact signed distance in the half-plane of a capsule, i.e. of all points within `radius` of the
/// axis from 0 to the length.
///
///     f(p) = |p - nearest point of the segment| - radius
template <std::floating_point T>
class CapsuleProfile {
 public:
  /// The profile of the capsule from a to b.
  /// @throws Error naming the shape `name` unless 0 < radius < infinity.
  CapsuleProfile(const char* name, const Vec3<T>& a, const Vec3<T>& b, T radius);

  [[nodiscard]] T distance(const ProfilePoint<T>& p) const;
  [[nodiscard]] ProfilePoint<T> gradient(const ProfilePoint<T>& p) const;
  /// The box around the body of revolution, as computed.
  [[nodiscard]] Box<T> box(const RotationAxis<T>& axis) const;
  [[nodiscard]] T largestRadius() const { return radius_; }

 private:
  [[nodiscard]] ProfilePoint<T> fromSegment(const ProfilePoint<T>& p) const;

  T length_;
  T radius_;
};

extern template class CapsuleProfile<float>;
extern template class CapsuleProfile<double>;

}  // namespace cutwater::detail
