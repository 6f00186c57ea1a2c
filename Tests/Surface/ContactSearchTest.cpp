#include <Cutwater/Surface/Detail/ContactSearch.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/TriangleDistance.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "Support/DamagedSoups.hpp"
#include "Support/Fans.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using Points3 = std::array<Vec3<double>, 3>;

TriangleList listOf(const PolygonSoup& soup) {
  const auto triangles = triangulated(soup);
  TriangleList list{triangles.points, {}};
  for (std::size_t i = 0; i < triangles.polygonCount(); ++i) {
    const auto corners = triangles.polygon(i);
    list.corners.push_back({corners[0], corners[1], corners[2]});
  }
  return list;
}

SurfaceContacts contactsOf(const PolygonSoup& soup) {
  const auto list = listOf(soup);
  return findContacts<double>(list.points, list.corners);
}

PolygonSoup box(const Vec3<double>& lower, const Vec3<double>& upper) {
  return tessellation::box(lower, upper);
}

/// The triangle, made smaller by less than any two different numbers of a small grid differ.
Points3 slightlySmaller(const Points3& t) {
  const Vec3<double> middle = (t[0] + t[1] + t[2]) / 3.0;
  Points3 result = t;
  for (auto& p : result) p += 0x1p-20 * (middle - p);
  return result;
}

/// Whether the closed triangles meet, as those of different surfaces.
bool meetAtAll(const Points3& a, const Points3& b) {
  const std::array points{a[0], a[1], a[2], b[0], b[1], b[2]};
  return intersect(points, {0, 1, 2}, {3, 4, 5});
}

