#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Tpms/SurfaceDistance.hpp"

namespace cutwater::test {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Points of a cell in radians, every other one within `near` of a sample.
std::vector<Vec3<double>> probes(const SurfaceDistance& surface, int count, double near) {
  RandomPoints<double> random(0.5, 17);
  std::vector<Vec3<double>> points;
  for (int i = 0; i < count; ++i) {
    const auto r = random.next();
    const auto& samples = surface.samples();
    const auto j =
        static_cast<std::size_t>((random.next().x + 0.5) * static_cast<double>(samples.size() - 1));
    points.push_back(i % 2 == 0 ? kTurn * r : samples[j] + 2 * near * r);
  }
  return points;
}

/// Cells of 2 pi: lengths are radians.
TpmsSolid<double> solidOf(const TpmsPattern& pattern, TpmsPart part, double level) {
  return {TpmsField<double>(pattern, kTurn), part, level};
}

TEST(LevelDistancesTest, NeverExceedTheDistanceAndAreNearlyThatNearTheSurface) {
  const auto all = TpmsPattern::all();
  const auto plain = plainPatterns();
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(plain[i].name);
    const SurfaceDistance surface(plain[i].value, 0);
    const auto solid = solidOf(all[i], TpmsPart::ChannelA, 0);
    std::vector<double> ratios;
    std::vector<double> firstOrder;
    int violations = 0;
    for (const auto& p : probes(surface, scaled(10000), 0.05)) {
      const double bound = std::abs(solid.signedDistance(p));
      const double distance = surface.upperBound(p);
      violations += bound <= distance + 1e-11 ? 0 : 1;
      if (distance > 0.05 || distance < 1e-6) continue;
      ratios.push_back(bound / distance);
      firstOrder.push_back(std::abs(surface.value(p)) / plain[i].lipschitz / distance);
    }
    EXPECT_EQ(violations, 0);
    RecordProperty(plain[i].name, std::to_string(median(ratios)));
    ASSERT_GT(ratios.size(), 3000U);
    EXPECT_GE(median(ratios), 0.95);
    EXPECT_LE(median(ratios), 1);
    EXPECT_LT(median(firstOrder), 0.9);  // what it would be by the Lipschitz constant alone
  }
}

TEST(LevelDistancesTest, NorDoThoseToWalls) {
  const auto all = TpmsPattern::all();
  const auto plain = plainPatterns();
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(plain[i].name);
    const double pinch = std::min(all[i].pinch(TpmsChannel::A), all[i].pinch(TpmsChannel::B));
    const SurfaceDistance middle(plain[i].value, 0);
    // Near where the channels break up, too: there slopes vanish.
    for (const double level : {0.4 * pinch, 0.98 * pinch}) {
      const SurfaceDistance inA(plain[i].value, level);
      const SurfaceDistance inB(plain[i].value, -level);
      const auto wall = solidOf(all[i], TpmsPart::Wall, level);
      const auto half = solidOf(all[i], TpmsPart::WallInA, level);
      int violations = 0;
      double most = 0;
      for (const auto& p : probes(inA, scaled(1000), 0.3)) {
        const double toA = inA.upperBound(p);
        const double bound = std::abs(wall.signedDistance(p));
        violations += bound <= std::min(toA, inB.upperBound(p)) + 1e-11 ? 0 : 1;
        const double ofHalf = std::abs(half.signedDistance(p));
        violations += ofHalf <= std::min(toA, middle.upperBound(p)) + 1e-11 ? 0 : 1;
        most = std::max(most, bound);
      }
      EXPECT_EQ(violations, 0);
      EXPECT_GT(most, 0.1);
    }
  }
}

TEST(LevelDistancesTest, TheValueOverItsSlopeIsNoBound) {
  const auto plain = plainPatterns();
  const auto excess = [&](std::size_t i) {
    const SurfaceDistance surface(plain[i].value, 0);
    RandomPoints<double> random(0.5 * kTurn, 3);
    std::vector<double> ratios;
    for (int k = 0; k < 4000; ++k) {
      const auto p = random.next();
      ratios.push_back(std::abs(surface.value(p)) / length(surface.gradient(p)) /
                       surface.upperBound(p));
    }
    return median(ratios) - 1;
  };
  EXPECT_NEAR(excess(0), 0.137, 0.02);   // gyroid
  EXPECT_NEAR(excess(6), -0.085, 0.02);  // Neovius
}

/// (sqrt(s^2 + 2 H |psi|) - s) / H loses all its digits there.
TEST(LevelDistancesTest, KeepTheirDigitsNextToTheSurface) {
  const auto solid = solidOf(TpmsPattern::schwarzP(), TpmsPart::ChannelB, 0);
  const double root = 0.25 * kTurn;  // cos x + cos y + cos z = 0 with all of them 0
  for (const double away : {1e-3, 1e-8, 1e-12}) {
    const double d = away / std::sqrt(3.0);
    const double exact = away;
    EXPECT_NEAR(solid.signedDistance({root + d, root + d, root + d}), -exact, 1e-5 * exact + 4e-16);
  }
}

}  // namespace
}  // namespace cutwater::test
