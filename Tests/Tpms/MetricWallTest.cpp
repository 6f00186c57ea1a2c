#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Tpms/Detail/PatternDistance.hpp>
#include <Cutwater/Tpms/MetricWall.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Tpms/SurfaceDistance.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class MetricWallTest : public ::testing::Test {};
TYPED_TEST_SUITE(MetricWallTest, Precisions);

/// Thin enough for distances to be certain to rounding.
TYPED_TEST(MetricWallTest, WallsOfEveryPatternKeepTheirGuarantee) {
  using T = TypeParam;
  for (const auto& pattern : TpmsPattern::all()) {
    SCOPED_TRACE(pattern.name());
    const double certain = detail::PatternDistance::certainReach(pattern) / kTurn;
    const MetricWall<T> wall(pattern, 1, static_cast<T>(0.6 * certain));
    EXPECT_LE(wall.tolerance(), T(1e-9));
    expectGuarantee(wall, 0.6, {.probes = 300, .lines = 16, .polish = false});
  }
}

/// Nearly what fills the smaller channel; of every pattern on long runs.
TYPED_TEST(MetricWallTest, ThickWallsKeepTheirGuarantee) {
  using T = TypeParam;
  const auto all = TpmsPattern::all();
  for (const auto& pattern : std::span(all).first(scaled(1) > 1 ? all.size() : 2)) {
    SCOPED_TRACE(pattern.name());
    const double most =
        std::min(pattern.inscribedRadius(TpmsChannel::A), pattern.inscribedRadius(TpmsChannel::B));
    const MetricWall<T> wall(pattern, 1, static_cast<T>(0.8 * most));
    EXPECT_LE(wall.tolerance(), T(1.0001e-4));
    expectGuarantee(wall, 0.6, {.probes = 50, .lines = 8, .polish = false});
  }
}

TYPED_TEST(MetricWallTest, ThicknessesByThePlaceKeepTheirGuarantee) {
  using T = TypeParam;
  const auto half =
      GradedValue<T>::byValueOf(Plane<T>({0, 0, T(-0.5)}, {0, 0, 1}), {T(0.02), T(0.08), 1});
  MetricWall<T> wall(TpmsPattern::gyroid(), 1, half);
  wall.rotate(20, {1, 2, 3});
  expectGuarantee(wall, 0.7, {.probes = 1000, .lines = 24});
}

/// The zero set of the bound, less half the thickness, is another wall.
TEST(MetricWallsTest, WallsAreAsThickAsTheySay) {
  const auto pattern = TpmsPattern::gyroid();
  const SurfaceDistance surface(plainPatterns()[0].value, 0);
  constexpr double kHalf = 0.4;
  const MetricWall<double> wall(pattern, kTurn, kHalf);
  const TpmsSolid<double> bound(TpmsField<double>(pattern, kTurn), TpmsPart::ChannelB, 0.0);
  double most = 0;
  double least = 1;
  for (std::size_t i = 0; i < surface.samples().size(); i += 50) {
    const auto& q = surface.samples()[i];
    const auto n = normalized(surface.gradient(q));
    for (const double side : {-1.0, 1.0}) {
      ASSERT_NEAR(wall.signedDistance(q + side * kHalf * n), 0, 1e-7);
      ASSERT_LT(wall.signedDistance(q + side * (kHalf - 1e-6) * n), 0);
      ASSERT_GT(wall.signedDistance(q + side * (kHalf + 1e-6) * n), 0);
      ASSERT_NEAR(wall.signedDistance(q + side * 0.1 * n), 0.1 - kHalf, 1e-7);
      // How far out the bound tells this distance.
      double away = kHalf;
      while (std::abs(bound.signedDistance(q + side * away * n)) < kHalf) away += 1e-3;
      most = std::max(most, away / kHalf);
      least = std::min(least, kHalf / away);
    }
  }
  EXPECT_GT(most, 1.1);
  EXPECT_LT(most, 1.3);
  EXPECT_LT(least, 0.98);
}

/// Thicker than the surface curves: ball by ball along lines from one channel into the other.
TEST(MetricWallsTest, ThickWallsAreAsThickAsTheySay) {
  const auto pattern = TpmsPattern::neovius();
  const SurfaceDistance surface(plainPatterns()[6].value, 0);
  const MetricWall<double> wall(pattern, kTurn, 1.2);
  RandomPoints<double> random(0.5 * kTurn, 9);
  int inside = 0;
  for (int i = 0; i < scaled(1000); ++i) {
    const auto p = random.next();
    const double exact = surface.leastUpperBound(p) - 1.2;
    const double value = wall.signedDistance(p);
    if (std::abs(exact) > 1e-3) {
      EXPECT_EQ(value < 0, exact < 0) << p;
    }
    if (exact < 0) {
      EXPECT_NEAR(value, exact, 1e-3) << p;
    }
    inside += exact < 0 ? 1 : 0;
  }
  EXPECT_GT(inside, scaled(200));
  EXPECT_LT(inside, scaled(900));
}

TEST(MetricWallsTest, RefuseWhatFillsAChannel) {
  const auto make = [](const TpmsPattern& pattern, double cell, GradedValue<double> half) {
    return MetricWall<double>(pattern, cell, std::move(half));
  };
  const auto p = TpmsPattern::schwarzP();  // the largest ball: sqrt(3) / 4 of the cell
  EXPECT_NO_THROW(make(p, 2, 0.85));
  EXPECT_THROW(make(p, 2, 0.87), Error);
  EXPECT_THROW(make(p, 2, 0), Error);
  EXPECT_THROW(make(p, 2, -0.1), Error);
  EXPECT_THROW(make(p, 0, 0.1), Error);
  EXPECT_THROW(make(p, std::nan(""), 0.1), Error);
  const auto graded =
      GradedValue<double>::byValueOf(Plane<double>({0, 0, 0}, {0, 0, 1}), {0.1, 1, 1});
  EXPECT_THROW(make(p, 2, graded), Error);
  EXPECT_NO_THROW(make(p, 3, graded));
}

}  // namespace
}  // namespace cutwater::test
