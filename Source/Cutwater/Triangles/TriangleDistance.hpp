#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Sdf/SurfacePoint.hpp>

#include <array>

namespace cutwater {

/// The part of a triangle that a closest point lies on.
enum class TrianglePart : std::uint8_t { VertexA, VertexB, VertexC, EdgeAB, EdgeBC, EdgeCA, Face };

/// Returns whether the part is a vertex, an edge or the face.
[[nodiscard]] Feature featureOf(TrianglePart part);

/// The distance to a triangle, and the part of it that is nearest.
template <std::floating_point T>
struct TriangleHit {
  T distanceSquared = std::numeric_limits<T>::infinity();
  TrianglePart part = TrianglePart::Face;
};

/// Three corners, counter-clockwise seen from outside.
template <std::floating_point T>
struct Triangle {
  Vec3<T> a, b, c;
  /// Twice the area is less than a tenth of the longest edge's square (or this cannot be decided):
  /// steps that suffer from cancellation are then done in twice the precision. Set it with
  /// isSliver().
  bool sliver = false;

  /// Corner 0, 1 or 2.
  [[nodiscard]] const Vec3<T>& vertex(int i) const { return i == 0 ? a : i == 1 ? b : c; }
};

/// See Triangle::sliver.
template <std::floating_point T>
[[nodiscard]] bool isSliver(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c);

/// Squared distance from `p` to the triangle: the least of the squared distances to its three edges
/// and, where the projection falls strictly inside, to its plane.
///
/// The square root is within 8 eps (|p| + |V|max) of the true distance, even for slivers; methods
/// that take regions from barycentric coordinates, and Ericson's, do not achieve this. Squares of
/// coordinates must neither over- nor underflow: scale by a power of two first.
template <std::floating_point T>
[[nodiscard]] TriangleHit<T> triangleDistance(const Vec3<T>& p, const Triangle<T>& triangle);

/// Weights of the vertices for the closest point that triangleDistance() found; their sum is 1.
template <std::floating_point T>
[[nodiscard]] Vec3<T> closestBarycentric(const Vec3<T>& p, const Triangle<T>& triangle,
                                         TrianglePart part);

/// The unit normal of the oriented triangle; zero for one without area.
template <std::floating_point T>
[[nodiscard]] Vec3<T> unitNormal(const Triangle<T>& triangle);

/// The side of the triangle's plane on which `p` lies: the sign of (p - v) . n, where v is the
/// nearest vertex.
template <std::floating_point T>
[[nodiscard]] int sideOfPlane(const Vec3<T>& p, const Triangle<T>& triangle);

}  // namespace cutwater
