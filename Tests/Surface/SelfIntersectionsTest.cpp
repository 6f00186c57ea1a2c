#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "Support/IntersectingPairs.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Points = std::vector<Vec3<double>>;

/// Whether two triangles intersect, whichever comes first and however their corners are ordered.
bool meet(const Points& points, const Corners& first, const Corners& second) {
  int yes = 0;
  int count = 0;
  Corners orderA{0, 1, 2};
  do {
    Corners orderB{0, 1, 2};
    do {
      const Corners a{first[orderA[0]], first[orderA[1]], first[orderA[2]]};
      const Corners b{second[orderB[0]], second[orderB[1]], second[orderB[2]]};
      yes += intersect(points, a, b) ? 1 : 0;
      yes += intersect(points, b, a) ? 1 : 0;
      count += 2;
    } while (std::next_permutation(orderB.begin(), orderB.end()));
  } while (std::next_permutation(orderA.begin(), orderA.end()));
  EXPECT_TRUE(yes == 0 || yes == count) << yes << " of " << count;
  return yes > 0;
}

constexpr Corners kFirst{0, 1, 2};

/// A right triangle with legs of 4 along x and y against one with corners of its own.
bool meetsRightTriangle(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  return meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, a, b, c}, kFirst, {3, 4, 5});
}
/// The same with the corner at the right angle in common.
bool meetsAtItsCorner(const Vec3<double>& a, const Vec3<double>& b) {
  return meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, a, b}, kFirst, {0, 3, 4});
}
/// The same with the edge along x in common.
bool meetsAlongItsEdge(const Vec3<double>& a) {
  return meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, a}, kFirst, {0, 1, 3});
}

TEST(TriangleIntersectionTest, TrianglesWithNothingInCommon) {
  EXPECT_TRUE(meetsRightTriangle({1, 1, -1}, {1, 1, 1}, {9, 9, 0}));    // through the face
  EXPECT_TRUE(meetsRightTriangle({-1, 1, -1}, {-1, 1, 1}, {9, 1, 0}));  // across two edges
  EXPECT_FALSE(meetsRightTriangle({5, 1, -1}, {5, 1, 1}, {9, 1, 0}));   // crosses the plane only
  EXPECT_FALSE(meetsRightTriangle({1, 1, 1}, {2, 1, 1}, {1, 2, 1}));    // above, parallel
  EXPECT_FALSE(meetsRightTriangle({1, 1, 1e-100}, {2, 1, 1}, {1, 2, 1}));
}

TEST(TriangleIntersectionTest, TouchingCounts) {
  EXPECT_TRUE(meetsRightTriangle({1, 1, 0}, {2, 1, 1}, {1, 2, 1}));      // a corner in the face
  EXPECT_TRUE(meetsRightTriangle({2, 2, 0}, {2, 3, 1}, {3, 2, 1}));      // ... on an edge
  EXPECT_TRUE(meetsRightTriangle({4, 0, 0}, {5, 1, 1}, {5, 0, 1}));      // ... on a corner
  EXPECT_TRUE(meetsRightTriangle({2, -1, 1}, {2, 1, -1}, {2, -9, -9}));  // edges cross
  EXPECT_FALSE(meetsRightTriangle({1, 1, 0x1p-40}, {2, 1, 1}, {1, 2, 1}));
  EXPECT_FALSE(meetsRightTriangle({2 + 0x1p-50, 2, 0}, {2, 3, 1}, {3, 2, 1}));
}

TEST(TriangleIntersectionTest, TrianglesInOnePlane) {
  EXPECT_TRUE(meetsRightTriangle({1, 1, 0}, {5, 5, 0}, {4, 5, 0}));        // overlap
  EXPECT_TRUE(meetsRightTriangle({1, 1, 0}, {2, 1, 0}, {1, 2, 0}));        // within
  EXPECT_TRUE(meetsRightTriangle({-9, -9, 0}, {99, -9, 0}, {-9, 99, 0}));  // around
  EXPECT_TRUE(meetsRightTriangle({2, 2, 0}, {3, 3, 0}, {2, 4, 0}));        // a corner on an edge
  EXPECT_TRUE(meetsRightTriangle({3, 0, 0}, {9, 0, 0}, {5, -3, 0}));       // along an edge
  EXPECT_TRUE(meetsRightTriangle({4, 0, 0}, {9, 0, 0}, {5, -3, 0}));       // corner to corner
  EXPECT_FALSE(meetsRightTriangle({3, 2, 0}, {4, 4, 0}, {3, 4, 0}));       // apart, boxes overlap
  EXPECT_FALSE(meetsRightTriangle({2 + 0x1p-51, 2, 0}, {3, 3, 0}, {2, 4, 0}));
}

