#include <Cutwater/Mesh/Diagnosis.hpp>
#include <Cutwater/Repair/FillHoles.hpp>

#include "RepairChecks.hpp"

namespace cutwater::test {
namespace {

PolygonSoup ballWithout(FunctionRef<bool(const Vec3<double>&)> isHole, int subdivisions = 3) {
  const auto ball = tessellation::icosphere(1, subdivisions);
  return onlyFaces(ball, [&](std::size_t i) { return !isHole(middleOf(ball, i)); });
}

/// Without the part around an end of every axis.
PolygonSoup ballWithSixHoles() {
  return ballWithout([](const Vec3<double>& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 0.95;
  });
}

TEST(FillHoles, AMissingFaceComesBack) {
  auto soup = onlyFaces(cube(), [](std::size_t i) { return i != 3; });
  const auto report = fillHoles(soup);
  EXPECT_EQ(report.filled.count, 1U);
  EXPECT_EQ(report.facesAdded, 2U);
  EXPECT_DOUBLE_EQ(report.areaAdded, 1);
  EXPECT_DOUBLE_EQ(report.widestFilled, std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(report.after.volume, 1);
  EXPECT_EQ(report.crossings, 0U);
  EXPECT_EQ(soup.patchNames, cube().patchNames);
  expectSolid(soup);
  EXPECT_NE(report.text().find("holes filled                            1; at (0, 1, 0)"),
            std::string::npos)
      << report.text();
}

TEST(FillHoles, SixHolesInABall) {
  auto soup = ballWithSixHoles();
  const auto ball = measure(tessellation::icosphere(1, 3));
  const auto report = fillHoles(soup, {.patch = "filled"});
  EXPECT_EQ(report.filled.count, 6U);
  EXPECT_EQ(report.left(), 0U);
  expectSolid(soup);
  // Chords instead of caps of the height h = 1 - 0.95 at the most: pi h^2 (3 - h) / 3 each.
  EXPECT_LT(report.after.volume, ball.volume);
  EXPECT_GT(report.after.volume, ball.volume - 6 * std::numbers::pi * 0.1 * 0.1);
  ASSERT_EQ(soup.patchNames.back(), "filled");
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(soup.patches, soup.patchNames.size() - 1)),
            report.facesAdded);
}

TEST(FillHoles, LimitsAreKept) {
  const auto soup = ballWithSixHoles();
  auto filled = soup;
  const double rim = fillHoles(filled).widestFilled;
  auto same = soup;
  EXPECT_EQ(fillHoles(same, {.mostEdges = 4}).tooLong.count, 6U);
  EXPECT_EQ(fillHoles(same, {.widest = 0.9 * rim}).tooWide.count, 6U);
  EXPECT_EQ(fillHoles(same, {.seconds = 1e-9}).late.count, 6U);
  EXPECT_TRUE(sameSoup(same, soup));
  EXPECT_EQ(fillHoles(same, {.widest = 1.1 * rim}).filled.count, 6U);
}

TEST(FillHoles, NewFacesHaveThePatchAround) {
  auto soup = cube();
  soup.patchNames = {"inlet", "wall"};
  soup.patches = {0, 1, 1, 1, 1, 1};
  auto open = onlyFaces(soup, [](std::size_t i) { return i != 4; });
  fillHoles(open);
  EXPECT_EQ(open.patches, (std::vector<std::uint32_t>{0, 1, 1, 1, 1, 1, 1}));
}

TEST(FillHoles, TwoFacesOfATetrahedronNeedTheOtherDiagonal) {
  // The edge that the two left have in common would be there twice.
  auto soup = onlyFaces(tetrahedron(), [](std::size_t i) { return i < 2; });
  EXPECT_EQ(fillHoles(soup).filled.count, 1U);
  expectSolid(soup);
  EXPECT_NEAR(measure(soup).volume, 1.0 / 6, 1e-15);
}

TEST(FillHoles, RimsThatTouchAtAPointAreFilledEachForItself) {
  const auto ball = tessellation::icosphere(1, 2);
  const auto at = ball.polygon(0)[0];
  // Two faces about a point that have no edge in common.
  std::size_t other = 0;
  for (std::size_t i = 1; i < ball.polygonCount(); ++i) {
    const auto corners = ball.polygon(i);
    if (std::ranges::count(corners, at) == 0) continue;
    std::size_t shared = 0;
    for (const auto c : corners) shared += std::ranges::count(ball.polygon(0), c) > 0 ? 1 : 0;
    if (shared == 1) other = i;
  }
  auto soup = onlyFaces(ball, [&](std::size_t i) { return i != 0 && i != other; });
  EXPECT_EQ(fillHoles(soup).filled.count, 2U);
  expectSolid(soup);
  EXPECT_DOUBLE_EQ(measure(soup).volume, measure(ball).volume);
}

TEST(FillHoles, RimsDoNotRepeatAnEdgeOfAnother) {
  // The only diagonal of the rim 0, 1, 3, 2, which is concave at 0, is an edge of the rim 0, 3, 4.
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {-1, 2, 0}, {-1, -2, 0}, {4, 0, 0}, {2, 0, 3}};
  const auto addFaceAt = [&](std::uint32_t from, std::uint32_t to, const Vec3<double>& third) {
    soup.points.push_back(third);
    soup.addPolygon(std::array{to, from, static_cast<std::uint32_t>(soup.points.size() - 1)});
  };
  addFaceAt(0, 1, {-3, 1, -1});
  addFaceAt(1, 3, {3, 4, -1});
  addFaceAt(3, 2, {3, -4, -1});
  addFaceAt(2, 0, {-3, -1, -1});
  addFaceAt(0, 3, {2, 1, 4});
  addFaceAt(3, 4, {5, 0, 4});
  addFaceAt(4, 0, {-1, 0, 4});
  ASSERT_EQ(reportOf(soup).nonManifoldEdges.count, 0U);
  const auto report = fillHoles(soup, {.mostEdges = 4, .patch = "filled"});
  EXPECT_EQ(report.unfillable.count, 1U);
  EXPECT_EQ(report.filled.count, 1U);
  EXPECT_EQ(reportOf(soup).nonManifoldEdges.count, 0U);
  EXPECT_EQ(soup.patchNames, (std::vector<std::string>{"surface", "filled"}));
  EXPECT_EQ(soup.patches, (std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 0, 1}));
}

