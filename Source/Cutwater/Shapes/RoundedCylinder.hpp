#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater {

/// A cylinder with ends at `a` and `b` whose rims are rounded to the radius `rounding`; the ends
/// and the side stay in place.
///
///     f(p) = cylinder(p; shortened by rounding at both ends, radius - rounding) - rounding exact
///
/// @throws Error unless the end points are finite and differ, 0 < radius < infinity, and
/// 0 < rounding <= min(radius, |b - a| / 2).
template <std::floating_point T>
class RoundedCylinder final : public Axisymmetric<T> {
 public:
  RoundedCylinder(const Vec3<T>& a, const Vec3<T>& b, T radius, T rounding);

 private:
  std::string localName() const override { return "Rounded cylinder"; }
  T profileDistance(const ProfilePoint<T>& p) const override;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  T length_;
  T rounding_;
  T coreRadius_;
  T size_;
  Box<T> section_;  // of the core that is grown by the rounding; may have zero thickness
};

extern template class RoundedCylinder<float>;
extern template class RoundedCylinder<double>;

}  // namespace cutwater
