#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Detail/Ticks.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

std::string labels(double lower, double upper, double step) {
  std::string all;
  for (const auto& tick : ticksBetween(lower, upper, step)) {
    all += (all.empty() ? "" : " ") + tick.label;
  }
  return all;
}

TEST(TicksTest, StepsAreOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(roundStep(0.03), 0.05);
  EXPECT_DOUBLE_EQ(roundStep(0.05), 0.05);
  EXPECT_DOUBLE_EQ(roundStep(0.051), 0.1);
  EXPECT_DOUBLE_EQ(roundStep(1), 1);
  EXPECT_DOUBLE_EQ(roundStep(11), 20);
  EXPECT_DOUBLE_EQ(roundStep(1e-9), 1e-9);
  for (const double extreme : {std::numeric_limits<double>::denorm_min(), 1e308}) {
    EXPECT_GT(roundStep(extreme), 0);
    EXPECT_TRUE(std::isfinite(roundStep(extreme)));
  }
}

TEST(TicksTest, LabelsHaveTheDigitsTheyNeed) {
  EXPECT_EQ(labels(-0.25, 0.21, 0.1), "-0.2 -0.1 0.0 0.1 0.2");
  EXPECT_EQ(labels(-1, 2, 1), "-1 0 1 2");
  EXPECT_EQ(labels(0, 1, 0.25), "0.00 0.25 0.50 0.75 1.00");
  EXPECT_EQ(labels(980, 1040, 20), "980 1000 1020 1040");
  EXPECT_EQ(labels(0, 0.00002, 0.00001), "0.00000 0.00001 0.00002");
  EXPECT_EQ(labels(0, 2e-9, 1e-9), "0 1e-09 2e-09");
  EXPECT_EQ(labels(-1.5e-5, 1e-5, 5e-6), "-1.5e-05 -1.0e-05 -5.0e-06 0 5.0e-06 1.0e-05");
  EXPECT_EQ(labels(5e6, 1.6e7, 5e6), "5.0e+06 1.0e+07 1.5e+07");
  EXPECT_EQ(labels(0, 5e-9, 2.5e-9), "0 2.5e-09 5.0e-09");
  EXPECT_EQ(labels(0, 1e300, 5e299), "0 5.0e+299 1.0e+300");
  EXPECT_EQ(labels(1e7, 1.02e7, 1e5), "1.00e+07 1.01e+07 1.02e+07");
  EXPECT_EQ(labels(0.31, 0.39, 0.1), "");
}

TEST(TicksTest, EndsThemselvesCount) {
  EXPECT_EQ(ticksBetween(0.1, 0.7, 0.1).size(), 7U);
  EXPECT_EQ(ticksBetween(-0.3, 0.3, 0.1).size(), 7U);
  EXPECT_FALSE(std::signbit(ticksBetween(-0.3, 0.3, 0.1).at(3).value));
}

TEST(TicksTest, RefusesWhatWouldNotEnd) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(ticksBetween(0, inf, 1)), Error);
  EXPECT_THROW(static_cast<void>(ticksBetween(1, 0, 1)), Error);
  EXPECT_THROW(static_cast<void>(ticksBetween(0, 1, 0)), Error);
  EXPECT_THROW(static_cast<void>(ticksBetween(0, 1, 1e-9)), Error);
  EXPECT_LE(ticksBetween(1e300, 1e300, 1).size(), 1U);  // the step is lost in rounding
}

}  // namespace
}  // namespace cutwater::test
