#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Triangles/TriangleDistance.hpp>

#include <algorithm>
#include <cmath>

#define CUTWATER_SIMD scalar
#define CUTWATER_SIMD_PORTABLE
#include <Cutwater/Triangles/Search/TriangleDistance.inl>

namespace cutwater {

namespace {

// One algorithm in two kinds of arithmetic: that of T, and one with about twice the digits.

template <std::floating_point T>
struct Plain {
  using Scalar = T;
  static Vec3<T> difference(const Vec3<T>& a, const Vec3<T>& b) { return a - b; }
};

template <std::floating_point T>
struct Wide;
template <>
struct Wide<float> {
  using Scalar = double;
  static Vec3<double> difference(const Vec3<float>& a, const Vec3<float>& b) {
    return Vec3<double>(a) - Vec3<double>(b);
  }
};
template <>
struct Wide<double> {
  using Scalar = DoubleDouble;
  static DoubleDouble3 difference(const Vec3<double>& a, const Vec3<double>& b) {
    return DoubleDouble3::difference(a, b);
  }
};

/// A normal of the triangle whose length is twice the area.
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

template <std::floating_point T>
T longestSquared(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  return std::max({lengthSquared(b - a), lengthSquared(c - b), lengthSquared(a - c)});
}

/// scalar::planeDistance() for slivers.
template <std::floating_point T>
T sliverPlaneDistance(const Vec3<T>& p, const Triangle<T>& t) {
  using Arithmetic = Wide<T>;
  using Scalar = typename Arithmetic::Scalar;
  const auto between = [](const Vec3<T>& a, const Vec3<T>& b) {
    return Arithmetic::difference(a, b);
  };
  const scalar::SeenTriangle<decltype(between(p, p))> seen{between(p, t.a),   between(p, t.b),
                                                           between(p, t.c),   between(t.b, t.a),
                                                           between(t.c, t.b), between(t.a, t.c)};
  const auto terms = scalar::planeTerms(seen, between(p, t.vertex(nearestVertex(p, t))));
  // Where a triangle is narrower than a few eps of its length, its edges are as near as its plane,
  // and even this precision may not determine what is inside.
  const T leastArea = 4 * std::numeric_limits<T>::epsilon() * longestSquared(t.a, t.b, t.c);
  const auto isInside = [](Scalar side) { return side > Scalar(0); };
  if (!isInside(terms.sideAB) || !isInside(terms.sideBC) || !isInside(terms.sideCA) ||
      !(terms.normalSquared > Scalar(scalar::kLeastNormalSquared<T>)) ||
      !(terms.normalSquared > Scalar(leastArea) * Scalar(leastArea))) {
    return std::numeric_limits<T>::infinity();
  }
  return static_cast<T>(terms.height / terms.normalSquared * terms.height);
}

template <typename Arithmetic, typename T>
Vec3<T> unitNormalBy(const Triangle<T>& t) {
  const auto n = planeNormal<Arithmetic>(t);
  const auto squared = dot(n, n);
  if (!(squared > typename Arithmetic::Scalar(0))) return {};
  const auto norm = sqrt(squared);
  return {static_cast<T>(n.x / norm), static_cast<T>(n.y / norm), static_cast<T>(n.z / norm)};
}

template <typename Arithmetic, typename T>
int sideBy(const Vec3<T>& p, const Triangle<T>& t) {
  using Scalar = typename Arithmetic::Scalar;
  const auto from = Arithmetic::difference(p, t.vertex(nearestVertex(p, t)));
  const Scalar height = dot(planeNormal<Arithmetic>(t), from);
  return height > Scalar(0) ? 1 : height < Scalar(0) ? -1 : 0;
}

/// Ratios of the areas of (p, b, c) and (a, p, c) to the whole, projected along the normal.
template <typename Arithmetic, typename T>
Vec3<T> faceBarycentric(const Vec3<T>& p, const Triangle<T>& t) {
  const auto normal = planeNormal<Arithmetic>(t);
  const auto whole = dot(normal, normal);
  const auto weight = [&](const Vec3<T>& from, const Vec3<T>& to) {
    const auto part = cross(Arithmetic::difference(to, from), Arithmetic::difference(p, from));
    return std::clamp(static_cast<T>(dot(part, normal) / whole), T(0), T(1));
  };
  const T a = weight(t.b, t.c);
  const T b = weight(t.c, t.a);
  return {a, b, std::max(T(0), T(1) - a - b)};
}

/// The point's parameter along the edge, from 0 at `from` to 1 at `to`.
template <std::floating_point T>
T edgeParameter(const Vec3<T>& p, const Vec3<T>& from, const Vec3<T>& to) {
  return std::clamp(dot(to - from, p - from) / lengthSquared(to - from), T(0), T(1));
}

}  // namespace

Feature featureOf(TrianglePart part) {
  if (part == TrianglePart::Face) return Feature::Face;
  return part < TrianglePart::EdgeAB ? Feature::Vertex : Feature::Edge;
}

template <std::floating_point T>
bool isSliver(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  const T longest = longestSquared(a, b, c);
  // The cross product's own rounding, a few eps of `longest`, is far below the threshold.
  return !(length(cross(b - a, c - a)) >= T(0.1) * longest && longest > 0);
}

template <std::floating_point T>
TriangleHit<T> triangleDistance(const Vec3<T>& p, const Triangle<T>& t) {
  using enum TrianglePart;
  const auto triple = [](const Vec3<T>& v) { return scalar::Triple<T>{v.x, v.y, v.z}; };
  const auto all = scalar::distances<T>(triple(p), triple(t.a), triple(t.b), triple(t.c));
  TriangleHit<T> best;
  const auto offer = [&](const scalar::EdgeDistance<T>& edge, TrianglePart first,
                         TrianglePart second, TrianglePart inner) {
    if (!(edge.squared < best.distanceSquared)) return;
    best = {edge.squared, edge.inner > 0 ? inner : edge.isFirst ? first : second};
  };
  offer(all.ab, VertexA, VertexB, EdgeAB);
  offer(all.bc, VertexB, VertexC, EdgeBC);
  offer(all.ca, VertexC, VertexA, EdgeCA);
  const T plane = t.sliver ? sliverPlaneDistance(p, t) : all.plane;
  if (plane <= best.distanceSquared) best = {plane, Face};
  return best;
}

template <std::floating_point T>
Vec3<T> closestBarycentric(const Vec3<T>& p, const Triangle<T>& t, TrianglePart part) {
  using enum TrianglePart;
  switch (part) {
    case VertexA:
      return {1, 0, 0};
    case VertexB:
      return {0, 1, 0};
    case VertexC:
      return {0, 0, 1};
    case EdgeAB: {
      const T s = edgeParameter(p, t.a, t.b);
      return {1 - s, s, 0};
    }
    case EdgeBC: {
      const T s = edgeParameter(p, t.b, t.c);
      return {0, 1 - s, s};
    }
    case EdgeCA: {
      const T s = edgeParameter(p, t.c, t.a);
      return {s, 0, 1 - s};
    }
    case Face:
      break;
  }
  return t.sliver ? faceBarycentric<Wide<T>>(p, t) : faceBarycentric<Plain<T>>(p, t);
}

template <std::floating_point T>
Vec3<T> unitNormal(const Triangle<T>& t) {
  using std::sqrt;
  return t.sliver ? unitNormalBy<Wide<T>>(t) : unitNormalBy<Plain<T>>(t);
}

template <std::floating_point T>
int sideOfPlane(const Vec3<T>& p, const Triangle<T>& t) {
  return t.sliver ? sideBy<Wide<T>>(p, t) : sideBy<Plain<T>>(p, t);
}

#define CUTWATER_INSTANTIATE(T)                                                          \
  template bool isSliver(const Vec3<T>&, const Vec3<T>&, const Vec3<T>&);                \
  template TriangleHit<T> triangleDistance(const Vec3<T>&, const Triangle<T>&);          \
  template Vec3<T> closestBarycentric(const Vec3<T>&, const Triangle<T>&, TrianglePart); \
  template Vec3<T> unitNormal(const Triangle<T>&);                                       \
  template int sideOfPlane(const Vec3<T>&, const Triangle<T>&);
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

}  // namespace cutwater
