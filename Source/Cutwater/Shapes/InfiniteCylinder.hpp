#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater {

/// An infinite cylinder around the line through `point` along `axis`.
///
///     f(p) = y - radius        exact; y is the distance from the axis
///
/// The axis need not have unit length.
/// @throws Error unless all are finite, the axis is not zero and the radius is positive.
template <std::floating_point T>
class InfiniteCylinder final : public Axisymmetric<T> {
 public:
  InfiniteCylinder(const Vec3<T>& point, const Vec3<T>& axis, T radius);

 private:
  std::string localName() const override { return "Infinite cylinder"; }
  T profileDistance(const ProfilePoint<T>& p) const override;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  T radius_;
};

extern template class InfiniteCylinder<float>;
extern template class InfiniteCylinder<double>;

}  // namespace cutwater
