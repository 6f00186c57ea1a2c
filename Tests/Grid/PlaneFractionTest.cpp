#include <Cutwater/Grid/Detail/PlaneFraction.hpp>

#include <algorithm>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

using detail::planeFraction;

/// By the lengths of n^2 parallel lines within the half space.
double fractionByLines(double value, Vec3<double> gradient, int n) {
  // Along the axis of the greatest slope, where lengths vary least.
  if (std::abs(gradient.x) > std::abs(gradient.z)) std::swap(gradient.x, gradient.z);
  if (std::abs(gradient.y) > std::abs(gradient.z)) std::swap(gradient.y, gradient.z);
  double sum = 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double x = (i + 0.5) / n - 0.5;
      const double y = (j + 0.5) / n - 0.5;
      const double rest = value + gradient.x * x + gradient.y * y;
      sum += std::clamp(0.5 - rest / std::abs(gradient.z), 0.0, 1.0);
    }
  }
  return sum / n / n;
}

TEST(PlaneFractionTest, AgreesWithSumsOverLines) {
  RandomPoints<double> random(1, 4);
  for (int probe = 0; probe < 1000; ++probe) {
    auto gradient = random.next();
    // Nearly parallel to an axis or a face, too.
    const double shrink[] = {1, 1, 1, 1e-3, 1e-6, 1e-12, 0};
    gradient.x *= shrink[probe % 7];
    gradient.y *= shrink[probe / 7 % 7];
    const double value = random.next().x * oneNorm(gradient) * 0.6;
    EXPECT_NEAR(planeFraction(value, gradient), fractionByLines(value, gradient, 60), 5e-4)
        << value << " " << gradient;
  }
}

TEST(PlaneFractionTest, HasTheHandValues) {
  EXPECT_EQ(planeFraction(0, {0, 0, 1}), 0.5);
  EXPECT_DOUBLE_EQ(planeFraction(-0.25, {0, 0, 1}), 0.75);
  EXPECT_DOUBLE_EQ(planeFraction(0.25, {0, -1, 0}), 0.25);
  EXPECT_DOUBLE_EQ(planeFraction(0.5, {1, 1, 0}), 0.125);
  EXPECT_DOUBLE_EQ(planeFraction(1, {1, 1, 1}), 0.125 / 6);
  EXPECT_DOUBLE_EQ(planeFraction(-1, {1, -1, 1}), 1 - 0.125 / 6);
  EXPECT_DOUBLE_EQ(planeFraction(0, {1, 2, 3}), 0.5);
  EXPECT_EQ(planeFraction(2, {1, 1, 0}), 0);
  EXPECT_EQ(planeFraction(-2, {1, 1, 0}), 1);
}

TEST(PlaneFractionTest, GoesByTheValueWhereThereIsNoGradient) {
  EXPECT_EQ(planeFraction(-1e-9, {0, 0, 0}), 1);
  EXPECT_EQ(planeFraction(0, {0, 0, 0}), 0);
  EXPECT_EQ(planeFraction(-1, {std::nan(""), 0, 0}), 1);
}

}  // namespace
}  // namespace cutwater::test
