#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>

#include <random>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

PolygonSoup plainBox() {
  return triangulated(tessellation::box({0, 0, 0}, {1, 1, 1}, 2));
}

TEST(DegenerateFaces, ANeedlesNeighbourIsCutAtItsThirdCorner) {
  auto soup = makeSoup({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, -1, 0}},
                       {{0, 1, 3}, {0, 2, 1}, {2, 0, 4}});
  const auto before = imbalances(soup);
  const auto found = removeDegenerateFaces(soup);
  EXPECT_EQ(found.places.count, 1U);
  EXPECT_EQ(found.places.examples[0], (Vec3<double>{1, 0, 0}));
  EXPECT_EQ(found.largest, 2);
  ASSERT_EQ(soup.polygonCount(), 3U);
  EXPECT_EQ(imbalances(soup), before);
  EXPECT_FALSE(reportOf(soup).zeroAreaFaces);
  EXPECT_EQ(measure(soup).area, 1.5);
}

TEST(DegenerateFaces, ClosedMeshesStayClosed) {
  const auto box = plainBox();
  for (const std::size_t needles : {1U, 5U, 48U}) {
    auto soup = withNeedles(box, needles);
    ASSERT_EQ(reportOf(soup).zeroAreaFaces.count, needles);
    removeDegenerateFaces(soup);
    const auto report = reportOf(soup);
    EXPECT_TRUE(report.isClosedOriented()) << report.summary();
    EXPECT_FALSE(report.zeroAreaFaces);
    EXPECT_EQ(report.area, 6);
    EXPECT_EQ(report.volume, 1);
  }
}

TEST(DegenerateFaces, NeedlesThatLeanOnOneAnother) {
  // The edge from 0 to 1 of a tetrahedron is closed by a fan of needles: each one's longest edge is
  // another's, and the corners in between are passed in a row.
  auto soup = makeSoup(
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 2, 1},
                                                                                      {0, 3, 2},
                                                                                      {1, 2, 3},
                                                                                      {0, 4, 3},
                                                                                      {4, 5, 3},
                                                                                      {5, 6, 3},
                                                                                      {6, 1, 3},
                                                                                      {0, 1, 5},
                                                                                      {5, 4, 0},
                                                                                      {5, 1, 6}});
  ASSERT_TRUE(reportOf(soup).isClosedOriented());
  EXPECT_EQ(removeDegenerateFaces(soup).places.count, 3U);
  const auto report = reportOf(soup);
  EXPECT_TRUE(report.isClean()) << report.summary();
  EXPECT_EQ(report.faces, 10U);
  EXPECT_DOUBLE_EQ(report.volume, 64.0 / 6);
}

TEST(DegenerateFaces, RepeatedCornersAndSpikes) {
  auto soup = cube();
  soup = merged(std::move(soup), 7, 6);  // an edge of the cube collapses
  soup.addPolygon(std::array{0U, 1U, 0U});
  soup.addPolygon(std::array{3U, 3U, 3U});
  soup.addPolygon(std::array{0U, 1U, 5U, 1U});
  const auto before = imbalances(soup);
  EXPECT_EQ(removeDegenerateFaces(soup).places.count, 3U + 2U);
  EXPECT_EQ(imbalances(soup), before);
  const auto report = reportOf(soup);
  EXPECT_FALSE(report.repeatedCornerFaces);
  EXPECT_TRUE(report.isClosedOriented()) << report.summary();
  EXPECT_EQ(report.faces, 6U);
}

TEST(DegenerateFaces, APolygonThatTouchesItselfBecomesTriangles) {
  // A square frame as one polygon, with a bridge to its inner rim.
  auto soup = makeSoup(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}},
      {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}});
  const auto before = imbalances(soup);
  EXPECT_EQ(removeDegenerateFaces(soup).places.count, 1U);
  EXPECT_EQ(imbalances(soup), before);
  EXPECT_EQ(soup.polygonCount(), 8U);
  EXPECT_EQ(measure(soup).area, 8);
  EXPECT_FALSE(reportOf(soup).repeatedCornerFaces);
}

TEST(DegenerateFaces, WhatHasAreaStays) {
  // As flat as numbers allow, yet no line.
  auto soup = makeSoup({{0, 0, 0}, {1, 1, 0}, {0.5, std::nextafter(0.5, 1), 0}}, {{0, 1, 2}});
  EXPECT_FALSE(removeDegenerateFaces(soup));
  auto bowTie = makeSoup({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  EXPECT_FALSE(removeDegenerateFaces(bowTie));
  EXPECT_EQ(bowTie.polygonCount(), 1U);
}

TEST(DegenerateFaces, AnySoupKeepsItsRims) {
  // Points on a coarse grid: most triangles share lines, many have no area or repeat a corner.
  std::mt19937 engine(4);
  for (int round = 0; round < 300; ++round) {
    PolygonSoup soup;
    for (std::uint32_t i = 0; i < 27; ++i) {
      soup.points.push_back({double(i % 3), double(i / 3 % 3), double(i / 9)});
    }
    for (int i = 0; i < 40; ++i) {
      std::vector<std::uint32_t> corners;
      for (int k = 0; k < 3 + static_cast<int>(engine() % 3); ++k)
        corners.push_back(static_cast<std::uint32_t>(engine() % 27));
      soup.addPolygon(corners);
    }
    // Rims by the grid's smallest steps: what a long edge passes, its parts pass as well.
    const auto rims = [](const PolygonSoup& s) {
      PolygonSoup split;
      split.points = s.points;
      for (std::size_t i = 0; i < s.polygonCount(); ++i) {
        std::vector<std::uint32_t> corners;
        const auto polygon = s.polygon(i);
        for (std::size_t k = 0; k < polygon.size(); ++k) {
          const auto from = polygon[k];
          const auto to = polygon[(k + 1) % polygon.size()];
          corners.push_back(from);
          for (std::uint32_t m = 0; m < 27; ++m) {
            const bool isMiddle = 0.5 * (s.points[from] + s.points[to]) == s.points[m];
            if (isMiddle && from != to) corners.push_back(m);
          }
        }
        split.addPolygon(corners);
      }
      return imbalances(split);
    };
    const auto before = rims(soup);
    removeDegenerateFaces(soup);
    ASSERT_EQ(rims(soup), before) << round;
    const auto report = reportOf(soup);
    ASSERT_FALSE(report.zeroAreaFaces) << round;
    ASSERT_FALSE(report.repeatedCornerFaces) << round;
    ASSERT_FALSE(removeDegenerateFaces(soup)) << round;
  }
}

}  // namespace
}  // namespace cutwater::test
