#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>
#include <Cutwater/Shapes/Detail/FrustumProfile.hpp>

namespace cutwater {

/// A cone with flat ends (a frustum): radius `radiusA` at `a`, `radiusB` at `b`. For the hull of
/// two balls see ConeSphere.
///
/// Exact; see FrustumProfile.
/// @throws Error unless the end points are finite and differ, both radii are finite and not
/// negative, and one of them is positive.
template <std::floating_point T>
class CappedCone final : public Axisymmetric<T> {
 public:
  CappedCone(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB);

 private:
  std::string localName() const override { return "Capped cone"; }
  T profileDistance(const ProfilePoint<T>& p) const override;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  detail::FrustumProfile<T> profile_;
  T size_;
};

extern template class CappedCone<float>;
extern template class CappedCone<double>;

}  // namespace cutwater
