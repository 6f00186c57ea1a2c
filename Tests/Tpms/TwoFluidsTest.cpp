#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Tpms/Detail/PatternDistance.hpp>
#include <Cutwater/Tpms/TwoFluids.hpp>

#include <numbers>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class TwoFluidsTest : public ::testing::Test {};
TYPED_TEST_SUITE(TwoFluidsTest, Precisions);

/// Every point of the domain, and none else, is in one of the three; values where they meet are the
/// same but for the sign.
template <typename T>
void expectFit(const TwoFluids<T>& parts, const Solid<T>& domain, T extent,
               int probes = scaled(5000)) {
  RandomPoints<T> random(extent);
  std::array<int, 3> found{};
  for (int i = 0; i < probes; ++i) {
    const auto p = random.next();
    const T a = parts.a.signedDistance(p);
    const T wall = parts.wall.signedDistance(p);
    const T b = parts.b.signedDistance(p);
    const std::array<bool, 3> in{a < 0, wall < 0, b < 0};
    const T toDomain = domain.signedDistance(p);
    ASSERT_EQ(in[0] + in[1] + in[2], toDomain < 0 ? 1 : 0) << p;
    const T nearest = std::min(a, b);
    if (toDomain < -std::abs(nearest)) {
      ASSERT_EQ(wall, -nearest) << p;
    }
    for (std::size_t k = 0; k < 3; ++k) found[k] += in[k] ? 1 : 0;
    const Box<T> box{p, p + Vec3<T>{T(0.1), T(0.05), T(0.1)}};
    int inside = 0;
    for (const auto* part : {&parts.a, &parts.wall, &parts.b}) {
      inside += part->classify(box) == BoxClass::Inside ? 1 : 0;
    }
    ASSERT_LE(inside, 1) << p;
  }
  for (const int count : found) EXPECT_GT(count, probes / 50);
}

TYPED_TEST(TwoFluidsTest, PartsOfABoxFitAndKeepTheirGuarantee) {
  using T = TypeParam;
  const Box<T> box{{-1, -1, -1}, {1, 1, 1}};
  const auto channels = TpmsChannels<T>::of({TpmsPattern::gyroid(), T(1)}, T(0.3));
  const auto parts =
      twoFluidsIn<T>(box, channels, {.axisOfA = 0, .axisOfB = 2, .capThickness = T(0.1)});
  expectFit<T>(parts, Cuboid<T>(box), T(1.1));
  for (const auto* part : {&parts.a, &parts.wall, &parts.b}) {
    EXPECT_EQ(part->guarantee().outside, Quality::LowerBound);
    expectGuarantee(*part, 1.3, {.probes = 800, .lines = 24});
  }
}

TYPED_TEST(TwoFluidsTest, PartsOfEveryPatternFit) {
  using T = TypeParam;
  const Box<T> box{{-1, -1, -1}, {1, 1, 1}};
  const CrossFlow<T> flow{.axisOfA = 2, .axisOfB = 1, .capThickness = T(0.05)};
  for (const auto& pattern : TpmsPattern::all()) {
    SCOPED_TRACE(pattern.name());
    const auto level = static_cast<T>(
        0.7 * std::min(pattern.pinch(TpmsChannel::A), pattern.pinch(TpmsChannel::B)));
    const auto channels = TpmsChannels<T>::of({pattern, T(0.8)}, level);
    expectFit<T>(twoFluidsIn<T>(box, channels, flow), Cuboid<T>(box), T(1.1));
    const double certain = detail::PatternDistance::certainReach(pattern) / (2 * std::numbers::pi);
    const MetricWall<T> even(pattern, T(0.8), static_cast<T>(0.5 * certain));
    expectFit<T>(twoFluidsIn<T>(box, TpmsChannels<T>::of(even), flow), Cuboid<T>(box), T(1.1),
                 scaled(400));
  }
}

TYPED_TEST(TwoFluidsTest, EndsAreOpenForOneFluidAndClosedForTheOther) {
  using T = TypeParam;
  const Box<T> box{{-1, -1, -1}, {1, 1, 1}};
  const auto channels = TpmsChannels<T>::of({TpmsPattern::gyroid(), T(1)}, T(0.3));
  const auto parts =
      twoFluidsIn<T>(box, channels, {.axisOfA = 0, .axisOfB = 2, .capThickness = T(0.1)});
  // How much of each face of the box the fluids see.
  std::array<std::array<int, 2>, 3> open{};
  RandomPoints<T> random(T(0.85), 3);
  for (int i = 0; i < 2000; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      auto p = random.next();
      p[axis] = i % 2 == 0 ? T(0.95) : T(-0.95);
      open[static_cast<std::size_t>(axis)][0] += parts.a.signedDistance(p) < 0 ? 1 : 0;
      open[static_cast<std::size_t>(axis)][1] += parts.b.signedDistance(p) < 0 ? 1 : 0;
    }
  }
  EXPECT_GT(open[0][0], 400);
  EXPECT_EQ(open[0][1], 0);
  EXPECT_EQ(open[1][0] + open[1][1], 0);
  EXPECT_EQ(open[2][0], 0);
  EXPECT_GT(open[2][1], 400);
}

