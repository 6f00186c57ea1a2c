#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater {

/// A ring: a tube of radius `minor` around a circle of radius `major`. With x the position along
/// the axis from the circle's centre and y the distance from the axis,
///
///     f(p) = |(y - major, x)| - minor        exact
///
/// The axis need not have unit length; the default is the local z axis through the origin.
/// @throws Error unless 0 < minor < major < infinity, all are finite and the axis is not zero.
template <std::floating_point T>
class Torus final : public Axisymmetric<T> {
 public:
  Torus(T major, T minor) : Torus({}, {0, 0, 1}, major, minor) {}
  Torus(const Vec3<T>& center, const Vec3<T>& axis, T major, T minor);

 private:
  std::string localName() const override { return "Torus"; }
  T profileDistance(const ProfilePoint<T>& p) const override;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const override;
  std::optional<T> localConcavity(const OrientedBox<T>& box) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  T major_;
  T minor_;
};

extern template class Torus<float>;
extern template class Torus<double>;

}  // namespace cutwater
