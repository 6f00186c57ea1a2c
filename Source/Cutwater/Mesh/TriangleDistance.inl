#pragma once

// The arithmetic behind TriangleDistance.hpp, for the library's own hot loops. Included by .cpp
// files only, so that it is always compiled with the library's flags.

#include <Cutwater/Core/DoubleDouble.hpp>
#include <Cutwater/Mesh/TriangleDistance.hpp>

#include <cmath>

namespace cutwater::detail {

// Two kinds of arithmetic for one algorithm: that of T, and one with about twice the digits.

template <std::floating_point T>
struct Plain {
  using Scalar = T;
  using Vector = Vec3<T>;
  static Vector difference(const Vec3<T>& a, const Vec3<T>& b) { return a - b; }
};

template <std::floating_point T>
struct Wide;
template <>
struct Wide<float> {
  using Scalar = double;
  using Vector = Vec3<double>;
  static Vector difference(const Vec3<float>& a, const Vec3<float>& b) {
    return Vec3<double>(a) - Vec3<double>(b);
  }
};
template <>
struct Wide<double> {
  using Scalar = DoubleDouble;
  using Vector = DoubleDouble3;
  static Vector difference(const Vec3<double>& a, const Vec3<double>& b) {
    return DoubleDouble3::difference(a, b);
  }
};

/// The triangle's plane: normal of twice the area's length.
template <typename Arithmetic, typename T>
auto planeNormal(const Triangle<T>& t) {
  return cross(Arithmetic::difference(t.a, t.c), Arithmetic::difference(t.b, t.a));
}

/// The vertex nearest to p: the base point from which differences lose the fewest digits.
template <std::floating_point T>
int nearestVertex(const Vec3<T>& p, const Triangle<T>& t) {
  const T a = lengthSquared(p - t.a);
  const T b = lengthSquared(p - t.b);
  const T c = lengthSquared(p - t.c);
  return a <= b && a <= c ? 0 : b <= c ? 1 : 2;
}

/// Squared distance to the plane, if the projection lies strictly inside the triangle; else
/// infinity.
template <typename Arithmetic, typename T>
T planeDistanceSquared(const Vec3<T>& p, const Triangle<T>& t, int base) {
  using Scalar = typename Arithmetic::Scalar;
  const auto normal = planeNormal<Arithmetic>(t);
  const auto isInside = [&](const Vec3<T>& from, const Vec3<T>& to) {
    const auto side = cross(Arithmetic::difference(to, from), Arithmetic::difference(p, from));
    return dot(side, normal) > Scalar(0);
  };
  if (!isInside(t.a, t.b) || !isInside(t.b, t.c) || !isInside(t.c, t.a)) {
    return std::numeric_limits<T>::infinity();
  }
  // Of a triangle this small, squares of areas underflow; its edges are as near as its plane.
  const Scalar normalSquared = dot(normal, normal);
  constexpr T kLeast = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();
  if (!(normalSquared > Scalar(kLeast))) return std::numeric_limits<T>::infinity();
  // Not the square of the height over that: it would underflow before the quotient does.
  const Scalar height = dot(normal, Arithmetic::difference(p, t.vertex(base)));
  return static_cast<T>(height / normalSquared * height);
}

/// Squared distance to the edge (from, to); `fromPart`, `toPart`: its ends' names.
///
/// Symmetric in the ends, but for exact ties, so that both triangles at an edge find the same bits.
template <std::floating_point T>
TriangleHit<T> edgeDistance(const Vec3<T>& p, const Vec3<T>& from, const Vec3<T>& to,
                            TrianglePart fromPart, TrianglePart toPart, TrianglePart edgePart) {
  const Vec3<T> edge = to - from;
  const Vec3<T> p0 = p - from;
  const Vec3<T> p1 = p - to;
  const T along = dot(edge, p0);
  if (!(along > 0)) return {lengthSquared(p0), fromPart};
  const T back = -dot(edge, p1);
  if (!(back > 0)) return {lengthSquared(p1), toPart};
  // From the nearer end: the part along the edge is removed from the shorter vector.
  const T edgeSquared = lengthSquared(edge);
  const Vec3<T> rejected =
      along <= back ? p0 - (along / edgeSquared) * edge : p1 + (back / edgeSquared) * edge;
  return {lengthSquared(rejected), edgePart};
}

template <std::floating_point T>
TriangleHit<T> triangleHit(const Vec3<T>& p, const Triangle<T>& t) {
  using enum TrianglePart;
  auto best = edgeDistance(p, t.a, t.b, VertexA, VertexB, EdgeAB);
  const auto bc = edgeDistance(p, t.b, t.c, VertexB, VertexC, EdgeBC);
  const auto ca = edgeDistance(p, t.c, t.a, VertexC, VertexA, EdgeCA);
  if (bc.distanceSquared < best.distanceSquared) best = bc;
  if (ca.distanceSquared < best.distanceSquared) best = ca;
  const int base = nearestVertex(p, t);
  const T plane = t.sliver ? planeDistanceSquared<Wide<T>>(p, t, base)
                           : planeDistanceSquared<Plain<T>>(p, t, base);
  if (plane <= best.distanceSquared) best = {plane, Face};
  return best;
}

}  // namespace cutwater::detail
