#pragma once

#include <Cutwater/Shapes/Detail/Profiles.hpp>

namespace cutwater {

/// A cone with flat ends (a frustum): radius `radiusA` at `a`, `radiusB` at `b`. For the hull of
/// two balls see ConeSphere.
///
/// Exact: inside, the nearest of the three sides decides; outside, the flank where the foot of the
/// perpendicular is on it, and otherwise the nearer end disc.
/// @throws Error unless the end points are finite and differ, both radii are finite and not
/// negative, and one of them is positive.
template <std::floating_point T>
class CappedCone final : public ProfiledShape<T, detail::FrustumProfile<T>> {
 public:
  CappedCone(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB);

 private:
  std::string localName() const override { return "Capped cone"; }
};

extern template class ProfiledShape<float, detail::FrustumProfile<float>>;
extern template class ProfiledShape<double, detail::FrustumProfile<double>>;
extern template class CappedCone<float>;
extern template class CappedCone<double>;

}  // namespace cutwater
