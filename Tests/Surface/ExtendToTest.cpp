#include <Cutwater/Surface/Cleaning/ExtendTo.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <optional>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

double heightAt(double x, double y) {
  return 0.3 * std::sin(2 * x) + 0.2 * std::cos(3 * y) + 0.1 * x * y;
}

/// A hilly square [0, n h]^2 of triangles, which face up; `axis` is the vertical one.
PolygonSoup terrain(int n, double h, int axis = 2) {
  PolygonSoup soup;
  soup.patchNames = {"ground"};
  const auto width = static_cast<std::uint32_t>(n) + 1;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      Vec3<double> p;
      p[(axis + 1) % 3] = h * i;
      p[(axis + 2) % 3] = h * j;
      p[axis] = heightAt(h * i, h * j);
      soup.points.push_back(p);
    }
  }
  for (std::uint32_t j = 0; j + 1 < width; ++j) {
    for (std::uint32_t i = 0; i + 1 < width; ++i) {
      const std::uint32_t a = j * width + i;
      soup.addPolygon(std::array{a, a + 1, a + width + 1});
      soup.addPolygon(std::array{a, a + width + 1, a + width});
    }
  }
  return soup;
}

/// Of all triangles: their area seen along the axis times their mean height above the level.
double prismVolume(const PolygonSoup& soup, int axis, double level) {
  double sum = 0;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto c = soup.polygon(i);
    const auto& p = soup.points;
    sum +=
        0.5 * cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]])[axis] * (middleOf(soup, i)[axis] - level);
  }
  return sum;
}

/// The kind of the error that the call throws, nothing if it throws none; it must not change the
/// soup then.
template <typename Call>
std::optional<ErrorKind> refusal(PolygonSoup soup, Call call) {
  const auto before = soup;
  try {
    call(soup);
  } catch (const Error& error) {
    EXPECT_TRUE(sameSoup(soup, before));
    return error.kind();
  }
  return {};
}

TEST(ExtendTo, TheGroundBelowATerrain) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto ground = terrain(12, 0.25, axis);
    auto soup = ground;
    const auto report = extendTo(soup, axis, -2);
    EXPECT_EQ(report.closed.count, 1U);
    EXPECT_EQ(report.rimEdges, 48U);
    EXPECT_EQ(report.facesAdded, 2 * 48U + 46U);
    const auto whole = reportOf(soup);
    EXPECT_TRUE(whole.isClean()) << whole.summary();
    EXPECT_NEAR(whole.volume, prismVolume(ground, axis, -2), 1e-12);
    EXPECT_EQ(soup.patchNames, (std::vector<std::string>{"ground", "sides", "bottom"}));
    EXPECT_TRUE(
        std::ranges::equal(ground.corners, std::span(soup.corners).first(ground.corners.size())));
  }
}

TEST(ExtendTo, TheAirAboveATerrainAndGroundThatFacesDown) {
  const auto ground = terrain(12, 0.25);
  auto air = ground;
  static_cast<void>(extendTo(air, 2, 5, {.sides = "walls", .bottom = "sky"}));
  EXPECT_TRUE(reportOf(air).isClean());
  EXPECT_NEAR(measure(air).volume, -prismVolume(ground, 2, 5), 1e-12);
  auto down = insideOut(ground);
  static_cast<void>(extendTo(down, 2, -2));
  EXPECT_TRUE(reportOf(down).isClean());
  EXPECT_NEAR(measure(down).volume, prismVolume(ground, 2, -2), 1e-12);
}

TEST(ExtendTo, EverySheetFacesOutward) {
  const auto square = makeSoup({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 2, 3}});
  auto soup = together(square, insideOut(moved(square, {3, 0, 1})));
  EXPECT_DOUBLE_EQ(extendTo(soup, 2, 0).after.volume, 1 + 2);
  EXPECT_TRUE(reportOf(soup).isClean());
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto c = soup.polygon(i);
    const auto& p = soup.points;
    const double up = cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]).z;
    if (middleOf(soup, i).z == 0) {
      EXPECT_LT(up, 0) << i;
    }
  }
}

