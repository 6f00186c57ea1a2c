#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/GradedValue.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <gtest/gtest.h>

#include "Support/Random.hpp"

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

TEST(GradedValueTest, ByDistanceIsTheSameOnBothSides) {
  const auto graded =
      GradedValue<double>::byDistanceTo(Plane<double>({0, 0, 0}, {0, 0, 1}), {0.5, 0.1, 2});
  for (const double side : {-1.0, 1.0}) {
    EXPECT_DOUBLE_EQ(graded.at({3, 0, side}), 0.3);
    EXPECT_EQ(graded.at({3, 0, 3 * side}), 0.1);
    EXPECT_DOUBLE_EQ(graded.gradient({3, 0, side}).z, -0.2 * side);
    EXPECT_EQ(graded.gradient({3, 0, 3 * side}), (Vec3<double>{}));
  }
  EXPECT_EQ(graded.at({0, 0, 0}), 0.5);
}

TEST(GradedValueTest, GradientsAreThoseOfItsValues) {
  const Solid<double> ball = Sphere<double>({0, 0, 0}, 1);
  const GradedRamp<double> ramp{0.5, 0.1, 2};
  const GradedValue<double> kinds[] = {GradedValue<double>::byValueOf(ball, ramp),
                                       GradedValue<double>::byDistanceTo(ball, ramp),
                                       GradedValue<double>(3)};
  RandomPoints<double> random(4);
  for (const auto& graded : kinds) {
    for (int i = 0; i < 200; ++i) {
      const auto p = random.next();
      const auto step = 1e-4 * normalized(random.next());
      const double change = graded.at(p + step) - graded.at(p - step);
      const double size = std::abs(length(p) - 1);
      if (length(p) < 0.05 || size < 1e-3 || std::abs(size - 2) < 1e-3) continue;  // kinks
      EXPECT_NEAR(change, 2 * dot(step, graded.gradient(p)), 1e-9);
    }
  }
}

TEST(GradedValueTest, HoldsWhereItsSolidDoes) {
  const Box<double> domain{{0, 0, 0}, {2, 2, 2}};
  const FunctionSDF field([](const Vec3<double>& p) { return p.x; },
                          Guarantee<double>{.lipschitz = 1, .continuous = true, .domain = domain});
  const auto graded = GradedValue<double>::byValueOf(field, {0, 1, 2});
  EXPECT_EQ(graded.guarantee().domain, domain);
  EXPECT_EQ(*graded.guarantee().lipschitz, 0.5);
}

TEST(GradedValueTest, RefusesWhatHasNoLimits) {
  const Plane<double> plane({0, 0, 0}, {0, 0, 1});
  EXPECT_THROW(static_cast<void>(GradedValue<double>::byValueOf(plane, {0, 1, 0})), Error);
  EXPECT_THROW(static_cast<void>(GradedValue<double>::byValueOf(plane, {0, std::nan(""), 1})),
               Error);
  const FunctionSDF any([](const Vec3<double>& p) { return p.x * p.x; }, Guarantee<double>{});
  EXPECT_THROW(static_cast<void>(GradedValue<double>::byValueOf(any, {0, 1, 1})), Error);
  const auto one = [](const Vec3<double>&) { return 1.0; };
  EXPECT_THROW(
      static_cast<void>(GradedValue<double>::by(one, {.lipschitz = 0, .least = 1, .most = 0})),
      Error);
  EXPECT_THROW(
      static_cast<void>(GradedValue<double>::by(one, {.lipschitz = -1, .least = 0, .most = 1})),
      Error);
}

}  // namespace
}  // namespace cutwater::test