TEST(TriangleIntersectionTest, TrianglesWithACommonCorner) {
  EXPECT_FALSE(meetsAtItsCorner({-1, 0, 0}, {0, -1, 0}));   // opposite, in one plane
  EXPECT_FALSE(meetsAtItsCorner({-1, 3, 0}, {-1, -1, 0}));  // beside
  EXPECT_FALSE(meetsAtItsCorner({1, 1, 1}, {-1, 2, 1}));    // above
  EXPECT_FALSE(meetsAtItsCorner({-3, 1, 1}, {1, -3, -1}));  // crosses the plane behind the corner
  EXPECT_TRUE(meetsAtItsCorner({3, -1, 1}, {-1, 3, -1}));   // crosses the face
  EXPECT_TRUE(meetsAtItsCorner({1, 1, 0}, {1, 1, 9}));      // an edge within the face
  EXPECT_TRUE(meetsAtItsCorner({9, 9, 0}, {1, 1, 9}));      // ... and beyond
  EXPECT_TRUE(meetsAtItsCorner({2, 0, 0}, {2, -1, 0}));     // common part of an edge, in one plane
  EXPECT_TRUE(meetsAtItsCorner({2, 0, 0}, {2, 0, 1}));      // ... upright
  EXPECT_TRUE(meetsAtItsCorner({8, 0, 0}, {2, -1, 0}));
  EXPECT_TRUE(meetsAtItsCorner({1, 2, 0}, {2, 1, 0}));    // within
  EXPECT_TRUE(meetsAtItsCorner({-1, 8, 0}, {8, -1, 0}));  // around, but for the corner
}

TEST(TriangleIntersectionTest, TrianglesWithACommonEdge) {
  EXPECT_FALSE(meetsAlongItsEdge({0, -4, 0}));
  EXPECT_FALSE(meetsAlongItsEdge({0, 0, 4}));
  EXPECT_FALSE(meetsAlongItsEdge({0, 4, 0x1p-50}));  // folded, nearly flat
  EXPECT_TRUE(meetsAlongItsEdge({0, 9, 0}));
  EXPECT_TRUE(meetsAlongItsEdge({9, 1, 0}));
  EXPECT_TRUE(meetsAlongItsEdge({1, 1, 0}));
  EXPECT_TRUE(meetsAlongItsEdge({0, 4, 0}));  // the same position under another number
}

TEST(TriangleIntersectionTest, DuplicatesMeet) {
  EXPECT_TRUE(meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, kFirst, kFirst));
}

TEST(TriangleIntersectionTest, AreaIsExact) {
  EXPECT_TRUE(hasArea({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2 + 0x1p-51}}}));
  EXPECT_FALSE(hasArea({{{0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}}}));
  EXPECT_FALSE(hasArea({{{1, 2, 3}, {1, 2, 3}, {4, 5, 6}}}));
}

template <typename T>
SelfIntersections searched(const PolygonSoup& soup, const SelfIntersectionOptions& options = {}) {
  return findSelfIntersections(DcelMesh<T>(soup), options);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> examples(const SelfIntersections& found) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const auto& [a, b] : found.pairs.examples) result.emplace_back(index(a), index(b));
  return result;
}

TEST(SelfIntersectionsTest, SolidsHaveNone) {
  for (const auto& soup : {cube(), tetrahedron(), lPrism(), star(50),
                           tessellation::torus(3, 1, 40, 20), tessellation::icosphere(1e-20, 4),
                           tessellation::capsule(1e20, 1e20, 12, 4), PolygonSoup{}}) {
    for (const auto& found : {searched<double>(soup), searched<float>(soup)}) {
      EXPECT_FALSE(found);
      EXPECT_TRUE(found.complete);
      EXPECT_EQ(found.skippedTriangles, 0U);
    }
  }
}

TEST(SelfIntersectionsTest, CountsFacesOnceHoweverManyOfTheirTrianglesMeet) {
  const auto moved = [](Vec3<double> p) { return p + Vec3<double>{0.5, 0.5, 0.5}; };
  const auto found = searched<double>(together(cube(), withPoints(cube(), moved)));
  // The three faces of each cube at the other's corner, each with the two it is perpendicular to.
  EXPECT_EQ(found.pairs.count, 6U);
  EXPECT_EQ(examples(found), (std::vector<std::pair<std::uint32_t, std::uint32_t>>{
                                 {1, 8}, {1, 10}, {3, 6}, {3, 10}, {5, 6}, {5, 8}}));
}

TEST(SelfIntersectionsTest, CountsLargePolygonsOnce) {
  // Lids of hundreds of triangles, which no range of work holds as a whole.
  const auto cylinder = tessellation::cylinder(1, 2, 300);
  const auto moved = [](Vec3<double> p) { return p + Vec3<double>{0.6, 0.3, 0.9}; };
  const DcelMesh<double> mesh(together(cylinder, withPoints(cylinder, moved)));
  std::vector<std::pair<std::uint32_t, Corners>> triangles;
  for (const FaceId face : mesh.faces()) {
    for (const auto& [a, b, c] : mesh.triangles(face)) {
      triangles.push_back({index(face), {index(a), index(b), index(c)}});
    }
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < triangles.size(); ++j) {
      if (!intersect(mesh.positions(), triangles[i].second, triangles[j].second)) continue;
      expected.emplace(triangles[i].first, triangles[j].first);
    }
  }
  EXPECT_GT(expected.size(), 200U);
  const auto found = findSelfIntersections(mesh);
  EXPECT_EQ(found.pairs.count, expected.size());
  auto next = expected.begin();
  for (const auto& pair : examples(found)) EXPECT_EQ(pair, *next++);
}

