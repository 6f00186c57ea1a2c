#include <Cutwater/Surface/Cleaning/CapOnPlane.hpp>
#include <Cutwater/Surface/Cleaning/MirrorAt.hpp>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

const SurfacePlane kFloor{{0, 0, 0}, {0, 0, 1}};

TEST(MirrorAt, ABowlAndItsImageAreABall) {
  auto soup = bowl(24);
  auto half = soup;
  static_cast<void>(capOnPlane(half, kFloor));
  const auto faces = soup.polygonCount();
  const auto report = mirrorAt(soup, kFloor);
  EXPECT_EQ(report.rimEdges, 24U);
  EXPECT_EQ(report.facesAdded, faces);
  EXPECT_EQ(report.pointsMoved, 0U);
  const auto whole = reportOf(soup);
  EXPECT_TRUE(whole.isClean()) << whole.summary();
  EXPECT_EQ(whole.genus, 0);
  EXPECT_NEAR(whole.volume, 2 * measure(half).volume, 1e-14);
  EXPECT_NEAR(report.areaAdded, report.before.area, 1e-13);
}

TEST(MirrorAt, CapsInThePlaneAreRemoved) {
  auto soup = onlyFaces(triangulated(cube()), [](std::size_t) { return true; });
  soup = withPoints(soup, [](const auto& p) { return p - Vec3<double>{0, 0, 1}; });
  soup.points.push_back({0.5, 0.5, 0});  // only faces of the cap have it
  soup.addPolygon(std::array{8U, 4U, 6U});
  soup.addPolygon(std::array{8U, 6U, 4U});
  EXPECT_EQ(mirrorAt(soup, kFloor).facesRemoved, 4U);
  EXPECT_TRUE(reportOf(soup).isClean());
  EXPECT_EQ(measure(soup).volume, 2);

  soup = bowl(16);
  static_cast<void>(capOnPlane(soup, kFloor));
  EXPECT_EQ(mirrorAt(soup, kFloor).facesRemoved, 14U);
  EXPECT_TRUE(reportOf(soup).isClean());
  EXPECT_TRUE(soup.patchNames.back() == "cap");
}

TEST(MirrorAt, PointsNearThePlaneAreMovedOntoIt) {
  const auto soup = jittered(bowl(16), 1e-6);
  auto refused = soup;
  EXPECT_THROW(static_cast<void>(mirrorAt(refused, kFloor)), Error);
  auto apart = moved(soup, {0, 0, -1e-5});
  static_cast<void>(mirrorAt(apart, kFloor, 1e-9));
  EXPECT_EQ(reportOf(apart).components, 2U);
  auto joined = soup;
  const auto report = mirrorAt(joined, kFloor, 1e-5);
  EXPECT_EQ(report.pointsMoved, 16U);
  EXPECT_GT(report.farthestMove, 1e-7);
  EXPECT_LE(report.farthestMove, 1e-6);
  EXPECT_TRUE(reportOf(joined).isClean()) << reportOf(joined).summary();
  EXPECT_EQ(std::ranges::count_if(joined.points, [](const auto& p) { return p.z == 0; }), 16);
}

TEST(MirrorAt, AnyPlane) {
  const Vec3<double> normal = normalized(Vec3<double>{2, -1, 3});
  const Vec3<double> u = normalized(cross(normal, Vec3<double>{0, 0, 1}));
  const Vec3<double> v = cross(normal, u);
  const Vec3<double> at{5, 6, 7};
  auto soup =
      withPoints(bowl(16), [&](const auto& p) { return at + p.x * u + p.y * v + p.z * normal; });
  auto straight = bowl(16);
  static_cast<void>(mirrorAt(straight, kFloor));
  static_cast<void>(mirrorAt(soup, {at, -7.0 * normal}, 1e-12));
  EXPECT_TRUE(reportOf(soup).isClean());
  EXPECT_NEAR(measure(soup).volume, measure(straight).volume, 1e-12);
}

TEST(MirrorAt, PatchesKeepTheirNames) {
  auto soup = bowl(8);
  soup.patchNames = {"keel", "sides"};
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    soup.patches[i] = middleOf(soup, i).z > -0.5 ? 1 : 0;
  }
  const auto sides = std::ranges::count(soup.patches, 1U);
  static_cast<void>(mirrorAt(soup, kFloor));
  EXPECT_EQ(soup.patchNames, (std::vector<std::string>{"keel", "sides"}));
  EXPECT_EQ(std::ranges::count(soup.patches, 1U), 2 * sides);
}

TEST(MirrorAt, ExactAcrossAnAxis) {
  auto soup = moved(tetrahedron(), {3, 0, 0});
  static_cast<void>(mirrorAt(soup, {{0.5, 9, 9}, {-4, 0, 0}}));
  ASSERT_EQ(soup.points.size(), 8U);
  for (const auto& p : moved(tetrahedron(), {3, 0, 0}).points) {
    EXPECT_NE(std::ranges::find(soup.points, Vec3<double>{1 - p.x, p.y, p.z}), soup.points.end());
  }
}

TEST(MirrorAt, RefusesASurfaceOnBothSides) {
  auto soup = cube();
  try {
    static_cast<void>(mirrorAt(soup, {{0.5, 0.5, 0.5}, {0, 0, 1}}));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Topology) << error.what();
  }
  EXPECT_TRUE(sameSoup(soup, cube()));
  EXPECT_THROW(static_cast<void>(mirrorAt(soup, {{}, {}})), Error);
}

}  // namespace
}  // namespace cutwater::test