TEST(ExtendTo, ACaveStaysACave) {
  const auto cave = moved(insideOut(tessellation::box({1, 1, 0}, {2, 2, 1})), {0, 0, -1.5});
  const auto ground = together(terrain(12, 0.25), cave);
  for (auto soup : {ground, insideOut(ground)}) {
    EXPECT_NEAR(extendTo(soup, 2, -2).after.volume, prismVolume(terrain(12, 0.25), 2, -2) - 1,
                1e-12);
  }
}

TEST(ExtendTo, PointsOfNoFaceMayBeAnywhere) {
  const Box<double> box{{-1, -1, -2}, {5, 5, 3}};
  auto soup = terrain(3, 1);
  auto far = soup;
  far.points.emplace_back(1e200, -1e200, 0);
  EXPECT_EQ(extendToBox(far, box, 2).after, extendToBox(soup, box, 2).after);
}

TEST(ExtendTo, AHoleBecomesAShaft) {
  auto ground = terrain(12, 0.25);
  ground = onlyFaces(ground, [&](std::size_t i) {
    return length(middleOf(ground, i) - Vec3<double>{1.5, 1.5, 0}) > 0.7;
  });
  auto soup = ground;
  EXPECT_EQ(extendTo(soup, 2, -1.5).closed.count, 2U);
  const auto report = reportOf(soup);
  EXPECT_TRUE(report.isClosedOriented() && report.volume > 0) << report.summary();
  EXPECT_EQ(report.genus, 1);
  EXPECT_NEAR(report.volume, prismVolume(ground, 2, -1.5), 1e-12);
}

TEST(ExtendTo, AnApronReachesTheSidesOfABox) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool facesDown : {false, true}) {
      const auto ground = facesDown ? insideOut(terrain(12, 0.25, axis)) : terrain(12, 0.25, axis);
      Box<double> box;
      box.lower[axis] = -3;
      box.upper[axis] = 4;
      box.lower[(axis + 1) % 3] = -1;
      box.upper[(axis + 1) % 3] = 5;
      box.lower[(axis + 2) % 3] = -0.5;
      box.upper[(axis + 2) % 3] = 3.5;
      auto soup = ground;
      static_cast<void>(extendToBox(soup, box, axis));
      const auto report = reportOf(soup);
      EXPECT_TRUE(report.isClean()) << report.summary();
      EXPECT_EQ(report.genus, 0);
      const auto reached = soup.boundingBox();
      for (const int a : {(axis + 1) % 3, (axis + 2) % 3}) {
        EXPECT_EQ(reached.lower[a], box.lower[a]);
        EXPECT_EQ(reached.upper[a], box.upper[a]);
      }
      EXPECT_EQ(reached.lower[axis], -3);
      const auto apron = std::ranges::find(soup.patchNames, "apron") - soup.patchNames.begin();
      auto covered = onlyFaces(soup, [&](std::size_t i) { return soup.patches[i] == apron; });
      EXPECT_NEAR(prismVolume(covered, axis, -3) + std::abs(prismVolume(ground, axis, -3)),
                  report.volume, 1e-11);
      EXPECT_EQ(soup.patchNames, (std::vector<std::string>{"ground", "apron", "sides", "bottom"}));
      // No higher and no lower than the rim.
      for (const auto& p : soup.points) EXPECT_LT(std::abs(p[axis]), 3.5);
    }
  }
}

TEST(ExtendTo, AnApronNeedsOneRimAroundAllOthers) {
  const auto square = makeSoup({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 2, 3}});
  const Box<double> box{{-1, -1, 0}, {5, 5, 3}};
  // Beside it, across its rim, and with an edge or a corner in common.
  for (const Vec3<double>& place :
       {Vec3<double>{3, 0, 0}, {0.5, 0.25, 1}, {0, 3, 0}, {1, 0, 0}, {1, 1, 0}}) {
    const auto other = moved(square, place);
    for (const auto& two : {together(square, other), together(insideOut(other), square)}) {
      EXPECT_EQ(refusal(two, [&](auto& soup) { static_cast<void>(extendToBox(soup, box, 2)); }),
                ErrorKind::Topology)
          << place;
    }
  }
}

