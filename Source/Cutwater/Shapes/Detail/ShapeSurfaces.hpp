#pragma once

#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Detail/Axisymmetric.hpp>
#include <Cutwater/Shapes/InfiniteCone.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>

#include <cmath>
#include <numbers>
#include <span>

namespace cutwater::detail {

/// Visits the plane of a face, for localSurfacesIn().
template <std::floating_point T>
void visitPlane(const Vec3<T>& point, const Vec3<T>& normal, SurfaceVisitor<T> visit) {
  visit(Plane<T>(point, normal), nullptr);
}

/// Visits the planes of all sides of a box.
template <std::floating_point T>
void visitSides(const Box<T>& box, SurfaceVisitor<T> visit) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3<T> normal;
    normal[axis] = 1;
    visitPlane(box.lower, -normal, visit);
    visitPlane(box.upper, normal, visit);
  }
}

/// Visits the surface that an edge of a profile is part of when it is revolved: a plane, a cylinder
/// or a cone. Nothing, for an edge on the axis.
template <std::floating_point T>
void visitRevolved(const RotationAxis<T>& axis, const ProfilePoint<T>& a, const ProfilePoint<T>& b,
                   SurfaceVisitor<T> visit) {
  const auto& direction = axis.direction();
  const auto at = [&](T axial) { return axis.origin() + axial * direction; };
  if (a.axial == b.axial) return visitPlane(at(a.axial), direction, visit);
  if (a.radial == b.radial) {
    if (a.radial > 0) visit(InfiniteCylinder<T>(axis.origin(), direction, a.radial), nullptr);
    return;
  }
  const T height = (b.axial - a.axial) / (b.radial - a.radial);  // along the axis, by radius
  const T apex = a.axial - height * a.radial;
  const T angle = std::atan(1 / std::abs(height)) * 180 / std::numbers::pi_v<T>;
  visit(InfiniteCone<T>(at(apex), height > 0 ? direction : -direction, angle), nullptr);
}

/// Visits those of all edges of a profile between its corners, the first of which is next to the
/// last.
template <std::floating_point T>
void visitRevolved(const RotationAxis<T>& axis, std::span<const ProfilePoint<T>> corners,
                   SurfaceVisitor<T> visit) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    visitRevolved(axis, corners[i], corners[(i + 1) % corners.size()], visit);
  }
}

}  // namespace cutwater::detail
