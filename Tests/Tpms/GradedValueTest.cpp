#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Tpms/GradedValue.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(GradedValueTest, IsLinearBetweenItsEnds) {
  const auto graded =
      GradedValue<double>::byValueOf(Plane<double>({0, 0, 1}, {0, 0, 1}), {0.5, 0.1, 2});
  EXPECT_EQ(graded.at({0, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(graded.at({3, 0, 2}), 0.3);
  EXPECT_EQ(graded.at({0, 5, 4}), 0.1);
  EXPECT_DOUBLE_EQ(graded.lipschitz(), 0.2);
  EXPECT_EQ(graded.lipschitzWithin({0, 0, 0}, 0.9), 0);
  EXPECT_DOUBLE_EQ(graded.lipschitzWithin({0, 0, 0}, 1.1), 0.2);
  EXPECT_EQ(GradedValue<double>(0.25).at({1, 2, 3}), 0.25);
}

TEST(GradedValueTest, RefusesWhatHasNoLimits) {
  const Plane<double> plane({0, 0, 0}, {0, 0, 1});
  EXPECT_THROW(GradedValue<double>::byValueOf(plane, {0, 1, 0}), Error);
  EXPECT_THROW(GradedValue<double>::byValueOf(plane, {0, std::nan(""), 1}), Error);
  const FunctionSDF any([](const Vec3<double>& p) { return p.x * p.x; }, Guarantee<double>{});
  EXPECT_THROW(GradedValue<double>::byValueOf(any, {0, 1, 1}), Error);
  const auto one = [](const Vec3<double>&) { return 1.0; };
  EXPECT_THROW(GradedValue<double>::by(one, {.lipschitz = 0, .least = 1, .most = 0}), Error);
  EXPECT_THROW(GradedValue<double>::by(one, {.lipschitz = -1, .least = 0, .most = 1}), Error);
}

}  // namespace
}  // namespace cutwater::test
