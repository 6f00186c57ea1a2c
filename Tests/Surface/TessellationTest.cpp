#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Closed, oriented, manifold, outwards, and no two points coincide.
MeshReport expectSolid(const PolygonSoup& soup, long long genus = 0) {
  const MeshReport r = check(DcelMesh<double>(soup));
  EXPECT_TRUE(r.isClean()) << r.table();
  EXPECT_EQ(r.components, 1U);
  EXPECT_EQ(r.genus, genus);
  EXPECT_GT(r.volume, 0);
  std::set<std::tuple<double, double, double>> points;
  for (const auto& p : soup.points) points.insert({p.x, p.y, p.z});
  EXPECT_EQ(points.size(), soup.points.size());
  EXPECT_LT(triangulate(soup).relativeWarp, 1e-14);  // all polygons are planar
  EXPECT_TRUE(check(DcelMesh<double>(triangulated(soup))).isClean());
  return r;
}

/// The error of a volume must fall by 4 when the edges are halved.
void expectSecondOrder(const std::function<PolygonSoup(int)>& make, double volume) {
  const double coarse = volume - check(DcelMesh<double>(make(1))).volume;
  const double fine = volume - check(DcelMesh<double>(make(2))).volume;
  EXPECT_GT(fine, 0);  // inscribed, where convex
  EXPECT_NEAR(coarse / fine, 4, 0.1);
}

TEST(Tessellation, SpheresAreIcosahedraRefined) {
  for (int n = 0; n < 5; ++n) {
    const PolygonSoup soup = tessellation::icosphere(2, n);
    EXPECT_EQ(soup.polygonCount(), 20U << (2 * n));
    expectSolid(soup);
    for (const auto& p : soup.points) ASSERT_NEAR(length(p), 2, 1e-15 * 4);
  }
  // The icosahedron of circumradius 1: (5 / 12) (3 + sqrt 5) a^3, a = 1 / sin(72 degrees).
  const double edge = 1 / std::sin(2 * kPi / 5);
  EXPECT_NEAR(check(DcelMesh<double>(tessellation::icosphere(1, 0))).volume,
              5.0 / 12 * (3 + std::sqrt(5)) * edge * edge * edge, 1e-14);
  expectSecondOrder([](int k) { return tessellation::icosphere(1, 2 + k); }, 4 * kPi / 3);
}

TEST(Tessellation, BoxesAreExact) {
  for (const int n : {1, 2, 5}) {
    const auto r = expectSolid(tessellation::box({-1, 0, 2}, {1, 3, 2.5}, n));
    EXPECT_EQ(r.faces, static_cast<std::size_t>(6 * n * n));
    EXPECT_EQ(r.vertices, static_cast<std::size_t>(6 * n * n + 2));
    EXPECT_NEAR(r.volume, 3, 1e-14);
    EXPECT_NEAR(r.area, 2 * (6 + 1 + 1.5), 1e-14);
  }
}

TEST(Tessellation, ToriHaveAHole) {
  const PolygonSoup soup = tessellation::torus(3, 1, 24, 12);
  expectSolid(soup, 1);
  for (const auto& p : soup.points)
    ASSERT_NEAR(std::hypot(std::hypot(p.x, p.y) - 3, p.z), 1, 1e-14);
  expectSecondOrder([](int k) { return tessellation::torus(3, 1, 40 * k, 24 * k); }, 6 * kPi * kPi);
}

TEST(Tessellation, CylindersAndConesAreInscribedPrismsAndPyramids) {
  for (const int n : {3, 8, 33}) {
    const double base = 0.5 * n * 4 * std::sin(2 * kPi / n);  // radius 2
    const auto cylinder = expectSolid(tessellation::cylinder(2, 5, n));
    EXPECT_NEAR(cylinder.volume, 5 * base, 1e-13 * base);
    EXPECT_EQ(cylinder.faces, static_cast<std::size_t>(n + 2));
    const auto cone = expectSolid(tessellation::cone(2, 5, n));
    EXPECT_NEAR(cone.volume, 5 * base / 3, 1e-13 * base);
    EXPECT_EQ(cone.vertices, static_cast<std::size_t>(n + 1));
  }
}

TEST(Tessellation, CapsulesAreRoundAtBothEnds) {
  const PolygonSoup soup = tessellation::capsule(0.5, 2, 16, 4);
  expectSolid(soup);
  for (const auto& p : soup.points) {
    const Vec3<double> nearest{0, 0, std::clamp(p.z, 0.0, 2.0)};
    ASSERT_NEAR(length(p - nearest), 0.5, 1e-15);
  }
  expectSecondOrder([](int k) { return tessellation::capsule(1, 2, 24 * k, 6 * k); },
                    2 * kPi + 4 * kPi / 3);
}

TEST(Tessellation, SolidsAreOnePatchOfTheirName) {
  const std::array<tessellation::ProfilePoint, 3> ring{{{1, 0}, {2, 0}, {1, 1}}};
  const std::array<tessellation::ProfilePoint, 2> wall{{{1, 0}, {1, 1}}};
  const std::vector<std::pair<PolygonSoup, std::string>> solids{
      {tessellation::icosphere(1, 1), "sphere"},
      {tessellation::box({0, 0, 0}, {1, 1, 1}), "box"},
      {tessellation::torus(2, 1, 8, 8), "torus"},
      {tessellation::cylinder(1, 1, 8), "cylinder"},
      {tessellation::cone(1, 1, 8), "cone"},
      {tessellation::capsule(1, 1, 8, 2), "capsule"},
      {tessellation::revolve(ring, 8, tessellation::ProfileEnds::Closed), "revolution"},
      {tessellation::revolve(wall, 8, tessellation::ProfileEnds::OnAxis), "revolution"}};
  for (const auto& [soup, name] : solids) {
    EXPECT_EQ(soup.patchNames, std::vector<std::string>{name});
    EXPECT_EQ(soup.patches, std::vector<std::uint32_t>(soup.polygonCount(), 0)) << name;
  }
}

TEST(Tessellation, RefusesImpossibleSizes) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)tessellation::icosphere(0, 1), Error);
  EXPECT_THROW((void)tessellation::icosphere(1, 13), Error);
  EXPECT_THROW((void)tessellation::box({0, 0, 0}, {1, 0, 1}, 1), Error);
  EXPECT_THROW((void)tessellation::box({0, 0, 0}, {1, 1, 1}, 0), Error);
  EXPECT_THROW((void)tessellation::box({0, 0, 0}, {1, 1, 1}, 1 << 30), Error);
  EXPECT_THROW((void)tessellation::torus(1, 1, 8, 8), Error);
  EXPECT_THROW((void)tessellation::torus(2, 1, 2, 8), Error);
  EXPECT_THROW((void)tessellation::cylinder(1, inf, 8), Error);
  EXPECT_THROW((void)tessellation::cylinder(1, 1, 1 << 30), Error);
  EXPECT_THROW((void)tessellation::cone(-1, 1, 8), Error);
  EXPECT_THROW((void)tessellation::capsule(1, 1, 8, 0), Error);
  const std::array<tessellation::ProfilePoint, 3> pinched{{{1, 0}, {0, 1}, {1, 2}}};
  EXPECT_THROW((void)tessellation::revolve(pinched, 8, tessellation::ProfileEnds::OnAxis), Error);
}

}  // namespace
}  // namespace cutwater::test
