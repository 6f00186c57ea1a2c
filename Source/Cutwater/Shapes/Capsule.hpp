#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>
#include <Cutwater/Shapes/Detail/CapsuleProfile.hpp>

namespace cutwater {

/// All points within `radius` of the segment from `a` to `b`: a cylinder with hemispherical ends; a
/// ball if a = b.
///
///     f(p) = |p - nearest point of the segment| - radius        exact
///
/// @throws Error unless the end points are finite and 0 < radius < infinity.
template <std::floating_point T>
class Capsule final : public Axisymmetric<T> {
 public:
  Capsule(const Vec3<T>& a, const Vec3<T>& b, T radius);

 private:
  std::string localName() const override { return "Capsule"; }
  T profileDistance(const ProfilePoint<T>& p) const override;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  detail::CapsuleProfile<T> profile_;
  T size_;
};

extern template class Capsule<float>;
extern template class Capsule<double>;

}  // namespace cutwater
