#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>
#include <Cutwater/Shapes/Detail/RotationAxis.hpp>

namespace cutwater {

/// Base class of all bodies of revolution: a subclass defines the signed distance in the half-plane
/// radial >= 0 beside its axis, and this class revolves it about an axis anywhere in space.
///
/// The revolved value is the exact distance wherever that of the profile is, because the nearest
/// point of a body of revolution lies in the half-plane of the query point.
template <std::floating_point T>
class Axisymmetric : public SignedDistanceFunction<T> {
 protected:
  /// Axial positions are measured from `origin` along `axis`, which need not have unit length.
  /// @throws Error naming the shape `name` unless both are finite and the axis is not zero.
  Axisymmetric(const char* name, const Vec3<T>& origin, const Vec3<T>& axis)
      : axis_(name, origin, axis) {}
  explicit Axisymmetric(const detail::RotationAxis<T>& axis) : axis_(axis) {}

  /// The signed distance of the profile in the half-plane.
  [[nodiscard]] virtual T profileDistance(const ProfilePoint<T>& p) const = 0;
  /// Unit gradient in the half-plane; zero where it is not defined.
  [[nodiscard]] virtual ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const = 0;

  [[nodiscard]] const Vec3<T>& origin() const { return axis_.origin(); }
  /// Unit vector along the axis.
  [[nodiscard]] const Vec3<T>& axis() const { return axis_.direction(); }
  [[nodiscard]] const detail::RotationAxis<T>& rotationAxis() const { return axis_; }

 private:
  T localSignedDistance(const Vec3<T>& p) const final;
  Vec3<T> localGradient(const Vec3<T>& p) const final;

  detail::RotationAxis<T> axis_;
};

extern template class Axisymmetric<float>;
extern template class Axisymmetric<double>;

}  // namespace cutwater
