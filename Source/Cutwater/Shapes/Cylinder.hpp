#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>

namespace cutwater {

/// A cylinder with flat ends at `a` and `b`.
///
///     d = (y - radius, max(-x, x - |b - a|))        x along the axis from a, y from the axis
///     f(p) = |max(d, 0)| + min(max_i d_i, 0)        exact
///
/// @throws Error unless the end points are finite and differ, and 0 < radius < infinity.
template <std::floating_point T>
class Cylinder final : public Axisymmetric<T> {
 public:
  Cylinder(const Vec3<T>& a, const Vec3<T>& b, T radius);

 private:
  std::string localName() const override { return "Cylinder"; }
  T profileDistance(const ProfilePoint<T>& p) const override;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  T radius_;
  T length_;
  T size_;
  Box<T> section_;
};

extern template class Cylinder<float>;
extern template class Cylinder<double>;

}  // namespace cutwater
