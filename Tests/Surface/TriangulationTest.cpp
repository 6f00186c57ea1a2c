#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "Support/CpuTime.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

std::vector<Vec3<double>> cornersOf(const PolygonSoup& soup, std::span<const std::uint32_t> ids) {
  std::vector<Vec3<double>> corners;
  for (const auto id : ids) corners.push_back(soup.points[id]);
  return corners;
}

std::vector<Vec3<double>> cornersOf(const PolygonSoup& soup, const TriangleCorners& triangle) {
  const auto [a, b, c] = triangle;
  return cornersOf(soup, std::array{index(a), index(b), index(c)});
}

/// Directed edges with the number of times they are passed, minus the times backwards.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> boundary(
    const std::vector<std::vector<std::uint32_t>>& polygons) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto a = polygon[i];
      const auto b = polygon[(i + 1) % polygon.size()];
      if (a != b) edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  return edges;
}

/// The triangles have the polygon for their boundary, whatever it is like.
void expectSameBoundary(const PolygonSoup& soup, const Triangulation& triangulation) {
  std::vector<std::vector<std::vector<std::uint32_t>>> parts(soup.polygonCount());
  for (std::size_t i = 0; i < triangulation.triangles.size(); ++i) {
    const auto [a, b, c] = triangulation.triangles[i];
    parts[triangulation.polygons[i]].push_back({index(a), index(b), index(c)});
  }
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto polygon = soup.polygon(i);
    EXPECT_EQ(boundary(parts[i]), boundary({{polygon.begin(), polygon.end()}})) << i;
  }
}

/// The triangles of a planar simple polygon cover it once: all turn like it, and areas add up.
void expectPartition(const PolygonSoup& soup) {
  const Triangulation triangulation = triangulate(soup);
  expectSameBoundary(soup, triangulation);
  ASSERT_EQ(soup.polygonCount(), 1U);
  EXPECT_EQ(triangulation.triangles.size(), soup.corners.size() - 2);
  const PolygonArea whole = polygonArea(cornersOf(soup, soup.polygon(0)));
  double sum = 0;
  for (const auto& triangle : triangulation.triangles) {
    const PolygonArea part = polygonArea(cornersOf(soup, triangle));
    sum += part.area;
    EXPECT_GE(dot(part.normal, whole.normal), 0);
  }
  EXPECT_NEAR(sum, whole.area, 1e-12 * whole.area);
}

PolygonSoup onePolygon(const std::vector<Vec3<double>>& points) {
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < points.size(); ++i) corners.push_back(i);
  return makeSoup(points, {corners});
}

/// Turned out of the coordinate planes, so that no coordinate is special.
PolygonSoup tilted(const PolygonSoup& soup) {
  return withPoints(soup, [](const Vec3<double>& p) {
    return Vec3<double>{0.36 * p.x + 0.48 * p.y - 0.8 * p.z, -0.8 * p.x + 0.6 * p.y,
                        0.48 * p.x + 0.64 * p.y + 0.6 * p.z};
  });
}

/// A star-shaped polygon with radii at random: up to half of its corners are reflex.
PolygonSoup jagged(std::uint32_t n, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> radius(0.1, 1);
  std::vector<Vec3<double>> points;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double r = radius(engine);
    points.push_back({r * std::cos(angle), r * std::sin(angle), 0.25});
  }
  return onePolygon(points);
}

/// A comb of n teeth: long ears that many corners get in the way of.
PolygonSoup comb(int n) {
  std::vector<Vec3<double>> points{{0, -1, 0}, {2.0 * n, -1, 0}};
  for (int i = n; i-- > 0;) {
    points.push_back({2.0 * i + 2, 0, 0});
    points.push_back({2.0 * i + 1, 10, 0});
  }
  points.push_back({0, 0, 0});
  return onePolygon(points);
}

/// A band of constant width, wound inwards.
PolygonSoup spiral(int n) {
  std::vector<Vec3<double>> points;
  for (int i = 0; i <= n; ++i) {
    points.push_back({(1 + 0.2 * i) * std::cos(0.3 * i), (1 + 0.2 * i) * std::sin(0.3 * i), 0});
  }
  for (int i = n; i >= 0; --i) {
    points.push_back({(0.8 + 0.2 * i) * std::cos(0.3 * i), (0.8 + 0.2 * i) * std::sin(0.3 * i), 0});
  }
  return onePolygon(points);
}

