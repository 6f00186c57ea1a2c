#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>
#include <Cutwater/Shapes/Detail/FrustumProfile.hpp>

namespace cutwater {

/// A cone with its apex at `apex` and a flat base around `base`: a CappedCone with one radius zero.
///
/// Exact. @throws Error unless the points are finite and differ, and 0 < radius < infinity.
template <std::floating_point T>
class Cone final : public Axisymmetric<T> {
 public:
  Cone(const Vec3<T>& apex, const Vec3<T>& base, T radius);

 private:
  std::string localName() const override { return "Cone"; }
  T profileDistance(const ProfilePoint<T>& p) const override;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  detail::FrustumProfile<T> profile_;
  T size_;
};

extern template class Cone<float>;
extern template class Cone<double>;

}  // namespace cutwater