TEST(ExtendTo, RefusesOnePartAboveAnother) {
  const auto square = makeSoup({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 2, 3}});
  auto large = square;
  for (auto& p : large.points) p = {8 * p.x - 4, 8 * p.y - 4, p.z};
  const auto ground = together(large, moved(square, {6, 0, 0}));
  const auto down = [](PolygonSoup& soup) { static_cast<void>(extendTo(soup, 2, 0)); };
  EXPECT_EQ(refusal(ground, down), std::nullopt);
  for (const double height : {-0.5, 0.0, 1.0}) {
    const auto above = moved(square, {0, 0, height});
    for (const auto& sheet : {above, insideOut(above)}) {
      EXPECT_EQ(refusal(together(ground, sheet), down), ErrorKind::Topology) << height;
      const auto toBox = [](PolygonSoup& soup) {
        static_cast<void>(extendToBox(soup, {{-9, -9, 0}, {9, 9, 5}}, 2));
      };
      EXPECT_EQ(refusal(together(large, sheet), toBox), ErrorKind::Topology) << height;
    }
  }
  // Above a hole it is an island; the same sheet is not one if it also reaches beyond the hole.
  const auto withHole = onlyFaces(terrain(6, 0.5), [](std::size_t i) { return i / 2 != 14; });
  const auto island = moved(square, {1.1, 1.1, 2});
  auto smaller = island;
  const Vec3<double> corner{1.1, 1.1, 0};
  for (auto& p : smaller.points) p = corner + 0.3 * (p - corner);
  const auto under = [](PolygonSoup& soup) { static_cast<void>(extendTo(soup, 2, -2)); };
  EXPECT_EQ(refusal(together(withHole, smaller), under), std::nullopt);
  EXPECT_EQ(refusal(together(withHole, island), under), ErrorKind::Topology);
}

/// A surface of revolution without lids: open where the profile ends off the axis.
PolygonSoup vase(std::initializer_list<tessellation::ProfilePoint> profile) {
  const auto solid = tessellation::revolve({profile.begin(), profile.size()}, 24,
                                           tessellation::ProfileEnds::OnAxis);
  return onlyFaces(solid, [&](std::size_t i) { return solid.polygon(i).size() <= 4; });
}

TEST(ExtendTo, RefusesWallsThatWouldPassThroughTheSurface) {
  const auto to = [](double level) {
    return [level](PolygonSoup& soup) {
      static_cast<void>(extendTo(soup, 2, level));
      const DcelMesh<double> solid(soup);
      EXPECT_TRUE(check(solid).isClosedOriented());
      EXPECT_FALSE(findSelfIntersections(solid));
    };
  };
  struct Case {
    PolygonSoup soup;
    bool mayGoDown;
    bool mayGoUp;
  };
  const std::vector<Case> cases{
      // A funnel is a terrain with a hole; an hourglass with a waist narrower than its foot is one
      // that overhangs, but not its walls downward; with a belly it is the other way round.
      {vase({{1, 0}, {2, 2}}), true, true},
      {vase({{1, 0}, {0.5, 1}, {2, 2}}), true, false},
      {vase({{1, 0}, {3, 1}, {2, 2}}), false, true},
      // A bowl whose edge is bent outward, one whose edge is bent in, and that upside down.
      {vase({{0, 0}, {2, 1}, {3, 0.5}}), true, true},
      {vase({{0, 0}, {3, 1}, {2, 2}}), false, true},
      {vase({{0, 2}, {3, 1}, {2, 0}}), true, false},
      // A tank: walls down from its rim would lie on its sides.
      {onlyFaces(cube(), [](std::size_t i) { return middleOf(cube(), i).z < 0.9; }), false, true},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const auto& soup : {cases[i].soup, insideOut(cases[i].soup)}) {
      EXPECT_EQ(!refusal(soup, to(-1)), cases[i].mayGoDown) << i;
      EXPECT_EQ(!refusal(soup, to(5)), cases[i].mayGoUp) << i;
    }
  }
}

