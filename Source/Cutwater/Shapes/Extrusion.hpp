#pragma once

#include <Cutwater/Shapes/Detail/Prismatic.hpp>
#include <Cutwater/Shapes/Polygon.hpp>

#include <memory>

namespace cutwater {

namespace detail {
template <std::floating_point T>
class PolygonDistance;
}  // namespace detail

/// A polygon in the xy plane, extruded along z: a prism with any cross-section.
///
/// Exact. The time of a query grows with the logarithm of the number of edges.
/// @throws Error unless lower and upper are finite and lower < upper.
template <std::floating_point T>
class Extrusion final : public Prismatic<T> {
 public:
  /// The prism from z = lower to z = upper.
  Extrusion(const Polygon<T>& section, T lower, T upper);

 private:
  std::string localName() const override { return "Extrusion"; }
  T sectionDistance(const Vec2<T>& p) const override;
  Vec2<T> sectionGradient(const Vec2<T>& p) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  std::shared_ptr<const detail::PolygonDistance<T>> section_;  // copies share it
};

extern template class Extrusion<float>;
extern template class Extrusion<double>;

}  // namespace cutwater
