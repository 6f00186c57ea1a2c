#include <Cutwater/Surface/Cleaning/CapOnPlane.hpp>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

/// A tube about the z axis from z = 0 to 1, open at both ends, with its inner wall.
PolygonSoup tube(double outer, double inner, int n) {
  const auto wall = [&](double radius) {
    const auto solid = tessellation::cylinder(radius, 1, n);
    return onlyFaces(solid, [&](std::size_t i) { return solid.polygon(i).size() == 4; });
  };
  return together(wall(outer), insideOut(wall(inner)));
}

TEST(CapOnPlane, ABowlBecomesHalfABall) {
  auto soup = bowl(24);
  const auto report = capOnPlane(soup, {{3, -2, 0}, {0, 0, -5}});
  EXPECT_EQ(report.closed.count, 1U);
  EXPECT_EQ(report.rimEdges, 24U);
  EXPECT_EQ(report.facesAdded, 22U);
  EXPECT_FALSE(report.left);
  EXPECT_TRUE(reportOf(soup).isClean());
  const auto ball = tessellation::revolve(
      [] {
        std::vector<tessellation::ProfilePoint> profile;
        for (int i = 0; i <= 24; ++i) {
          const double angle = std::numbers::pi * (i / 24.0 - 0.5);
          profile.push_back(
              {i == 0 || i == 24 ? 0 : std::cos(angle), i == 12 ? 0 : std::sin(angle)});
        }
        return profile;
      }(),
      24, tessellation::ProfileEnds::OnAxis);
  EXPECT_NEAR(2 * report.after.volume, measure(ball).volume, 1e-13);
  EXPECT_NEAR(report.areaAdded, 12 * std::sin(std::numbers::pi / 12), 1e-13);
  EXPECT_NEAR(report.after.area - report.before.area, report.areaAdded, 1e-13);
  EXPECT_EQ(soup.patchNames.back(), "cap");
  EXPECT_EQ(capOnPlane(soup, {{}, {0, 0, 1}}).closed.count, 0U);
}

TEST(CapOnPlane, PointsOfNoFaceMayBeAnywhere) {
  auto soup = tube(2, 1, 6);
  auto far = soup;
  far.points.emplace_back(1e200, 0, -1e200);
  EXPECT_EQ(capOnPlane(far, {{}, {0, 0, 1}}).after, capOnPlane(soup, {{}, {0, 0, 1}}).after);
  EXPECT_EQ(far.corners.size(), soup.corners.size());
}

TEST(CapOnPlane, ATubesEndsAreRings) {
  auto soup = tube(2, 1, 48);
  ASSERT_EQ(reportOf(soup).boundaryEdges.count, 4 * 48U);
  for (const double z : {0.0, 1.0}) {
    const auto report = capOnPlane(soup, {{0, 0, z}, {0, 0, 1}}, {.patch = "ends"});
    EXPECT_EQ(report.closed.count, 2U);
    EXPECT_EQ(report.rimEdges, 96U);
  }
  const auto report = reportOf(soup);
  EXPECT_TRUE(report.isClean()) << report.summary();
  EXPECT_EQ(report.genus, 1);
  EXPECT_NEAR(report.volume, (4 - 1) * 24 * std::sin(2 * std::numbers::pi / 48), 1e-12);
  EXPECT_EQ(std::ranges::count(soup.patchNames, "ends"), 1);
}

TEST(CapOnPlane, PatchesWithoutANameAreNotTheCap) {
  const auto capped = [](std::uint32_t patch, std::vector<std::string> names) {
    auto soup = bowl(8);
    soup.patchNames = std::move(names);
    std::ranges::fill(soup.patches, patch);
    const auto report = capOnPlane(soup, {{}, {0, 0, 1}});
    EXPECT_EQ(report.facesAdded, 6U);
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(soup.patches, patch)),
              soup.polygonCount() - 6);
    EXPECT_LT(soup.patches.back(), soup.patchNames.size());
    EXPECT_EQ(soup.patchNames[soup.patches.back()], "cap");
    return soup.patchNames;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(capped(0, {}), (Names{"surface", "cap"}));
  EXPECT_EQ(capped(1, {"unused"}), (Names{"unused", "surface", "cap"}));
  EXPECT_EQ(capped(kNone, {}), Names{"cap"});
}

TEST(CapOnPlane, AnyPlaneAndTolerance) {
  // A tilted half ball whose rim lies near the plane only.
  const Vec3<double> normal = normalized(Vec3<double>{1, -2, 0.5});
  const Vec3<double> u = normalized(cross(normal, Vec3<double>{0, 0, 1}));
  const Vec3<double> v = cross(normal, u);
  const Vec3<double> at{100, 200, -50};
  auto soup =
      withPoints(bowl(32), [&](const auto& p) { return at + p.x * u + p.y * v + p.z * normal; });
  soup = jittered(std::move(soup), 1e-7);
  auto untouched = soup;
  EXPECT_EQ(capOnPlane(untouched, {at, normal}).closed.count, 0U);
  EXPECT_EQ(capOnPlane(soup, {at, 1e-3 * normal}, {.tolerance = 1e-6}).closed.count, 1U);
  EXPECT_TRUE(reportOf(soup).isClosedOriented());
  EXPECT_GT(measure(soup).volume, 2.0);
}

TEST(CapOnPlane, RimsThatLeaveThePlaneStay) {
  // A box without its top and one side: the rim runs along both.
  const auto box = tessellation::box({0, 0, 0}, {1, 1, 1}, 3);
  auto soup = onlyFaces(box, [&](std::size_t i) {
    const auto m = middleOf(box, i);
    return m.z < 1 && m.x < 1;
  });
  const auto before = soup;
  const auto report = capOnPlane(soup, {{0, 0, 1}, {0, 0, 1}});
  EXPECT_EQ(report.closed.count, 0U);
  EXPECT_EQ(report.left.count, 1U);
  EXPECT_TRUE(sameSoup(soup, before));
}

TEST(CapOnPlane, RimsThatMeetAreReportedAndOthersClosed) {
  auto soup = together(together(bowl(24), moved(bowl(24), {1, 0, 0})), moved(bowl(24), {9, 0, 0}));
  const auto report = capOnPlane(soup, {{}, {0, 0, 1}});
  EXPECT_EQ(report.closed.count, 1U);
  EXPECT_EQ(report.left.count, 2U);
  EXPECT_EQ(reportOf(soup).boundaryEdges.count, 48U);
  EXPECT_NE(report.text().find("rims left open                          2; at ("),
            std::string::npos)
      << report.text();
}

TEST(CapOnPlane, RefusesPlanesThatAreNone) {
  auto soup = bowl(8);
  EXPECT_THROW(static_cast<void>(capOnPlane(soup, {{}, {0, 0, 0}})), Error);
  EXPECT_THROW(static_cast<void>(capOnPlane(soup, {{HUGE_VAL, 0, 0}, {0, 0, 1}})), Error);
  EXPECT_THROW(static_cast<void>(capOnPlane(soup, {{}, {0, std::nan(""), 1}})), Error);
  EXPECT_THROW(static_cast<void>(capOnPlane(soup, {{}, {0, 0, 1}}, {.tolerance = -1})), Error);
  EXPECT_TRUE(sameSoup(soup, bowl(8)));
}

}  // namespace
}  // namespace cutwater::test