TEST(ExtendTo, RefusesAnApronThatWouldPassThroughTheSurface) {
  // An umbrella, whose edge hangs down below its rim: the apron would pass through what is above.
  const auto umbrella = vase({{0, 2}, {3, -0.5}, {2, 0}});
  const Box<double> box{{-5, -5, -1}, {5, 5, 3}};
  EXPECT_EQ(refusal(umbrella, [](auto& soup) { static_cast<void>(extendTo(soup, 2, -1)); }),
            std::nullopt);
  EXPECT_EQ(refusal(umbrella, [&](auto& soup) { static_cast<void>(extendToBox(soup, box, 2)); }),
            ErrorKind::Topology);
  const auto mushroom = vase({{0, 2}, {3, 0.5}, {2, 0}});
  EXPECT_EQ(refusal(mushroom, [&](auto& soup) { static_cast<void>(extendToBox(soup, box, 2)); }),
            std::nullopt);
}

TEST(ExtendTo, AnApronLeavesHolesAndIslandsInThem) {
  const auto ground = terrain(6, 0.5);
  // A hole of one triangle touches the right side at a point, a larger one has an island.
  const auto parts = onlyFaces(ground, [&](std::size_t i) {
    const auto from = abs(middleOf(ground, i) - Vec3<double>{1.25, 1.25, 0});
    const double steps = std::max(from.x, from.y);
    return i != 2 * (6 * 4 + 5) + 1 && (steps > 0.75 || steps < 0.25);
  });
  for (const auto& soup : {parts, insideOut(parts)}) {
    auto solid = soup;
    const auto report = extendToBox(solid, {{-1, -1, -2}, {4, 4, 3}}, 2);
    EXPECT_EQ(report.closed.count, 4U);
    const auto above = onlyFaces(solid, [&](std::size_t i) {
      return solid.patches[i] < 2;  // the ground and the apron
    });
    EXPECT_NEAR(report.after.volume, std::abs(prismVolume(above, 2, -2)), 1e-12);
    EXPECT_TRUE(reportOf(solid).isClosedOriented()) << reportOf(solid).summary();
  }
}

TEST(ExtendTo, RefusesWhatIsNoTerrain) {
  const auto down = [](PolygonSoup& soup) { static_cast<void>(extendTo(soup, 2, -9)); };
  EXPECT_EQ(refusal(cube(), down), ErrorKind::Topology);
  EXPECT_EQ(refusal(flipped(terrain(4, 1), 9), down), ErrorKind::Topology);
  EXPECT_EQ(refusal(twistedBand(48, 0.3, 2), down), ErrorKind::Topology);
  // Two that touch at a corner and face different ways: the walls below it belong to both.
  const auto one = terrain(2, 1);
  const auto other = insideOut(moved(one, {2, 2, heightAt(2, 2) - heightAt(0, 0)}));
  EXPECT_EQ(refusal(weldedTogether(one, other), down), ErrorKind::Topology);
  const auto ground = terrain(4, 1);
  EXPECT_EQ(refusal(together(ground, moved(ground, {2, 2, 1})), down), ErrorKind::Topology);
  EXPECT_EQ(refusal(ground, [](auto& soup) { static_cast<void>(extendTo(soup, 2, 0)); }),
            ErrorKind::Argument);
  EXPECT_EQ(refusal(ground, [](auto& soup) { static_cast<void>(extendTo(soup, 3, -9)); }),
            ErrorKind::Argument);
  EXPECT_EQ(refusal(ground, [](auto& soup) { static_cast<void>(extendTo(soup, 2, -HUGE_VAL)); }),
            ErrorKind::Argument);
  const Box<double> tight{{0, -1, -9}, {5, 5, 9}};
  EXPECT_EQ(refusal(ground, [&](auto& soup) { static_cast<void>(extendToBox(soup, tight, 2)); }),
            ErrorKind::Topology);
  EXPECT_EQ(
      refusal(ground, [](auto& soup) { static_cast<void>(extendToBox(soup, Box<double>{}, 2)); }),
      ErrorKind::Argument);
}

}  // namespace
}  // namespace cutwater::test