TYPED_TEST(TwoFluidsTest, PartsOfACylinderFit) {
  using T = TypeParam;
  const auto map = TpmsMap<T>::cylindrical({T(0.5), 6, T(0.5)});
  const auto channels = TpmsChannels<T>::of({TpmsPattern::schwarzD(), map}, T(0.2));
  const auto parts = twoFluidsIn<T>({.radius = 1, .z = {-1, 1}, .capThickness = T(0.1)}, channels);
  expectFit<T>(parts, parts.a | parts.wall | parts.b, T(1.1));
  RandomPoints<T> random(T(0.6), 3);
  std::array<int, 4> open{};
  for (int i = 0; i < 2000; ++i) {
    auto p = random.next();
    p.z = T(0.95);
    open[0] += parts.a.signedDistance(p) < 0 ? 1 : 0;
    open[1] += parts.b.signedDistance(p) < 0 ? 1 : 0;
    auto q = random.next();
    const T toMantle = T(0.95) / std::sqrt(q.x * q.x + q.y * q.y);
    q = {q.x * toMantle, q.y * toMantle, q.z};
    open[2] += parts.a.signedDistance(q) < 0 ? 1 : 0;
    open[3] += parts.b.signedDistance(q) < 0 ? 1 : 0;
  }
  EXPECT_GT(open[0], 400);
  EXPECT_EQ(open[1], 0);
  EXPECT_EQ(open[2], 0);
  EXPECT_GT(open[3], 400);
}

TYPED_TEST(TwoFluidsTest, PartsBesideAWallOfEvenThicknessFit) {
  using T = TypeParam;
  MetricWall<T> wall(TpmsPattern::schwarzP(), 1, T(0.08));
  wall.translate({T(0.1), 0, 0});
  const Cuboid<T> box({-1, -1, -1}, {1, 1, 1});
  const auto parts = twoFluids<T>(box, TpmsChannels<T>::of(wall));
  expectFit<T>(parts, box, T(1.1));
  RandomPoints<T> random(T(0.9), 4);
  for (int i = 0; i < 300; ++i) {
    const auto p = random.next();
    EXPECT_EQ(parts.wall.signedDistance(p) < 0, wall.signedDistance(p) < 0) << p;
  }
}

TEST(TwoFluidsPatchesTest, TellWhereFluidsComeInAndWhatClosesThem) {
  auto sides = TpmsChannels<double>::of({TpmsPattern::gyroid(), 1}, 0.3);
  sides.a = named(sides.a, "side of A");
  const auto nameAt = [](const Solid<double>& solid, const Vec3<double>& p) {
    const auto nearest = solid.closestPoint(p);
    EXPECT_LT(length(nearest.point - p), 1e-9);
    return solid.patchNames().at(nearest.owner.patch);
  };
  // At z = 1 the fluid comes in, at x = 0.9, or that far from the axis, a cap is before it.
  const auto expectNames = [&](const Solid<double>& a, bool isRound) {
    int ends = 0;
    int caps = 0;
    int walls = 0;
    for (int i = 0; i < 25; ++i) {
      for (int j = 0; j < 15; ++j) {
        const double u = 0.04 * i - 0.5;
        const double v = 0.04 * j - 0.3;
        if (a.signedDistance({u, v, 0.98}) < -0.015) {
          EXPECT_EQ(nameAt(a, {u, v, 1}), "outside");
          ++ends;
        }
        const Vec3<double> place{isRound ? std::sqrt(0.81 - v * v) : 0.9, v, u};
        if (a.signedDistance(0.98 * place) < -0.015) {
          EXPECT_EQ(nameAt(a, place), "caps");
          ++caps;
        }
        const auto nearest = a.closestPoint({u, v, 0.1});
        walls += a.patchNames().at(nearest.owner.patch) == "side of A" ? 1 : 0;
      }
    }
    EXPECT_GT(std::min({ends, caps, walls}), 20);
  };
  expectNames(twoFluidsIn<double>({{-1, -1, -1}, {1, 1, 1}}, sides,
                                  {.axisOfA = 2, .axisOfB = 1, .capThickness = 0.1})
                  .a,
              false);
  expectNames(twoFluidsIn<double>({.radius = 1, .z = {-1, 1}, .capThickness = 0.1}, sides).a, true);
}

TEST(TwoFluidsErrorsTest, RefusesFlowsThatAreNone) {
  const auto channels = TpmsChannels<double>::of({TpmsPattern::gyroid(), 1.0}, 0.3);
  const Box<double> box{{0, 0, 0}, {1, 2, 3}};
  const auto make = [&](int a, int b, double cap) {
    return twoFluidsIn<double>(box, channels, {.axisOfA = a, .axisOfB = b, .capThickness = cap});
  };
  EXPECT_NO_THROW(make(0, 1, 0.1));
  EXPECT_THROW(make(0, 0, 0.1), Error);
  EXPECT_THROW(make(-1, 0, 0.1), Error);
  EXPECT_THROW(make(0, 3, 0.1), Error);
  EXPECT_THROW(make(0, 1, 0), Error);
  EXPECT_THROW(make(0, 1, 0.5), Error);
  const auto inCylinder = [&](double height, double cap) {
    return twoFluidsIn<double>({.radius = 1, .z = {0, height}, .capThickness = cap}, channels);
  };
  EXPECT_THROW(inCylinder(1, 0.5), Error);
  EXPECT_THROW(inCylinder(5, 1), Error);
  EXPECT_THROW((void)TpmsChannels<double>::of({TpmsPattern::gyroid(), 1.0}, 1.5), Error);
}

}  // namespace
}  // namespace cutwater::test
