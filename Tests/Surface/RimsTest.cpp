#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Cleaning/Rims.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <set>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

/// The wall of a cylinder of radius 2 about the z axis, from z = 0 to 3.
PolygonSoup openTube(int parts) {
  const auto solid = tessellation::cylinder(2, 3, parts);
  return onlyFaces(solid, [&](std::size_t i) { return solid.polygon(i).size() == 4; });
}

TEST(Rims, OfATubeAreItsEnds) {
  const auto soup = openTube(16);
  auto rims = findRims(soup);
  ASSERT_EQ(rims.size(), 2U);
  std::ranges::sort(rims, {}, [](const Rim& rim) { return rim.box.lower.z; });
  for (const int end : {0, 1}) {
    const auto& rim = rims[static_cast<std::size_t>(end)];
    EXPECT_EQ(std::set(rim.points.begin(), rim.points.end()).size(), 16U);
    EXPECT_EQ(rim.box, (Box<double>{{-2, -2, 3.0 * end}, {2, 2, 3.0 * end}}));
    EXPECT_EQ(planeOf(rim), (AxisPlane{2, 3.0 * end}));
    // Against the faces beside it: as a polygon it closes the tube and faces outward.
    std::vector<Vec3<double>> corners;
    for (const auto point : rim.points) corners.push_back(soup.points[point]);
    EXPECT_NEAR(polygonArea(corners).normal.z, 2 * end - 1, 1e-14);
  }
}

TEST(Rims, ClosedSurfacesHaveNone) {
  EXPECT_TRUE(findRims(tessellation::box({-1, -1, -1}, {1, 1, 1})).empty());
}

TEST(Rims, EveryImbalanceOfASurfaceIsInOne) {
  auto soup = tessellation::torus(2, 0.5, 24, 12);
  soup = onlyFaces(soup, [](std::size_t i) { return i % 7 != 0; });
  std::size_t edges = 0;
  for (const auto& rim : findRims(soup)) {
    edges += rim.points.size();
    for (const auto point : rim.points) EXPECT_TRUE(rim.box.contains(soup.points[point]));
  }
  EXPECT_EQ(edges, imbalances(soup).size());
}

TEST(Rims, PlanesWithinATolerance) {
  auto soup = openTube(8);
  for (auto& p : soup.points) {
    if (p.z == 3 && p.x > 0) p.z += 0.01;
  }
  const auto rims = findRims(soup);
  const auto bent = std::ranges::find(rims, 3.0, [](const Rim& rim) { return rim.box.lower.z; });
  ASSERT_NE(bent, rims.end());
  EXPECT_FALSE(planeOf(*bent));
  EXPECT_FALSE(planeOf(*bent, 0.0049));
  const auto plane = planeOf(*bent, 0.0051);
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->axis, 2);
  EXPECT_NEAR(plane->at, 3.005, 1e-12);
}

TEST(Rims, RefuseWhatIsNoSoup) {
  auto soup = openTube(8);
  soup.corners[3] = 99;
  EXPECT_THROW(static_cast<void>(findRims(soup)), Error);
}

}  // namespace
}  // namespace cutwater::test
