#include <Cutwater/CutCells/Detail/Curved/LineCrossings.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

constexpr double kNear = 1e-14;

TEST(LineCrossingsTest, OfBallsAreThoseOfTheFormula) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(-1, 1);
  const Vec3<double> center{0.1, -0.2, 0.05};
  const double radius = 0.7;
  int crossings = 0;
  int turns = 0;
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto field = fluidBeside<double>(Sphere<double>(center, radius), side);
    std::vector<AxisLine> lines;
    for (int i = 0; i < scaled(6000); ++i) {
      const int axis = i % 3;
      lines.push_back({{at(random), at(random), at(random)}, 0, axis});
      lines.back().end = lines.back().start[axis] + 0.5 * (1 + at(random));
    }
    LineCrossings found(*field);
    found.find(lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto& line = lines[i];
      auto offset = line.start - center;
      offset[line.axis] = 0;
      const double squared = radius * radius - lengthSquared(offset);
      std::vector<double> expected;
      for (const double sign : {-1.0, 1.0}) {
        if (squared < 0) break;
        const double root = center[line.axis] + sign * std::sqrt(squared);
        if (root > line.start[line.axis] && root < line.end) expected.push_back(root);
      }
      ASSERT_EQ(found.of(i).size(), expected.size()) << i;
      for (std::size_t n = 0; n < expected.size(); ++n) {
        // Along lines that graze the ball, rounding moves the crossing more.
        EXPECT_NEAR(found.of(i)[n], expected[n], kNear / std::sqrt(squared));
        ++crossings;
      }
      if (expected.size() == 2) ++turns;
      EXPECT_EQ(found.startsInFluid(i),
                (length(line.start - center) > radius) == (side == FluidSide::Outside));
    }
  }
  EXPECT_GT(crossings, 1000);
  EXPECT_GT(turns, 50);
}

/// A plate of a thousandth of a line's length, and a wedge whose sides have very different slopes.
TEST(LineCrossingsTest, PassThroughThinPlatesAndSlivers) {
  const auto plate =
      fluidBeside<double>(Cuboid<double>({-2, -2, 0.3}, {2, 2, 0.301}), FluidSide::Outside);
  LineCrossings found(*plate);
  const AxisLine through{{0.1, 0.2, 0}, 1, 2};
  found.find({&through, 1});
  ASSERT_EQ(found.of(0).size(), 2U);
  EXPECT_NEAR(found.of(0)[0], 0.3, kNear);
  EXPECT_NEAR(found.of(0)[1], 0.301, kNear);

  Cuboid<double> box({-2, -2, -2}, {0, 2, 0.6});
  box.rotate(0.3, 1);
  const auto tilted = fluidBeside<double>(box, FluidSide::Inside);
  const double edge = 0.6 * std::sin(0.3 * std::numbers::pi / 180);
  int seen = 0;
  LineCrossings slivers(*tilted);
  for (int i = 0; i < 100; ++i) {
    // From below, through the side and then the top, which is at 0.6.
    const AxisLine line{{0.0002 + 0.00003 * i, 0, 0}, 1, 2};
    slivers.find({&line, 1});
    const bool isBeside = tilted->value(line.start) <= 0;
    EXPECT_EQ(slivers.of(0).size(), isBeside ? 2U * (line.start.x < edge ? 1U : 0U) : 1U) << i;
    seen += slivers.of(0).size() == 2 ? 1 : 0;
  }
  EXPECT_GT(seen, 50);
}