TEST(SelfIntersectionsTest, TellsAPolygonThatFoldsOntoItself) {
  const auto concave = makeSoup({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, {{0, 1, 2, 3}});
  EXPECT_FALSE(searched<double>(concave));
  const auto bowTie = makeSoup({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {4, 1, 0}}, {{0, 1, 2, 3}});
  const auto found = searched<double>(bowTie);
  EXPECT_EQ(examples(found), (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 0}}));
}

TEST(SelfIntersectionsTest, TellsDuplicatesAndTouchingShells) {
  auto soup = tetrahedron();
  soup.addPolygon(std::array{0U, 1U, 2U});
  EXPECT_EQ(examples(searched<double>(soup)),
            (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 4}}));

  const auto beside = together(cube(), withPoints(cube(), [](auto p) {
                                 p.x += 1;
                                 return p;
                               }));
  EXPECT_TRUE(searched<double>(beside));
  const auto apart = together(cube(), withPoints(cube(), [](auto p) {
                                p.x += 1 + 0x1p-50;
                                return p;
                              }));
  EXPECT_FALSE(searched<double>(apart));
  EXPECT_TRUE(searched<float>(apart));  // where they touch
}

TEST(SelfIntersectionsTest, SkipsTrianglesWithoutArea) {
  auto soup = tetrahedron();
  soup.points.push_back({0.25, 0.25, 0.25});
  soup.points.push_back({-1, -1, -1});
  soup.points.push_back({1, 1, 1});
  soup.addPolygon(std::array{4U, 5U, 6U});  // a line through the solid
  const auto found = searched<double>(soup);
  EXPECT_FALSE(found);
  EXPECT_EQ(found.skippedTriangles, 1U);
}

/// Small triangles anywhere in a cube.
struct RandomSoup {
  Points points;
  std::vector<Corners> triangles;

  RandomSoup(std::uint32_t count, double size, unsigned seed) {
    RandomPoints<double> centers(1, seed);
    RandomPoints<double> offsets(size, seed + 1);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto center = centers.next();
      for (int corner = 0; corner < 3; ++corner) points.push_back(center + offsets.next());
      triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
  }
};

TEST(SelfIntersectionsTest, TheTreeLosesNoPair) {
  const RandomSoup soup(static_cast<std::uint32_t>(scaled(1500)), 0.1, 3);
  const auto expected = bruteForce(soup.points, soup.triangles);
  EXPECT_GT(expected.pairs.count, 100U);
  expectSame(findSelfIntersections<double>(soup.points, soup.triangles), expected);
}

TEST(SelfIntersectionsTest, TheSameWhateverThreadsAndScale) {
  const RandomSoup soup(3000, 0.1, 5);
  const auto expected = findSelfIntersections<double>(soup.points, soup.triangles, {.threads = 1});
  for (const int threads : {2, 3, 8}) {
    expectSame(findSelfIntersections<double>(soup.points, soup.triangles, {.threads = threads}),
               expected);
  }
  for (const int exponent : {-400, -70, 70, 400}) {
    auto points = soup.points;
    for (auto& p : points) p *= std::ldexp(1.0, exponent);
    expectSame(findSelfIntersections<double>(points, soup.triangles), expected);
  }
}

TEST(SelfIntersectionsTest, StopsAtTheLimit) {
  const RandomSoup soup(2000, 1, 7);  // nearly a quarter of all pairs
  const auto all = findSelfIntersections<double>(soup.points, soup.triangles);
  EXPECT_TRUE(all.complete);
  ASSERT_GT(all.pairs.count, 20'000U);
  for (const std::size_t limit : {std::size_t{100}, std::size_t{20'000}}) {
    for (const int threads : {1, 2, 5}) {
      const auto some = findSelfIntersections<double>(soup.points, soup.triangles,
                                                      {.limit = limit, .threads = threads});
      EXPECT_FALSE(some.complete);
      EXPECT_EQ(some.pairs.count, limit);
      EXPECT_EQ(some.pairs.examples, all.pairs.examples);
    }
  }
  const auto few = findSelfIntersections<double>(soup.points, soup.triangles, {.limit = 0});
  EXPECT_EQ(few.pairs.examples, all.pairs.examples);
}

TEST(SelfIntersectionsTest, RefusesWhatIsNoMesh) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(
      static_cast<void>(findSelfIntersections<double>(points, std::vector<Corners>{{0, 1, 3}})),
      Error);
  Points broken = points;
  broken[1].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(
      static_cast<void>(findSelfIntersections<double>(broken, std::vector<Corners>{{0, 1, 2}})),
      Error);
}

}  // namespace
}  // namespace cutwater::test
