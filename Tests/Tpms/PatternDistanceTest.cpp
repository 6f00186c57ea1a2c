#include <Cutwater/Tpms/PatternDistance.hpp>

#include <gtest/gtest.h>

#include "Support/AllocationCount.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Tpms/SurfaceDistance.hpp"

namespace cutwater::test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Thin walls, and walls that are thicker than the surface curves; of cells of 2 pi.
std::vector<double> halves(const TpmsPattern& pattern) {
  const double most = kTurn * std::min(pattern.inscribedRadius(TpmsChannel::A),
                                       pattern.inscribedRadius(TpmsChannel::B));
  return {0.5 * detail::PatternDistance::certainReach(pattern), 0.6 * most};
}

TEST(PatternDistanceTest, IsTheDistanceOfTheNearestPoint) {
  const auto all = TpmsPattern::all();
  const auto plain = plainPatterns();
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(plain[i].name);
    const SurfaceDistance surface(plain[i].value, 0);
    for (const double half : halves(all[i])) {
      const double reach = 1.5 * half;
      const bool isThin = reach <= detail::PatternDistance::certainReach(all[i]);
      const double tolerance = isThin ? 1e-9 : 1e-4;
      const detail::PatternDistance distance(all[i], tolerance);
      RandomPoints<double> random(0.5 * kTurn, 3);
      int within = 0;
      for (int k = 0; k < scaled(300); ++k) {
        const auto p = random.next();
        const double found = distance.upTo(reach, p);
        const double exact = surface.upperBound(p);
        // The oracle may miss the nearest point, but not by being too near.
        EXPECT_LE(found, exact + tolerance) << p;
        if (found < reach) {
          ++within;
          EXPECT_GE(found, exact - 1e-3) << p << " of " << half;
        }
      }
      EXPECT_GT(within, isThin ? 3 : 100) << half;
    }
  }
}

TEST(PatternDistanceTest, AllocatesNothing) {
  const detail::PatternDistance distance(TpmsPattern::lidinoid(), 1e-4);
  RandomPoints<double> random(kTurn, 5);
  double sum = 0;
  const AllocationCount allocations;
  for (int k = 0; k < 200; ++k) sum += distance.upTo(0.7, random.next());
  EXPECT_EQ(allocations.count(), 0);
  EXPECT_GT(sum, 1);
}

/// The largest ball in a channel: climbing from the best of a grid.
double largestBall(const SurfaceDistance& surface, double side) {
  const auto radius = [&](const Vec3<double>& p) {
    return side * surface.value(p) > 0 ? surface.upperBound(p) : 0.0;
  };
  constexpr int kSide = 16;
  Vec3<double> best;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const auto at = [&](int k) { return kTurn / kSide * (k % kSide); };
    const Vec3<double> p{at(i), at(i / kSide), at(i / kSide / kSide)};
    if (radius(p) > radius(best)) best = p;
  }
  RandomPoints<double> random(1, 2);
  for (double step = 0.3; step > 1e-4; step *= 0.9) {
    for (int i = 0; i < 12; ++i) {
      const auto p = best + step * random.next();
      if (radius(p) > radius(best)) best = p;
    }
  }
  return radius(best);
}

TEST(PatternDistanceTest, NoBallInAChannelIsLarger) {
  const auto all = TpmsPattern::all();
  const auto plain = plainPatterns();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SurfaceDistance surface(plain[i].value, 0);
    const double inA = kTurn * all[i].inscribedRadius(TpmsChannel::A);
    const double inB = kTurn * all[i].inscribedRadius(TpmsChannel::B);
    EXPECT_NEAR(largestBall(surface, 1), inA + 0.005, 0.0075) << plain[i].name;
    EXPECT_NEAR(largestBall(surface, -1), inB + 0.005, 0.0075) << plain[i].name;
    EXPECT_GT(all[i].leastSlope(), 0.4);
  }
}

}  // namespace
}  // namespace cutwater::test
