#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

/// A box whose sides are meshed each for itself, n, n + 1, ... rectangles along their edges.
PolygonSoup sidesByThemselves(int n) {
  PolygonSoup soup;
  soup.patchNames = {"box"};
  for (int side = 0; side < 6; ++side) {
    const auto fine = tessellation::box({0, 0, 0}, {1, 1, 1}, n + side);
    const auto one = onlyFaces(fine, [&](std::size_t i) {
      const auto m = middleOf(fine, i);
      return m[side / 2] == side % 2;
    });
    soup = together(soup, one);
  }
  weldExactly(soup);
  return soup;
}

TEST(Junctions, APointOnAnEdgeBecomesPartOfIt) {
  auto soup = makeSoup({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, -1, 0}, {2, -1, 0}, {1, 1e-6, 0}},
                       {{0, 1, 2}, {0, 3, 5}, {5, 4, 1}});
  EXPECT_FALSE(splitJunctions(soup, 0.9e-6));
  const auto found = splitJunctions(soup, 2e-6);
  EXPECT_EQ(found.places.count, 1U);
  EXPECT_EQ(found.places.examples[0], (Vec3<double>{1, 1e-6, 0}));
  EXPECT_NEAR(found.largest, 1e-6, 1e-20);
  EXPECT_EQ(soup.polygonCount(), 4U);
  EXPECT_EQ(reportOf(soup).boundaryEdges.count, 6U);
  EXPECT_FALSE(splitJunctions(soup, 2e-6));
}

TEST(Junctions, TheToleranceIsADistanceToTheEdge) {
  const double d = 1e-3;  // along each axis: the distance is the root of 2 times that
  auto soup = makeSoup({{0, 0, 0}, {2, 2, 0}, {0, 2, 0}, {2, 0, 0}, {1 + d, 1 - d, 0}},
                       {{0, 1, 2}, {0, 3, 4}, {4, 3, 1}});
  EXPECT_FALSE(splitJunctions(soup, 1.4 * d));
  EXPECT_NEAR(splitJunctions(soup, 1.5 * d).largest, std::sqrt(2.0) * d, 1e-15);
}

TEST(Junctions, PointsOfNoFaceMayBeAnywhere) {
  auto soup = makeSoup({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, -1, 0}, {2, -1, 0}, {1, 1e-6, 0}},
                       {{0, 1, 2}, {0, 3, 5}, {5, 4, 1}});
  soup.points.emplace_back(0, 0, 1e200);
  EXPECT_FALSE(splitJunctions(soup, 0.9e-6));
  EXPECT_EQ(splitJunctions(soup, 2e-6).places.count, 1U);
}

TEST(Junctions, SidesMeshedByThemselvesClose) {
  for (const bool triangles : {false, true}) {
    for (const double scale : {1.0, 1e-20, 1e20}) {
      auto soup = sidesByThemselves(3);
      if (triangles) soup = triangulated(soup);
      soup = withPoints(soup, [&](const auto& p) { return scale * p; });
      ASSERT_GT(reportOf(soup).boundaryEdges.count, 50U);
      const auto found = splitJunctions(soup, 1e-9 * scale);
      EXPECT_LE(found.largest, 1e-15 * scale);
      const auto report = reportOf(soup);
      EXPECT_TRUE(report.isClosedOriented()) << report.summary();
      EXPECT_NEAR(report.volume / scale / scale / scale, 1, 1e-12);
      EXPECT_NEAR(report.area / scale / scale, 6, 1e-12);
    }
  }
}

TEST(Junctions, ACrackAlongJitteredRimsCloses) {
  auto soup = jittered(triangulated(sidesByThemselves(4)), 1e-7);
  weldWithin(soup, 1e-6);
  splitJunctions(soup, 1e-6);
  const auto report = reportOf(soup);
  EXPECT_TRUE(report.isClosedOriented()) << report.summary();
  EXPECT_NEAR(report.volume, 1, 1e-5);
}

TEST(Junctions, ClosedSurfacesHaveNone) {
  auto soup = tessellation::icosphere(1, 2);
  EXPECT_FALSE(splitJunctions(soup, 0.2));
  EXPECT_TRUE(sameSoup(soup, tessellation::icosphere(1, 2)));
}

TEST(Junctions, SeamsBetweenOrientationsAreNoRims) {
  // Two squares side by side, one turned, and a third sheet whose rim touches their seam.
  auto soup = makeSoup({{0, 0, 0},
                        {1, 0, 0},
                        {1, 2, 0},
                        {0, 2, 0},
                        {2, 0, 0},
                        {2, 2, 0},
                        {1, 1, 0},
                        {1, 1, 1},
                        {1, 0.5, 1}},
                       {{0, 1, 2, 3}, {1, 2, 5, 4}, {6, 7, 8}});
  ASSERT_EQ(reportOf(soup).misorientedEdges.count, 1U);
  EXPECT_FALSE(splitJunctions(soup, 1e-6));
}

TEST(Junctions, ATrianglesOwnCornerIsNotPutIntoItsEdge) {
  auto soup = makeSoup({{0, 0, 0}, {2, 0, 0}, {1, 1e-3, 0}}, {{0, 1, 2}});
  EXPECT_FALSE(splitJunctions(soup, 1e-2));
}

TEST(Junctions, RefusesWhatIsNoTolerance) {
  auto soup = tetrahedron();
  for (const double tolerance : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(splitJunctions(soup, tolerance), Error) << tolerance;
  }
}

}  // namespace
}  // namespace cutwater::test