TEST(ContactSearchTest, ThoseMeetWithinThatStillMeetWhenOneIsSmaller) {
  std::mt19937 engine(11);
  std::array<int, 3> seen{};  // apart, touching, meeting within
  for (int round = 0; round < scaled(60'000); ++round) {
    const auto levels = 2 + engine() % 3;
    const auto random = [&] {
      Points3 t;
      // Multiples of three: the middles are whole numbers.
      const auto below = [&](auto n) { return 3 * static_cast<double>(engine() % n); };
      for (auto& p : t) p = {below(levels), below(levels), below(2U)};
      return t;
    };
    const Points3 a = random();
    const Points3 b = random();
    if (!hasArea(a) || !hasArea(b)) continue;
    const bool within = meetAtAll(slightlySmaller(a), b) || meetAtAll(a, slightlySmaller(b));
    ASSERT_EQ(meetWithin(a, b), within) << a[0] << a[1] << a[2] << b[0] << b[1] << b[2];
    ASSERT_EQ(meetWithin(b, {a[2], a[1], a[0]}), within);
    ++seen[within ? 2 : meetAtAll(a, b) ? 1 : 0];
  }
  EXPECT_GT(*std::ranges::min_element(seen), scaled(2'000));
}

TEST(ContactSearchTest, TouchingAlongEdgesAndAtCornersIsNoOverlap) {
  const auto first = box({0, 0, 0}, {1, 1, 1});
  const auto overlaps = [&](const Vec3<double>& lower, const Vec3<double>& upper) {
    return contactsOf(together(first, box(lower, upper))).overlaps;
  };
  EXPECT_EQ(overlaps({1, 1, 0}, {2, 2, 1}), 0U);        // along an edge
  EXPECT_EQ(overlaps({1, 1, 0.25}, {2, 2, 3}), 0U);     // along a part of it
  EXPECT_EQ(overlaps({1, 1, 1}, {2, 2, 2}), 0U);        // at a corner
  EXPECT_EQ(overlaps({1, 1, 1.125}, {2, 2, 2}), 0U);    // not at all
  EXPECT_GT(overlaps({1, 0, 0}, {2, 1, 1}), 0U);        // side by side
  EXPECT_GT(overlaps({1, 0.5, 0.5}, {2, 2, 2}), 0U);    // likewise, in part
  EXPECT_GT(overlaps({0.5, 0.5, 0.5}, {2, 2, 2}), 0U);  // through one another
  EXPECT_GT(overlaps({0, 0, 0}, {1, 1, 1}), 0U);        // the same
}

TEST(ContactSearchTest, MarksEdgesThatOthersLieOn) {
  // A T-junction at the middle of an edge, closed by a face without area.
  const TriangleList list{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, 1, 1}},
                          {{0, 1, 4}, {0, 2, 1}, {3, 2, 0}, {1, 2, 3}}};
  const auto found = findContacts<double>(list.points, list.corners);
  EXPECT_EQ(found.overlaps, 0U);
  EXPECT_EQ(found.touchedEdges, (std::vector<std::uint8_t>{1 | 8, 7, 2 | 16, 1 | 8}));
  // Crossing an edge at a point marks nothing.
  const TriangleList crossed{{{0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 0, -1}, {1, 0, 1}, {1, 3, 0}},
                             {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(findContacts<double>(crossed.points, crossed.corners).touchedEdges,
            (std::vector<std::uint8_t>{0, 0}));
}

TEST(ContactSearchTest, TooManyThatTouchCountAsOverlaps) {
  TriangleList list;
  std::mt19937 engine(12);
  for (std::uint32_t i = 0; i < 1600; ++i) {  // all at one point
    const double x = unitRandom(engine) - 0.5;
    const double y = unitRandom(engine) - 0.5;
    list.points.insert(list.points.end(), {{0, 0, 0}, {x, y, 1}, {x, y + 1e-9, 1}});
    list.corners.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto most = SurfaceContacts::kMost;
  EXPECT_EQ(findContacts<double>(list.points, list.corners).overlaps, most);
  list.corners.resize(400);
  EXPECT_EQ(findContacts<double>(list.points, list.corners).overlaps, 0U);
}

std::vector<std::uint8_t> closeTrianglesOf(const PolygonSoup& soup, double clearance) {
  const auto list = listOf(soup);
  const auto tree = buildTriangleTree<double>(list.points, list.corners);
  return findCloseTriangles(list.points, list.corners, tree.tree(), clearance);
}

TEST(ContactSearchTest, TrianglesAreCloseToOthersWithinTheClearance) {
  const auto shareOf = [](const PolygonSoup& soup, double clearance) {
    const auto found = closeTrianglesOf(soup, clearance);
    return static_cast<double>(std::ranges::count(found, 1)) / static_cast<double>(found.size());
  };
  const auto one = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(shareOf(one, 1e-9), 0);  // neighbours are none
  EXPECT_EQ(shareOf(together(one, one), 1e-9), 1);
  EXPECT_EQ(shareOf(unwelded(one), 1e-9), 1);
  for (const double gap : {1e-12, 1e-6, 0.01}) {
    const auto beside = together(one, box({1 + gap, 0.25, 0.25}, {2, 0.75, 0.75}));
    EXPECT_EQ(shareOf(beside, 0.9 * gap), 0) << gap;
    // Two triangles of the one, and at least those of the facing side of the other.
    EXPECT_GE(shareOf(beside, 1.1 * gap), 4.0 / 24) << gap;
    EXPECT_LT(shareOf(beside, 1.1 * gap), 1) << gap;
  }
  // A corner beside the middle of a face.
  const auto spike = makeSoup({{0.3, 0.4, 1.001}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}},
                              {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}});
  EXPECT_EQ(std::ranges::count(closeTrianglesOf(together(one, spike), 0.002), 1), 4);
}

TEST(ContactSearchTest, TrianglesThatNobodyLookedAtAreClose) {
  EXPECT_GT(std::ranges::count(closeTrianglesOf(star(4000), 1e-9), 1), 3000);
}

/// The distance of triangles that do not meet: of corners from triangles, or of edges.
double distanceOf(const Points3& a, const Points3& b) {
  double least = std::numeric_limits<double>::infinity();
  const auto asTriangle = [](const Points3& t) {
    return Triangle<double>{t[0], t[1], t[2], isSliver(t[0], t[1], t[2])};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min(least, triangleDistance(a[i], asTriangle(b)).distanceSquared);
    least = std::min(least, triangleDistance(b[i], asTriangle(a)).distanceSquared);
    for (std::size_t j = 0; j < 3; ++j) {
      const auto u = a[(i + 1) % 3] - a[i];
      const auto v = b[(j + 1) % 3] - b[j];
      const auto w = b[j] - a[i];
      const double determinant = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
      if (determinant < 1e-12) continue;
      const double s = (dot(v, v) * dot(u, w) - dot(u, v) * dot(v, w)) / determinant;
      const double t = (dot(u, v) * dot(u, w) - dot(u, u) * dot(v, w)) / determinant;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
        least = std::min(least, lengthSquared(w + t * v - s * u));
      }
    }
  }
  return std::sqrt(least);
}

TEST(ContactSearchTest, TrianglesFartherApartAre) {
  std::mt19937 engine(4);
  std::array<int, 2> seen{};
  for (int i = 0; i < scaled(20'000); ++i) {
    std::array<Points3, 2> t;
    for (auto& points : t) {
      for (auto& p : points) p = {unitRandom(engine), unitRandom(engine), unitRandom(engine)};
    }
    const double lift = i % 3 == 0 ? 1 : 0.2;
    for (auto& p : t[1]) p.z += lift;
    const std::vector<Vec3<double>> points{t[0][0], t[0][1], t[0][2], t[1][0], t[1][1], t[1][2]};
    const bool meet = intersect(points, {0, 1, 2}, {3, 4, 5});
    const double distance = meet ? 0 : distanceOf(t[0], t[1]);
    for (const double asked : {1e-12, 1e-3, 0.1, 0.5}) {
      const bool isApart = areFartherApart(t[0], t[1], asked);
      if (isApart) {
        EXPECT_GT(distance, asked * (1 - 1e-12));
      }
      // Some plane of two that meet in corners alone is less far from both.
      EXPECT_TRUE(isApart || distance <= 2 * asked + 1e-9) << distance << ' ' << asked;
      ++seen[isApart ? 1 : 0];
    }
  }
  EXPECT_GT(*std::ranges::min_element(seen), scaled(5'000));
}

}  // namespace
}  // namespace cutwater::test
