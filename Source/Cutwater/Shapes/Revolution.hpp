#pragma once

#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>
#include <Cutwater/Shapes/Polygon.hpp>

#include <memory>

namespace cutwater {

namespace detail {
template <std::floating_point T>
class PolygonDistance;
}  // namespace detail

/// A polygon revolved about an axis: x in the polygon is the distance from the axis, y the position
/// along it. The axis need not have unit length; the default is the local z axis.
///
/// Exact. The profile's edges on the axis lie inside the solid and are ignored. The time of a query
/// grows with the logarithm of the number of edges.
/// @throws Error unless x >= 0 at all corners, the origin and the axis are finite and the axis is
/// not zero.
template <std::floating_point T>
class Revolution final : public Axisymmetric<T> {
 public:
  explicit Revolution(const Polygon<T>& profile) : Revolution(profile, {}, {0, 0, 1}) {}
  Revolution(const Polygon<T>& profile, const Vec3<T>& origin, const Vec3<T>& axis);

 private:
  std::string localName() const override { return "Revolution"; }
  T profileDistance(const ProfilePoint<T>& p) const override;
  ProfilePoint<T> profileGradient(const ProfilePoint<T>& p) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  std::shared_ptr<const detail::PolygonDistance<T>> profile_;  // copies share it
  Box<T> box_;
};

extern template class Revolution<float>;
extern template class Revolution<double>;

}  // namespace cutwater