TEST(FillHoles, ASurfaceThroughTheHoleIsReported) {
  const auto bar = tessellation::box({-0.1, -0.1, -1}, {0.1, 0.1, 3});
  const auto ball = ballWithout([](const Vec3<double>& p) { return p.z > 0.9; });
  auto soup = together(ball, bar);
  const auto report = fillHoles(soup);
  EXPECT_EQ(report.filled.count, 1U);
  const auto pairs = [](const PolygonSoup& faces) { return pairsIn(triangulated(faces)); };
  EXPECT_EQ(report.crossings, pairs(soup) - pairs(together(ball, bar)));
  EXPECT_GT(report.crossings, 3U);
}

TEST(FillHoles, NothingToDoChangesNothing) {
  auto soup = cube();
  const auto report = fillHoles(soup);
  EXPECT_EQ(report.facesAdded, 0U);
  EXPECT_EQ(report.before, report.after);
  EXPECT_TRUE(sameSoup(soup, cube()));
  PolygonSoup nothing;
  EXPECT_EQ(fillHoles(nothing).filled.count, 0U);
}

TEST(FillHoles, PointsOfARimOnALineDoNotStopIt) {
  // A slit: four points on one line, so that no triangle between them has an area.
  auto soup = makeSoup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 2, 0}, {1.5, -2, 0}},
                       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 5, 3}});
  const auto report = fillHoles(soup, {.mostEdges = 4});
  EXPECT_EQ(report.unfillable.count + report.filled.count, 2U) << report.text();
}

TEST(FillHoles, DiagnosesCanTryIt) {
  // No axis is normal to the hole, so no cap closes it.
  auto surface = ballWithout([](const Vec3<double>& p) { return p.x + p.y + p.z > 1.65; });
  EXPECT_TRUE(std::ranges::none_of(diagnose(surface).treatments, &Treatment::isClosed));
  // [DOCS
  const HoleFilling filling = [](PolygonSoup& soup, double widest) {
    return fillHoles(soup, {.widest = widest}).filled.count;
  };
  const Diagnosis diagnosis = diagnose(surface, {.fillHoles = filling});
  if (!diagnosis.treatments.empty()) treat(surface, diagnosis.treatments.front(), filling);
  // DOCS]
  ASSERT_EQ(diagnosis.treatments.size(), 1U);
  EXPECT_TRUE(diagnosis.treatments[0].effect.ends_with("holes filled: 1; closed then"))
      << diagnosis.treatments[0].effect;
  expectSolid(surface);
}

TEST(FillHoles, Refusals) {
  auto soup = cube();
  EXPECT_THROW(fillHoles(soup, {.widest = 0}), Error);
  EXPECT_THROW(fillHoles(soup, {.seconds = 0}), Error);
  EXPECT_THROW(fillHoles(soup, {.seconds = std::nan("")}), Error);
  soup.corners[0] = 99;
  EXPECT_THROW(fillHoles(soup), Error);
}

}  // namespace
}  // namespace cutwater::test