/// Between two bars, seen from within both, where the nearest walls are along the line.
TEST(LineCrossingsTest, GapsAreFoundThatNoDerivativeLeadsTo) {
  const Solid<double> solid = Solid<double>(Cuboid<double>({-2, -0.1, -2}, {0.4, 0.1, 2})) |
                              Cuboid<double>({0.55, -0.1, -2}, {2, 0.1, 2});
  const auto outside = fluidBeside<double>(solid, FluidSide::Outside);
  const auto bars = fieldIn(*outside, {{-1, -1, -1}, {1, 1, 1}});
  // The same as values alone, without the surfaces that they come from.
  const auto value = [&](const Vec3<double>& p) { return solid.signedDistance(p); };
  const auto values = fluidBeside<double>(
      FunctionSDF<double, decltype(value)>(value, solid.guarantee()), FluidSide::Outside);
  const std::array lines{AxisLine{{0, 0.03, 0.1}, 1, 0}, AxisLine{{-0.7, 0.03, 0.1}, 0.3, 0},
                         AxisLine{{0, 0.03, 0.1}, 1, 0, /*mayTurn=*/false}};
  for (const auto* field : {bars.get(), values.get()}) {
    LineCrossings found(*field);
    found.find(lines);
    ASSERT_EQ(found.of(0).size(), 2U);
    EXPECT_NEAR(found.of(0)[0], 0.4, kNear);
    EXPECT_NEAR(found.of(0)[1], 0.55, kNear);
    EXPECT_TRUE(found.of(1).empty());
    // Surfaces are asked, whatever is supposed of the values together.
    EXPECT_EQ(found.of(2).size(), field == bars.get() ? 2U : 0U);
  }
}

/// Along a wall, as near as it may be, through plates that are as thin as they may be; and through
/// more than two.
TEST(LineCrossingsTest, PlatesBesideAWallAreFoundByTheirSurfaces) {
  auto solid = Solid<double>(Cuboid<double>({-1, 0, -1}, {2, 1, 2}));
  std::vector<double> expected;
  for (const double at : {0.2, 0.41, 0.7}) {
    for (const double end : {at, at + 1e-7}) expected.push_back(end);
    solid = solid | Cuboid<double>({at, -1, -1}, {at + 1e-7, 1, 2});
  }
  for (const bool isUnion : {true, false}) {
    const auto side = isUnion ? FluidSide::Outside : FluidSide::Inside;
    const auto whole = fluidBeside<double>(isUnion ? solid : ~solid, side);
    const auto field = fieldIn(*whole, {{0, -1, 0}, {1, 1, 1}});
    LineCrossings found(*field);
    for (const double gap : {0.3, 0.01, 1e-4, 1e-9}) {
      const AxisLine line{{0, -gap, 0.5}, 1, 0};
      found.find({&line, 1});
      ASSERT_EQ(found.of(0).size(), expected.size()) << gap;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(found.of(0)[i], expected[i], kNear) << gap;
      }
    }
  }
}

TEST(LineCrossingsTest, WhatLiesInTheSurfaceIsBody) {
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto field = fluidBeside<double>(Cuboid<double>({0, 0, 0}, {1, 1, 1}), side);
    const AxisLine along{{0.2, 0.3, 1}, 0.8, 0};
    LineCrossings found(*field);
    found.find({&along, 1});
    EXPECT_FALSE(found.startsInFluid(0));
    EXPECT_TRUE(found.of(0).empty());
    const AxisLine away{{0.2, 0.3, 1}, side == FluidSide::Outside ? 1.5 : 1.0, 2};
    found.find({&away, 1});
    EXPECT_FALSE(found.startsInFluid(0));
    if (side == FluidSide::Outside) {
      ASSERT_EQ(found.of(0).size(), 1U);
      EXPECT_EQ(found.of(0)[0], 1);
    }
  }
}

TEST(LineCrossingsTest, DependOnTheLineAlone) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> at(-0.5, 0.5);
  const Solid<double> solid =
      Torus<double>({0.01, 0.02, 0}, {1, 2, 3}, 0.3, 0.12) | Sphere<double>({0.2, 0, 0}, 0.2);
  const auto field = fluidBeside(solid, FluidSide::Outside);
  std::vector<AxisLine> lines;
  for (int i = 0; i < 500; ++i) {
    lines.push_back({{at(random), at(random), at(random)}, 0.5, i % 3});
    lines.back().start[i % 3] = -0.5;
  }
  LineCrossings all(*field);
  all.find(lines);
  LineCrossings one(*field);
  std::size_t count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    one.find({&lines[i], 1});
    EXPECT_TRUE(std::ranges::equal(one.of(0), all.of(i))) << i;
    count += one.of(0).size();
  }
  EXPECT_GT(count, 300U);
}

}  // namespace
}  // namespace cutwater::test