TEST(Triangulation, LeavesTrianglesAlone) {
  const PolygonSoup soup = tetrahedron();
  const Triangulation result = triangulate(soup);
  ASSERT_EQ(result.triangles.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(result.polygons[i], i);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(index(result.triangles[i][k]), soup.polygon(i)[k]);
    }
  }
  EXPECT_EQ(result.polygonsSplit, 0U);
  EXPECT_EQ(result.mostWarped, kNone);
}

TEST(Triangulation, SplitsQuadsAlongTheDiagonalInside) {
  // An arrowhead, notched at each of its corners in turn: only the diagonal from the notch is
  // inside.
  for (std::uint32_t turn = 0; turn < 4; ++turn) {
    std::vector<Vec3<double>> points{{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}};
    std::rotate(points.begin(), points.begin() + turn, points.end());
    expectPartition(onePolygon(points));
    expectPartition(tilted(onePolygon(points)));
  }
}

TEST(Triangulation, SplitsQuadsAlongTheBetterDiagonal) {
  // A flat rhombus: the short diagonal gives nearly equilateral halves.
  const auto result = triangulate(onePolygon({{-1, 0, 0}, {0, -0.6, 0}, {1, 0, 0}, {0, 0.6, 0}}));
  ASSERT_EQ(result.triangles.size(), 2U);
  for (const auto& triangle : result.triangles) {
    EXPECT_EQ(std::ranges::count(triangle, VertexId{1}), 1);
    EXPECT_EQ(std::ranges::count(triangle, VertexId{3}), 1);
  }
}

TEST(Triangulation, CoversConcavePolygonsOnce) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    expectPartition(jagged(5 + 3 * seed, seed));
    expectPartition(tilted(jagged(5 + 3 * seed, seed)));
  }
  for (const int n : {2, 7, 40}) {
    expectPartition(comb(n));
    expectPartition(tilted(comb(n)));
  }
  expectPartition(spiral(60));
  expectPartition(tilted(spiral(60)));
}

TEST(Triangulation, CoversPolygonsWhicheverWayTheyFace) {
  const PolygonSoup ell = lPrism();
  for (std::size_t i = 0; i < ell.polygonCount(); ++i) {
    const auto corners = cornersOf(ell, ell.polygon(i));
    for (int axis = 0; axis < 3; ++axis) {  // a cyclic change of axes is a rotation
      expectPartition(withPoints(onePolygon(corners), [&](const Vec3<double>& p) {
        return Vec3<double>{p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]};
      }));
    }
  }
}

TEST(Triangulation, IsIndifferentToSizeAndOffset) {
  const auto want = triangulate(jagged(40, 7)).triangles;
  for (const double factor : {0x1p-480, 0x1p-40, 0x1p40, 0x1p480}) {
    const auto scaled = withPoints(jagged(40, 7), [&](const auto& p) { return factor * p; });
    EXPECT_EQ(triangulate(scaled).triangles, want) << factor;
  }
  expectPartition(withPoints(jagged(40, 7), [](const auto& p) {
    return p + Vec3<double>{1 << 20, 1 << 20, 1 << 20};
  }));
}

TEST(Triangulation, KeepsCollinearCorners) {
  // A unit square with a corner in the middle of each edge, and one with all four on one edge.
  expectPartition(onePolygon(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}}));
  PolygonSoup soup = onePolygon(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}});
  for (int quarter = 0; quarter < 4; ++quarter) {
    expectPartition(soup);
    for (const auto& triangle : triangulate(soup).triangles) {
      EXPECT_GT(polygonArea(cornersOf(soup, triangle)).area,
                0);  // there is a way without flat ones
    }
    soup = withPoints(soup, [](const auto& p) { return Vec3<double>{-p.y, p.x, p.z}; });
  }
}

TEST(Triangulation, DecidesTurnsThatDoubleCannot) {
  // Which way the second corner turns is a matter of the last bits of the first, and double takes
  // it wrong for many of these: Kettner et al., "Classroom examples of robustness problems in
  // geometric computations", Comput. Geom. 40 (2008).
  // The other corners make good ears, so that it is left to the end.
  constexpr double kUnit = 0x1p-53;
  for (int i = 0; i < 48; ++i) {
    for (int j = 0; j < 48; ++j) {
      expectPartition(onePolygon({{0.3 + i * kUnit, 0.3 + j * kUnit, 0},
                                  {8.7, 8.7, 0},
                                  {17.3, 17.3, 0},
                                  {11.1, 40.5, 0},
                                  {-5.9, 23.5, 0}}));
    }
  }
}

