#include <Cutwater/Surface/Cleaning/Clean.hpp>

#include <random>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

void expectCleanTwiceAsOnce(const PolygonSoup& cleaned, const CleanOptions& options) {
  auto again = cleaned;
  const auto report = clean(again, options);
  EXPECT_TRUE(report.changedNothing()) << report.text();
  EXPECT_TRUE(sameSoup(again, cleaned));
}

TEST(Clean, ACleanMeshStaysAsItIs) {
  for (const auto& mesh :
       {tetrahedron(), cube(), lPrism(), tessellation::torus(2, 0.5, 9, 5), star(20)}) {
    auto soup = mesh;
    const auto report = clean(soup, {.weldWithin = 1e-9, .splitJunctionsWithin = 1e-9});
    EXPECT_TRUE(report.changedNothing()) << report.text();
    EXPECT_TRUE(sameSoup(soup, mesh));
    for (const auto& step : report.steps) EXPECT_EQ(step.before, step.after);
  }
}

TEST(Clean, RandomDamageIsUndone) {
  std::mt19937 engine(8);
  for (const auto& mesh :
       {tessellation::icosphere(1, 2), triangulated(tessellation::torus(2, 0.5, 24, 12)),
        triangulated(tessellation::box({-1, -1, -1}, {1, 1, 1}, 4))}) {
    const auto expected = reportOf(mesh);
    for (const double jitter : {0.0, 1e-9, 1e-6}) {
      auto soup = withNeedles(mesh, 1 + engine() % 40);
      for (int i = 0; i < 30; ++i) {
        const auto face = engine() % soup.polygonCount();
        const std::vector<std::uint32_t> corners(soup.polygon(face).begin(),
                                                 soup.polygon(face).end());
        if (i % 3 == 0) soup.addPolygon(corners, soup.patches[face]);
        if (i % 3 == 1) soup.addPolygon(std::array{corners[0], corners[1], corners[0]});
      }
      for (int i = 0; i < 30; ++i) soup.points.push_back({0.1 * i, 5, 5});
      for (int i = 0; i < 20; ++i) soup = flipped(soup, engine() % soup.polygonCount());
      soup = jittered(unwelded(soup), jitter);
      CleanOptions options{.weldWithin = 8 * jitter};
      if (jitter == 0) options.weldWithin = std::nullopt;
      // Needles with jitter are slivers with area: they stay, and may fold a little.
      options.opposite = OppositeFaces::Cancel;
      clean(soup, options);
      const auto report = reportOf(soup);
      EXPECT_TRUE(report.isClean()) << report.summary();
      EXPECT_EQ(report.genus, expected.genus);
      EXPECT_NEAR(report.volume, expected.volume, 100 * jitter + 1e-12);
      EXPECT_NEAR(report.area, expected.area, 100 * jitter + 1e-12);
      expectCleanTwiceAsOnce(soup, options);
    }
  }
}

TEST(Clean, AnySoupIsCleanedOnce) {
  // Points on a grid, jittered by less than the tolerance: everything at once, over and over.
  std::mt19937 engine(21);
  for (int round = 0; round < 150; ++round) {
    PolygonSoup soup;
    soup.patchNames = {"all"};
    for (int i = 0; i < 60; ++i) {
      const auto g = [&] { return double(engine() % 4); };
      soup.points.push_back({g(), g(), g()});
    }
    soup = jittered(std::move(soup), round % 2 == 0 ? 0 : 1e-4);
    for (int i = 0; i < 60; ++i) {
      const auto corner = [&] { return static_cast<std::uint32_t>(engine() % 60); };
      soup.addPolygon(std::array{corner(), corner(), corner()});
    }
    CleanOptions options;
    if (round % 3 != 0) options.weldWithin = 1e-3;
    if (round % 5 != 0) options.splitJunctionsWithin = 1e-3;
    if (round % 2 == 0) options.opposite = OppositeFaces::Cancel;
    options.nested = static_cast<NestedShells>(round % 3);
    clean(soup, options);
    const auto report = reportOf(soup);
    EXPECT_FALSE(report.zeroAreaFaces || report.repeatedCornerFaces || report.duplicateFaces ||
                 report.unusedVertices)
        << report.summary();
    if (options.opposite == OppositeFaces::Cancel) {
      EXPECT_FALSE(report.oppositeFaces);
    }
    expectCleanTwiceAsOnce(soup, options);
  }
}

TEST(Clean, PairsOfOppositeFacesAreKeptUnlessToldOtherwise) {
  auto panel = makeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                        {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}});
  auto kept = panel;
  EXPECT_TRUE(clean(kept).changedNothing());
  EXPECT_EQ(clean(panel, {.opposite = OppositeFaces::Cancel}).count(CleanKind::OppositeFaces), 4U);
  EXPECT_EQ(panel.polygonCount(), 0U);
}

TEST(Clean, StepsTellWhatTheyChanged) {
  auto soup = unwelded(flipped(cube(), 2));
  soup.addPolygon(std::array{0U, 1U, 2U, 3U});  // the first face again
  soup.points.push_back({7, 8, 9});
  const auto report = clean(soup);
  EXPECT_EQ(report.count(CleanKind::EqualPoints), 16U);
  EXPECT_EQ(report.count(CleanKind::DuplicateFaces), 1U);
  EXPECT_EQ(report.count(CleanKind::UnusedPoints), 1U);
  EXPECT_EQ(report.count(CleanKind::TurnedFaces), 1U);
  EXPECT_EQ(report.count(CleanKind::TurnedShells), 0U);
  for (const auto& step : report.steps) {
    if (step.kind != CleanKind::DuplicateFaces) continue;
    EXPECT_EQ(step.before.area, 7);
    EXPECT_EQ(step.after.area, 6);
  }
  EXPECT_EQ(report.steps.back().after.volume, 1);
  EXPECT_TRUE(reportOf(soup).isClean());
}

TEST(Clean, WithoutOrientingNoFaceIsTurned) {
  auto soup = insideOut(cube());
  EXPECT_TRUE(clean(soup, {.orient = false}).changedNothing());
  EXPECT_EQ(measure(soup).volume, -1);
}

TEST(Clean, ARefusalChangesNothing) {
  const auto damaged = unwelded(flipped(cube(), 2));
  auto soup = damaged;
  EXPECT_THROW(clean(soup, {.weldWithin = 0}), Error);
  EXPECT_THROW(clean(soup, {.splitJunctionsWithin = -1}), Error);
  EXPECT_TRUE(sameSoup(soup, damaged));
  soup.corners[3] = 99;
  EXPECT_THROW(clean(soup), Error);
}

TEST(Clean, PatchesStayWithTheirFaces) {
  auto soup = withNeedles(triangulated(cube()), 4);
  soup.patchNames = {"even", "odd"};
  std::map<std::uint32_t, double> before;
  std::map<std::uint32_t, double> after;
  const auto tally = [](const PolygonSoup& s, auto& areas) {
    for (std::uint32_t patch = 0; patch < 2; ++patch) {
      areas[patch] =
          measure(onlyFaces(s, [&](std::size_t i) { return s.patches[i] == patch; })).area;
    }
  };
  // Needles have no area: where their neighbours are cut, the parts keep the patch.
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) soup.patches[i] = i % 2;
  tally(soup, before);
  clean(soup);
  tally(soup, after);
  EXPECT_EQ(after, before);
}

}  // namespace
}  // namespace cutwater::test
