// The code of Docs/tpms.md.
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Tpms/TwoFluids.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(DocsTest, PartsOfAPattern) {
  // [DOCS
  // A gyroid of 5 mm cells: its wall |F| < 0.3, and one of the networks.
  const TpmsField<double> gyroid(TpmsPattern::gyroid(), 5);
  const TpmsSolid<double> wall(gyroid, TpmsPart::Wall, 0.3);
  const TpmsSolid<double> network(gyroid, TpmsPart::ChannelA, 0);
  const Solid<double> ball = Sphere<double>({0, 0, 0}, 20) & wall;

  // Every point within 0.2 mm of the surface F = 0.
  const MetricWall<double> even(TpmsPattern::gyroid(), 5, 0.2);
  // DOCS]
  EXPECT_LT(wall.signedDistance({0, 0, 0}), 0);
  EXPECT_EQ(network.signedDistance({0, 0, 0}), 0);
  EXPECT_NEAR(even.signedDistance({0, 0, 0}), -0.2, 1e-9);
  EXPECT_GT(ball.signedDistance({30, 0, 0}), 9);
}

TEST(DocsTest, PiecesMix) {
  // [DOCS
  // From a gyroid at the bottom to Schwarz P at the top, twelve cells around an axis, shifted at
  // random, as a wall that thickens upwards.
  const Plane<double> ground({0, 0, 0}, {0, 0, 1});
  const auto map =
      TpmsMap<double>::cylindrical({.radialSize = 5, .cellsPerTurn = 12, .axialSize = 5})
          .deformed({.amplitude = 0.3, .spacing = {8, 8, 8}, .seed = 7});
  const TpmsTransition<double> transition{
      .from = TpmsPattern::gyroid(),
      .to = TpmsPattern::schwarzP(),
      .weight = GradedValue<double>::byValueOf(ground, {.start = 0, .end = 1, .over = 30})};
  const TpmsSolid<double> wall(
      TpmsField<double>(transition, map), TpmsPart::Wall,
      GradedValue<double>::byValueOf(ground, {.start = 0.2, .end = 0.5, .over = 30}));
  // DOCS]
  EXPECT_EQ(wall.guarantee().outside, Quality::LowerBound);
  EXPECT_EQ(wall.guarantee().lipschitz, 1.0);
}

TEST(DocsTest, TwoFluidsInABox) {
  // [DOCS
  const auto channels = TpmsChannels<double>::of(MetricWall<double>(TpmsPattern::gyroid(), 5, 0.2));
  const auto exchanger = twoFluidsIn<double>({{0, 0, 0}, {30, 30, 20}}, channels,
                                             {.axisOfA = 0, .axisOfB = 1, .capThickness = 0.5});
  const double hot = exchanger.a.signedDistance({15, 15, 10});
  const double solid = exchanger.wall.signedDistance({15, 15, 10});
  // DOCS]
  EXPECT_LT(solid, 0);
  EXPECT_GE(hot, 0);
}

}  // namespace
}  // namespace cutwater::test
