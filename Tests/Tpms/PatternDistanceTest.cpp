#include <Cutwater/Tpms/Detail/PatternDistance.hpp>

#include <gtest/gtest.h>

#include "Support/AllocationCount.hpp"
#include "Support/CpuTime.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Tpms/GreatestValue.hpp"
#include "Tpms/SurfaceDistance.hpp"

namespace cutwater::test {
namespace {

double smallerRadius(const TpmsPattern& pattern) {
  return kTurn *
         std::min(pattern.inscribedRadius(TpmsChannel::A), pattern.inscribedRadius(TpmsChannel::B));
}

/// Anywhere in the cell; where symmetry makes many points of the surface the nearest; and about as
/// far from the surface as this.
Vec3<double> probe(int k, RandomPoints<double>& random, const SurfaceDistance& surface,
                   double distance) {
  const auto p = 0.5 * kTurn * random.next();
  if (k % 3 == 0) return p;
  if (k % 3 == 1) {
    const double step = kTurn / 16;
    return step *
           Vec3<double>{std::round(p.x / step), std::round(p.y / step), std::round(p.z / step)};
  }
  const auto& samples = surface.samples();
  const auto& q = samples[static_cast<std::size_t>(k) * 7919 % samples.size()];
  return q + (k % 2 == 0 ? distance : -distance) * normalized(surface.gradient(q)) + 1e-3 * p;
}

/// With half a wall's thickness: how many of the distances were found.
int checkDistances(const TpmsPattern& pattern, const SurfaceDistance& surface, double half) {
  const double reach = 1.5 * half;
  const bool isThin = reach <= detail::PatternDistance::certainReach(pattern);
  const double tolerance = isThin ? 1e-9 : 1e-4;
  const detail::PatternDistance distance(pattern, tolerance);
  RandomPoints<double> random(1, 3);
  int within = 0;
  for (int k = 0; k < scaled(300); ++k) {
    const auto p = probe(k, random, surface, half);
    const double found = distance.upTo(reach, p);
    // The oracle may miss the nearest point, but not by being too near.
    double exact = surface.upperBound(p);
    EXPECT_LE(found, exact + tolerance) << p << " of " << half;
    if (found >= reach) continue;
    ++within;
    // It slides slowly to where the ball about p is as curved as the surface.
    const double missed = isThin ? 1e-6 : 1.1e-4;
    if (found < exact - missed) exact = surface.leastUpperBound(p);
    EXPECT_GE(found, exact - missed) << p << " of " << half;
  }
  return within;
}

TEST(PatternDistanceTest, IsTheDistanceOfTheNearestPoint) {
  const auto all = TpmsPattern::all();
  const auto plain = plainPatterns();
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(plain[i].name);
    const SurfaceDistance surface(plain[i].value, 0);
    const double thin = 0.5 * detail::PatternDistance::certainReach(all[i]);
    EXPECT_GT(checkDistances(all[i], surface, thin), scaled(100));
    EXPECT_GT(checkDistances(all[i], surface, 0.6 * smallerRadius(all[i])), scaled(200));
    EXPECT_GT(checkDistances(all[i], surface, 0.98 * smallerRadius(all[i])), scaled(250));
  }
}

/// Where a ball about the point touches the surface in many places at once, too. Without second
/// derivatives on the sphere they would take minutes.
TEST(PatternDistanceTest, TakesLittleTimeWhereverThePointIs) {
  constexpr int kSide = 16;
  const double seconds = cpuSeconds([&] {
    for (const auto& pattern : TpmsPattern::all()) {
      const double half = 0.98 * smallerRadius(pattern);
      const detail::PatternDistance distance(pattern, 1e-4 * kTurn);
      for (int i = 0; i < kSide * kSide * kSide / 8; ++i) {
        const auto at = [&](int k) { return kTurn / kSide * (k % (kSide / 2)); };
        EXPECT_LT(distance.upTo(1.5 * half, {at(i), at(i / 8), at(i / 64)}), kTurn);
      }
    }
  });
  EXPECT_LT(seconds, 10);
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

/// The distance with a sign changes no faster than the place. Radii are rounded down to 0.01.
TEST(PatternDistanceTest, NoBallInAChannelIsLarger) {
  const double gap = 0.03 / scaled(1);
  const double tolerance = 0.1 * gap;
  for (const auto& pattern : TpmsPattern::all()) {
    SCOPED_TRACE(pattern.name());
    const detail::PatternDistance distance(pattern, tolerance);
    for (const auto channel : {TpmsChannel::A, TpmsChannel::B}) {
      const double side = channel == TpmsChannel::A ? 1 : -1;
      const double radius = kTurn * pattern.inscribedRadius(channel);
      const auto room = [&](const Vec3<double>& turns) {
        const double found = distance.upTo(1.2 * radius, kTurn * turns);
        return side * pattern.value(turns) > 0 ? found : -found;
      };
      const auto largest = greatest(room, 1, gap);
      EXPECT_GE(largest.lower, radius - gap);
      EXPECT_LE(largest.upper, radius + 0.01 + gap + tolerance);
    }
  }
}

}  // namespace
}  // namespace cutwater::test
