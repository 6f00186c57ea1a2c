#include "BruteForce.hpp"

#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <array>
#include <numbers>

namespace cutwater::benchmarks {

namespace {

template <typename Real>
struct Vector {
  Real x, y, z;

  friend Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// Corners relative to the point.
template <typename Real>
using Corners = std::array<Vector<Real>, 3>;

template <typename Real>
Corners<Real> cornersFrom(const Vec3<double>& p, const PolygonSoup& soup, std::size_t triangle) {
  Corners<Real> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& v = soup.points[soup.corners[3 * triangle + k]];
    result[k] = {Real(v.x) - Real(p.x), Real(v.y) - Real(p.y), Real(v.z) - Real(p.z)};
  }
  return result;
}

/// From the origin, by the definition: the least of the distances to the edges and, where the
/// projection falls inside, to the plane.
template <typename Real>
Real distanceSquared(const Corners<Real>& v) {
  const auto normal = cross(v[1] - v[0], v[2] - v[0]);
  const Real normalSquared = dot(normal, normal);
  bool inside = normalSquared > 0;
  Real best = std::numeric_limits<Real>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& a = v[k];
    const auto edge = v[(k + 1) % 3] - a;
    const Real edgeSquared = dot(edge, edge);
    const Real t =
        edgeSquared > 0 ? std::clamp(-dot(a, edge) / edgeSquared, Real(0), Real(1)) : Real(0);
    const Vector<Real> rest{a.x + t * edge.x, a.y + t * edge.y, a.z + t * edge.z};
    best = std::min(best, dot(rest, rest));
    inside = inside && dot(cross(a, edge), normal) >= 0;
  }
  if (!inside) return best;
  const Real height = dot(v[0], normal);
  return std::min(best, height * height / normalSquared);
}

/// Half the angle under which the triangle is seen, negative from its front (A. van Oosterom,
/// J. Strackee, IEEE Trans. Biomed. Eng. 30, 1983).
double halfSolidAngle(const Corners<double>& v) {
  const double a = std::sqrt(dot(v[0], v[0]));
  const double b = std::sqrt(dot(v[1], v[1]));
  const double c = std::sqrt(dot(v[2], v[2]));
  return std::atan2(dot(v[0], cross(v[1], v[2])),
                    a * b * c + dot(v[0], v[1]) * c + dot(v[1], v[2]) * a + dot(v[2], v[0]) * b);
}

double signedDistance(const PolygonSoup& soup, const Vec3<double>& p) {
  const auto count = soup.polygonCount();
  double best = std::numeric_limits<double>::infinity();
  double angles = 0;
  std::vector<double> squares(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto v = cornersFrom<double>(p, soup, i);
    squares[i] = distanceSquared(v);
    best = std::min(best, squares[i]);
    angles += halfSolidAngle(v);
  }
  // Needles are off by more than rounding in double; all that may be the nearest take part again.
  const auto scale = soup.boundingBox().diagonal();
  const double limit = best * (1 + 1e-6) + 1e-18 * scale * scale;
  auto exact = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    if (squares[i] > limit) continue;
    exact = std::min(exact, distanceSquared(cornersFrom<long double>(p, soup, i)));
  }
  const double winding = angles / (2 * std::numbers::pi);
  const auto distance = static_cast<double>(std::sqrt(exact));
  return std::abs(winding) > 0.5 ? -distance : distance;
}

}  // namespace

std::vector<double> bruteForce(const PolygonSoup& triangles, std::span<const Vec3<double>> points) {
  std::vector<double> result(points.size());
  parallelFor(points.size(), {}, [&](std::size_t begin, std::size_t end) {
    for (auto i = begin; i < end; ++i) result[i] = signedDistance(triangles, points[i]);
  });
  return result;
}

}  // namespace cutwater::benchmarks
