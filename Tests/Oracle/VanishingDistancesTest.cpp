// Signs at points so near to the surface that products of coordinates underflow: against rational
// arithmetic.

#include <Cutwater/Mesh/MeshSDF.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <random>

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using WideRational = CGAL::Exact_rational;
using RationalVertex = std::array<WideRational, 3>;
using RationalFace = std::array<RationalVertex, 3>;

enum class Place { Inside, On, Outside };

RationalVertex rationalOf(const Vec3<double>& p) {
  return {WideRational(p.x), WideRational(p.y), WideRational(p.z)};
}

RationalVertex minus(const RationalVertex& a, const RationalVertex& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The sign of the determinant of b - a, c - a, p - a.
int sideOf(const RationalVertex& a, const RationalVertex& b, const RationalVertex& c,
           const RationalVertex& p) {
  const auto u = minus(b, a);
  const auto v = minus(c, a);
  const auto w = minus(p, a);
  const WideRational value = (u[1] * v[2] - u[2] * v[1]) * w[0] +
                             (u[2] * v[0] - u[0] * v[2]) * w[1] +
                             (u[0] * v[1] - u[1] * v[0]) * w[2];
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Closed surfaces with corners of small whole numbers, so that many faces, edges and corners have
/// coordinates of 0, beside which numbers may be as small as they like.
class NearSurface {
 public:
  explicit NearSurface(unsigned seed) : engine_(seed) {
    do {
      seed % 2 == 0 ? makeTetrahedron() : makeStar();
      triangles_.clear();
      for (std::size_t i = 0; i < soup_.polygonCount(); ++i) {
        const auto v = soup_.polygon(i);
        triangles_.push_back({rationalOf(soup_.points[v[0]]), rationalOf(soup_.points[v[1]]),
                              rationalOf(soup_.points[v[2]])});
      }
    } while (!bulges());
  }

  [[nodiscard]] const PolygonSoup& soup() const { return soup_; }

  /// A point of a face, an edge or a corner, without rounding, and from there 10^-exponent away.
  Vec3<double> pointAt(double exponent) {
    const auto v = soup_.polygon(below(soup_.polygonCount()));
    const std::size_t part = below(3);
    Vec3<double> p = soup_.points[v[below(3)]];
    if (part > 0) p = 0.5 * (p + soup_.points[v[below(3)]]);
    if (part > 1) p = 0.5 * (p + soup_.points[v[below(3)]]);
    const double distance = std::pow(10.0, -exponent);
    for (int axis = 0; axis < 3; ++axis) {
      // Beside a coordinate that is not 0, a small number would be lost.
      if (below(3) > 0) p[axis] += distance * number();
    }
    return p;
  }

  /// Where the point is, by the parity along a ray.
  Place placeOf(const Vec3<double>& point) {
    const auto p = rationalOf(point);
    while (true) {
      const Vec3<double> away{1e3 * number() + 1e4, 1e4 * number(), 1e4 * number()};
      if (const auto place = placeAlong(p, rationalOf(away))) return *place;
    }
  }

 private:
  std::size_t below(std::size_t end) { return engine_() % end; }
  double number() { return std::uniform_real_distribution<>(-1, 1)(engine_); }
  Vec3<double> corner() {
    const auto coordinate = [this] { return static_cast<double>(below(5)) - 2; };
    const double x = coordinate();
    const double y = coordinate();
    return {x, y, coordinate()};
  }

  void makeTetrahedron() {
    soup_ = {};
    soup_.points = {{0, 0, 0}, corner(), corner(), corner()};
    addOutward({0, 1, 2}, 3);
    addOutward({0, 1, 3}, 2);
    addOutward({0, 2, 3}, 1);
    addOutward({1, 2, 3}, 0);
  }
  void addOutward(std::array<std::uint32_t, 3> face, std::uint32_t opposite) {
    const auto at = [&](std::uint32_t i) { return rationalOf(soup_.points[i]); };
    if (sideOf(at(face[0]), at(face[1]), at(face[2]), at(opposite)) > 0) {
      std::swap(face[1], face[2]);
    }
    soup_.addPolygon(face);
  }
  /// An octahedron about some point whose corners are moved along its axes: seldom convex.
  void makeStar() {
    soup_ = {};
    const auto center = corner();
    for (int i = 0; i < 6; ++i) {
      auto p = center;
      p[i / 2] += (i % 2 == 0 ? 1.0 : -1.0) * static_cast<double>(1 + below(4));
      soup_.points.push_back(p);
    }
    for (std::uint32_t i = 0; i < 8; ++i) {
      std::array<std::uint32_t, 3> face{i & 1U, 2 + (i >> 1U & 1U), 4 + (i >> 2U)};
      if (std::popcount(i) % 2 != 0) std::swap(face[1], face[2]);
      soup_.addPolygon(face);
    }
  }
  [[nodiscard]] bool bulges() const {
    // A tetrahedron that is not flat; stars never are.
    const auto& [a, b, c] = triangles_[0];
    return soup_.points.size() == 6 || sideOf(a, b, c, rationalOf(soup_.points[3])) != 0;
  }

  /// Whether a point of the triangle's plane is in the triangle: seen from a point beside the
  /// plane.
  static bool isWithin(const RationalFace& triangle, const RationalVertex& p) {
    const auto& [a, b, c] = triangle;
    RationalVertex beside = a;
    for (std::size_t axis = 0; sideOf(a, b, c, beside) == 0; ++axis) beside[axis] += 1;
    const auto turn = [&](const RationalVertex& from, const RationalVertex& to) {
      return sideOf(beside, from, to, p);
    };
    const auto [least, most] = std::minmax({turn(a, b), turn(b, c), turn(c, a)});
    return least >= 0 || most <= 0;
  }
  /// None if the ray meets an edge.
  [[nodiscard]] std::optional<Place> placeAlong(const RationalVertex& p,
                                                const RationalVertex& away) const {
    int crossed = 0;
    for (const auto& triangle : triangles_) {
      const auto& [a, b, c] = triangle;
      const int here = sideOf(a, b, c, p);
      if (here == 0 && isWithin(triangle, p)) return Place::On;
      const auto [least, most] =
          std::minmax({sideOf(p, away, a, b), sideOf(p, away, b, c), sideOf(p, away, c, a)});
      if (least < 0 && most > 0) continue;  // the line passes by
      if (least * most == 0) return {};
      crossed += here != sideOf(a, b, c, away) ? 1 : 0;
    }
    return crossed % 2 == 0 ? Place::Outside : Place::Inside;
  }

  std::mt19937 engine_;
  PolygonSoup soup_;
  std::vector<RationalFace> triangles_;
};

template <typename T>
void expectSignsOf(unsigned seed, double smallest, std::array<int, 3>& found) {
  NearSurface surface(seed);
  const MeshSDF<T> mesh(surface.soup());
  ASSERT_TRUE(mesh.signReport().isSound()) << mesh.signReport().summary();
  const Vec3<T> beyond{T(9.25), T(-8.5), T(7.125)};
  for (int k = 0; k < 75; ++k) {
    const Vec3<T> p(surface.pointAt(1 + k * smallest / 75));
    const auto place = surface.placeOf(Vec3<double>(p));
    ++found[static_cast<std::size_t>(place)];
    const T value = mesh.signedDistance(p);
    const bool isInside = place == Place::Inside;
    EXPECT_EQ(value < 0, isInside) << "seed " << seed << ": " << value << " at " << p;
    EXPECT_EQ(mesh.closestPoint(p).distance, value);
    const auto count = mesh.crossings({p, beyond}, [](const Crossing<T>&) { return true; });
    EXPECT_EQ(count.found % 2 == 1, isInside) << "seed " << seed << ": crossings from " << p;
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(VanishingDistances, HaveExactSigns) {
  std::array<int, 3> found{};
  for (int seed = 1; seed <= scaled(100) && !HasFailure(); ++seed) {
    expectSignsOf<double>(static_cast<unsigned>(seed), 300, found);
    expectSignsOf<float>(static_cast<unsigned>(seed), 37, found);
  }
  for (const int count : found) EXPECT_GT(count, 500);  // inside, on and outside
}

}  // namespace
}  // namespace cutwater::test
