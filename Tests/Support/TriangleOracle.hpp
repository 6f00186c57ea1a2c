#pragma once

#include <algorithm>
#include <array>

#include "Support/Float128.hpp"

namespace cutwater::test {

/// Squared distance to the segment from a to a + edge of the point fromA beyond a.
inline Float128 segmentDistanceSquared(const Vec3Float128& fromA, const Vec3Float128& edge) {
  const Float128 squared = dot(edge, edge);
  Float128 t = squared > 0 ? dot(fromA, edge) / squared : Float128(0);
  t = std::clamp(t, Float128(0), Float128(1));
  const Vec3Float128 rest{fromA.x - t * edge.x, fromA.y - t * edge.y, fromA.z - t * edge.z};
  return dot(rest, rest);
}

/// Squared distance from p to the triangle, by the definition, in quadruple precision.
template <typename T>
Float128 triangleDistanceSquared(const Vec3<T>& p, const Vec3<T>& a, const Vec3<T>& b,
                                 const Vec3<T>& c) {
  const Vec3<double> q(p);
  const std::array<Vec3<double>, 3> v{Vec3<double>(a), Vec3<double>(b), Vec3<double>(c)};
  const auto from = [](const Vec3<double>& origin, const Vec3<double>& to) {
    return Vec3Float128::difference(to, origin);
  };
  const auto normal = cross(from(v[0], v[1]), from(v[0], v[2]));
  Float128 best = segmentDistanceSquared(from(v[2], q), from(v[2], v[0]));
  bool inside = dot(normal, normal) > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto edge = from(v[i], v[(i + 1) % 3]);
    best = std::min(best, segmentDistanceSquared(from(v[i], q), edge));
    inside = inside && dot(cross(edge, from(v[i], q)), normal) > 0;
  }
  if (inside) {
    const Float128 height = dot(normal, from(v[0], q));
    best = std::min(best, height * height / dot(normal, normal));
  }
  return best;
}

/// The distance itself.
template <typename T>
Float128 triangleDistanceExactly(const Vec3<T>& p, const Vec3<T>& a, const Vec3<T>& b,
                                 const Vec3<T>& c) {
  return squareRoot(triangleDistanceSquared(p, a, b, c));
}

}  // namespace cutwater::test
