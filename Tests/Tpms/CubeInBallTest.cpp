#include <Cutwater/Tpms/Detail/CubeInBall.hpp>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Tpms/PlainPatterns.hpp"

namespace cutwater::test {
namespace {

using detail::CubeInBall;
using detail::PatternExpansion;

class CubeInBallTest : public ::testing::TestWithParam<std::size_t> {
 protected:
  const TpmsPattern pattern = TpmsPattern::all()[GetParam()];
  const PlainPattern plain = plainPatterns()[GetParam()];
  RandomPoints<double> random{1, 3};

  [[nodiscard]] double sideOf(const Vec3<double>& place) const {
    return plain.value(place.x, place.y, place.z) < 0 ? -1 : 1;
  }

  [[nodiscard]] bool isCertain(const CubeInBall& part, const Vec3<double>& ball) const {
    const auto middle = ball + part.center;
    PatternExpansion f{};
    detail::expandPattern(pattern, {&middle, 1}, {&f, 1});
    return detail::isOnOneSide(part, pattern, f, sideOf(ball));
  }

  /// The largest number, to rounding, with which the part is certain.
  double grow(CubeInBall& part, double CubeInBall::*number, double most,
              const Vec3<double>& ball) const {
    double low = 0;
    double high = most;
    for (int step = 0; step < 40; ++step) {
      part.*number = 0.5 * (low + high);
      (isCertain(part, ball) ? low : high) = part.*number;
    }
    return part.*number = low;
  }

  /// The least of F on the point's side in the part, as far as samples tell: in the cube, at its
  /// corners, and on the sphere within it.
  double leastIn(const CubeInBall& part, const Vec3<double>& ball) {
    double least = 10;
    for (int i = 0; i < 200; ++i) {
      auto from = part.half * random.next();
      if (i % 2 == 0) {
        for (int axis = 0; axis < 3; ++axis) from[axis] = std::copysign(part.half, from[axis]);
      }
      from = part.center + from;
      if (length(from) > part.radius || i % 4 == 1) from = (part.radius / length(from)) * from;
      if (maxComponent(abs(from - part.center)) > part.half) continue;
      const auto y = ball + from;
      least = std::min(least, sideOf(ball) * plain.value(y.x, y.y, y.z));
    }
    return least;
  }
};

TEST_P(CubeInBallTest, IsCertainOfNothingThatIsNot) {
  int certain = 0;
  double closest = 10;
  for (int i = 0; i < scaled(20000); ++i) {
    const auto ball = 3.2 * random.next();
    CubeInBall part{1.5 * random.next(), 0.05 + 0.4 * std::abs(random.next().x), 0};
    const double most = length(part.center) + 2 * part.half;
    const double radius = grow(part, &CubeInBall::radius, most, ball);
    if (radius == 0 || radius + 1.8 * part.half < length(part.center)) continue;  // no cube in it
    ++certain;
    const double least = leastIn(part, ball);
    ASSERT_GT(least, -1e-12) << ball << part.center << part.half << ' ' << part.radius;
    closest = std::min(closest, least);
  }
  EXPECT_GT(certain, 2000);
  EXPECT_LT(closest, 0.02 * pattern.range().upper);  // some are all but too large
}

TEST_P(CubeInBallTest, WholeCubesCountWithThirdDerivatives) {
  double closest = 10;
  for (int i = 0; i < scaled(20000); ++i) {
    const auto ball = 3.2 * random.next();
    CubeInBall part{0.01 * random.next(), 0, 10};
    if (grow(part, &CubeInBall::half, 3, ball) == 0) continue;
    const double least = leastIn(part, ball);
    ASSERT_GT(least, -1e-12) << ball << part.center << part.half;
    closest = std::min(closest, least);
  }
  EXPECT_LT(closest, 0.02 * pattern.range().upper);
}

INSTANTIATE_TEST_SUITE_P(Patterns, CubeInBallTest, ::testing::Range<std::size_t>(0, 10));

}  // namespace
}  // namespace cutwater::test