TEST(Triangulation, CutsAPolygonWithABridgeToItsHole) {
  // A square with a square hole, as one polygon that passes the edge 0-4 twice.
  const PolygonSoup soup = makeSoup(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}},
      {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}});
  expectPartition(soup);
  expectPartition(tilted(soup));
}

TEST(Triangulation, LeavesOutRepeatedCornersAndSpikes) {
  const std::vector<Vec3<double>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const PolygonSoup soup = makeSoup(points, {{0, 1, 1, 2},
                                             {0, 0, 1, 2, 0},
                                             {0, 1, 3, 1, 2},
                                             {3, 0, 1, 2, 0},
                                             {0, 1, 2, 0, 3},
                                             {0},
                                             {0, 1},
                                             {1, 1, 1},
                                             {0, 1, 0, 1},
                                             {0, 1, 2, 1, 0, 3}});
  const Triangulation result = triangulate(soup);
  ASSERT_EQ(result.triangles.size(), 5U);
  EXPECT_EQ(result.polygons, (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(result.polygonsDropped, 5U);
  expectSameBoundary(soup, result);
}

TEST(Triangulation, AlwaysEndsWithAsManyTrianglesAsCornersAllow) {
  std::mt19937 engine(3);
  std::uniform_int_distribution<int> coordinate(0, 3);  // many coincide, line up and cross
  for (std::uint32_t n = 3; n < 60; ++n) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      std::vector<Vec3<double>> points(n);
      for (auto& p : points) {
        for (int axis = 0; axis < 3; ++axis) p[axis] = coordinate(engine);
      }
      const PolygonSoup soup = onePolygon(points);
      const Triangulation result = triangulate(soup);
      ASSERT_EQ(result.triangles.size(), n - 2);
      expectSameBoundary(soup, result);
    }
  }
}

TEST(Triangulation, MeasuresHowFarFromFlatPolygonsAre) {
  PolygonSoup soup = cube();
  EXPECT_EQ(triangulate(soup).mostWarped, kNone);
  for (auto& p : soup.points) p *= 8;
  soup.points[7].z += 1e-7;
  EXPECT_EQ(triangulate(soup).polygonsWarped, 0U);
  soup.points[7].z = 12;
  const Triangulation result = triangulate(soup);
  // On top, heights 8, 8, 12, 8; the other two quads at the vertex stay planar. The Newell normal
  // is
  // (-1, -1, 4) / sqrt(18) and the distances from the mean's plane are 4 / sqrt(18).
  EXPECT_EQ(result.polygonsWarped, 1U);
  EXPECT_EQ(result.mostWarped, 5U);
  EXPECT_NEAR(result.warp, 4 / std::sqrt(18.0), 1e-14);
  EXPECT_NEAR(result.relativeWarp, result.warp / std::sqrt(16 + 16 + 9), 1e-15);
  EXPECT_EQ(result.polygonsSplit, 6U);
}

TEST(Triangulation, KeepsPatchesAndPoints) {
  PolygonSoup soup = cube();
  soup.patchNames = {"a", "b"};
  soup.patches = {0, 1, 0, 1, 0, 1};
  const PolygonSoup triangles = triangulated(soup);
  EXPECT_EQ(triangles.points, soup.points);
  EXPECT_EQ(triangles.patchNames, soup.patchNames);
  EXPECT_EQ(triangles.patches, (std::vector<std::uint32_t>{0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1}));
  EXPECT_EQ(triangles.corners.size(), 36U);
}

TEST(Triangulation, IsQuickForLargePolygons) {
  const auto work = [] {
    EXPECT_EQ(triangulate(tessellation::cylinder(1, 1, 100000)).triangles.size(), 399996U);
    EXPECT_EQ(triangulate(jagged(8000, 1)).triangles.size(), 7998U);
    EXPECT_EQ(triangulate(comb(8000)).triangles.size(), 16001U);
  };
  EXPECT_LT(cpuSeconds(work), 5);  // about 0.3 s; a sanitizer takes ten times that
}

}  // namespace
}  // namespace cutwater::test
