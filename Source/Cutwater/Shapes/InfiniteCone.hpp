#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater {

/// An infinite cone: all points seen from the apex within `halfAngle` degrees of the axis.
///
///     f(p) = y cos(halfAngle) - x sin(halfAngle)     where x cos(halfAngle) + y sin(halfAngle) > 0
///            |p - apex|                              elsewhere        exact
///
/// with x along the axis from the apex and y the distance from it.
///
/// The axis points from the apex into the solid and need not have unit length.
/// @throws Error unless all are finite, the axis is not zero and 0 < halfAngle < 90.
template <std::floating_point T>
class InfiniteCone final : public Axisymmetric<T> {
 public:
  InfiniteCone(const Vec3<T>& apex, const Vec3<T>& axis, T halfAngle);

 private:
  std::string localName() const override { return "Infinite cone"; }
  T profileDistance(const ProfilePoint<T>& p) const override;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  [[nodiscard]] bool isBesideFlank(const ProfilePoint<T>& p) const;

  T sine_;
  T cosine_;
};

extern template class InfiniteCone<float>;
extern template class InfiniteCone<double>;

}  // namespace cutwater
