#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

PolygonSoup pointsOnly(std::vector<Vec3<double>> points) {
  PolygonSoup soup;
  soup.points = std::move(points);
  return soup;
}

/// The rule as it is written: in order, the first of those that stay within the tolerance.
std::vector<Vec3<double>> weldedByHand(const std::vector<Vec3<double>>& points, double tolerance) {
  std::vector<Vec3<double>> kept;
  for (const auto& p : points) {
    const bool joins = std::ranges::any_of(kept, [&](const auto& q) {
      return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) <= tolerance;
    });
    if (!joins) kept.push_back(p);
  }
  return kept;
}

TEST(WeldWithin, ChainsDoNotContract) {
  auto soup = pointsOnly({{0, 0, 0}, {0.75, 0, 0}, {1.5, 0, 0}, {2.25, 0, 0}, {3, 0, 0}});
  const auto found = weldWithin(soup, 1);
  EXPECT_EQ(soup.points, (std::vector<Vec3<double>>{{0, 0, 0}, {1.5, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(found.places.count, 2U);
  EXPECT_EQ(found.largest, 0.75);
  EXPECT_EQ(found.places.examples[0], (Vec3<double>{0.75, 0, 0}));
}

TEST(WeldWithin, TheToleranceItselfIsClose) {
  auto soup = pointsOnly({{0, 0, 0}, {0, 0.25, 0}, {0, 0, std::nextafter(0.25, 1)}});
  EXPECT_EQ(weldWithin(soup, 0.25).places.count, 1U);
  EXPECT_EQ(soup.points.size(), 2U);
}

TEST(WeldWithin, FollowsItsRuleOnAnyPoints) {
  for (const double scale : {1.0, 0x1p-900, 0x1p+900}) {
    for (const double tolerance : {0.003, 0.05, 0.4}) {
      RandomPoints<double> random(1, 5);
      std::vector<Vec3<double>> points;
      for (int i = 0; i < 1500; ++i) points.push_back(scale * random.next());
      auto soup = pointsOnly(points);
      for (std::uint32_t i = 0; i + 2 < points.size(); i += 3) {
        soup.addPolygon(std::array{i, i + 1, i + 2});
      }
      weldWithin(soup, scale * tolerance);
      // Every corner is the first point within the tolerance of those that stay.
      for (std::size_t i = 0; i < soup.corners.size(); ++i) {
        const auto first = std::ranges::find_if(soup.points, [&](const auto& p) {
          return length(p / scale - points[i] / scale) <= tolerance;
        });
        ASSERT_EQ(soup.corners[i], first - soup.points.begin()) << i;
      }
      std::vector<Vec3<double>> unit;
      for (const auto& p : points) unit.push_back(p / scale);
      auto expected = weldedByHand(unit, tolerance);
      for (auto& p : expected) p *= scale;
      EXPECT_EQ(soup.points, expected) << scale << " " << tolerance;
    }
  }
}

TEST(WeldWithin, FarFromTheOriginAndAcrossCells) {
  // Pairs on either side of multiples of the tolerance, where coordinates have few digits left.
  for (const double offset : {0.0, 1e6, -1e6, 0x1p50, 0x1p52, 0x1p53, 0x1p60}) {
    PolygonSoup soup;
    for (int i = -20; i <= 20; ++i) {
      soup.points.push_back({offset + 8 * i - 0.5, offset, -offset});
      soup.points.push_back({offset + 8 * i + 0.5, offset, -offset});
    }
    const auto expected = weldedByHand(soup.points, 1);
    weldWithin(soup, 1);
    EXPECT_EQ(soup.points, expected) << offset;
  }
}

TEST(WeldWithin, TinyTolerancesMergeNothingLarge) {
  auto soup = pointsOnly({{1e300, 0, 0}, {1, 0, 0}, {std::nextafter(1.0, 2), 0, 0}});
  EXPECT_FALSE(weldWithin(soup, 5e-324));
  EXPECT_EQ(soup.points.size(), 3U);
}

TEST(WeldWithin, TinyTolerancesMergeEqualPointsAndNeighbours) {
  constexpr double kLeast = 5e-324;
  for (const double far : {1.0, 1e10, 1e300}) {
    auto soup = pointsOnly({{far, 0, -far}, {0, 1, 0}, {far, 0, -far}, {far, -0.0, -far}});
    const auto found = weldWithin(soup, kLeast);
    EXPECT_EQ(found.places.count, 2U);
    EXPECT_EQ(found.largest, 0);
    EXPECT_EQ(weldWithin(soup, 1e-300).places.count, 0U);
  }
  auto soup = pointsOnly({{}, {0, kLeast, 0}, {kLeast, kLeast, 0}, {0, 0, -1e-300}});
  EXPECT_EQ(weldWithin(soup, kLeast).largest, kLeast);
  EXPECT_EQ(soup.points, (std::vector<Vec3<double>>{{}, {kLeast, kLeast, 0}, {0, 0, -1e-300}}));
}

TEST(WeldWithin, HugeTolerancesMergeAll) {
  constexpr double kMost = std::numeric_limits<double>::max();
  auto soup = pointsOnly({{0, 1e300, 0}, {-1, 0, 0}, {0, 0, 1}, {-1e300, 0, -0.25 * kMost}});
  EXPECT_EQ(weldWithin(soup, kMost).places.count, 3U);
  auto apart = pointsOnly({{-kMost, 0, 0}, {kMost, 0, 0}, {-kMost, kMost, 0}});
  EXPECT_EQ(weldWithin(apart, kMost).places.count, 1U);
}

TEST(WeldWithin, JitteredCopiesBecomeOneAgain) {
  const auto sphere = tessellation::icosphere(1, 3);
  for (const double jitter : {1e-7, 1e-5}) {
    auto soup = jittered(unwelded(sphere), jitter);
    const auto found = weldWithin(soup, 4 * jitter);
    EXPECT_EQ(found.places.count, 3 * sphere.polygonCount() - sphere.points.size());
    EXPECT_LE(found.largest, 4 * jitter);
    EXPECT_TRUE(reportOf(soup).isClean()) << reportOf(soup).summary();
    EXPECT_FALSE(weldWithin(soup, 4 * jitter));
  }
}

TEST(WeldWithin, ManyPointsInOnePlaceTakeLinearTime) {
  PolygonSoup soup;
  RandomPoints<double> random(1e-3, 9);
  for (int i = 0; i < 300'000; ++i) soup.points.push_back(random.next());
  EXPECT_EQ(weldWithin(soup, 0.01).places.count, 299'999U);
}

TEST(WeldWithin, RefusesWhatIsNoTolerance) {
  auto soup = pointsOnly({{0, 0, 0}});
  for (const double tolerance : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(weldWithin(soup, tolerance), Error) << tolerance;
  }
  soup.points.push_back({HUGE_VAL, 0, 0});
  EXPECT_THROW(weldWithin(soup, 1), Error);
  EXPECT_EQ(soup.points.size(), 2U);
}

}  // namespace
}  // namespace cutwater::test
