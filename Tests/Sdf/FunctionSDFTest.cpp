#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class FunctionSDFTest : public ::testing::Test {};
TYPED_TEST_SUITE(FunctionSDFTest, Precisions);

TYPED_TEST(FunctionSDFTest, KeepsWhatTheUserPromises) {
  using T = TypeParam;
  const auto exact = [](const Vec3<T>& p) { return length(p) - T(1.5); };
  const FunctionSDF ball(exact, Guarantee<T>::exact(T(1.5)), {{-2, -2, -2}, {2, 2, 2}});
  EXPECT_EQ(ball.signedDistance({0, 4, 0}), T(2.5));
  EXPECT_EQ(ball.boundingBox().upper.x, T(2));
  EXPECT_TRUE(ball.closestPoint({0, 4, 0}).exact);
  expectGuarantee(ball, 3, {.inside = [](const Vec3<double>& p) { return length(p) < 1.5; }});
  // An ellipsoid by its implicit function: the sign, and how fast values change in a box.
  const auto implicit = [](const Vec3<T>& p) {
    return length(Vec3<T>{p.x, 2 * p.y, 3 * p.z}) - T(1);
  };
  const FunctionSDF egg(implicit,
                        Guarantee<T>{.lipschitz = 3, .continuous = true, .ulps = 16, .size = 1});
  EXPECT_EQ(egg.guarantee().outside, Quality::SignOnly);
  expectGuarantee(egg, 1.5, {.inside = [](const Vec3<double>& p) {
                    return std::hypot(p.x, 2 * p.y, 3 * p.z) < 1;
                  }});
  EXPECT_EQ(egg.classify({{T(1.1), 0, 0}, {2, 1, 1}}), BoxClass::Unknown);
  EXPECT_EQ(egg.classify({{2, 0, 0}, {T(2.5), 1, 1}}), BoxClass::Outside) << "in two steps";
  EXPECT_EQ(egg.classify({{2, 0, 0}, {T(2.1), T(0.1), T(0.1)}}), BoxClass::Outside);
}

TYPED_TEST(FunctionSDFTest, WithoutALipschitzConstantOnlyPointsAreCertain) {
  using T = TypeParam;
  const Solid<T> step =
      FunctionSDF([](const Vec3<T>& p) { return p.x < 0 ? T(-1) : T(1); }, Guarantee<T>{});
  EXPECT_EQ(step.signedDistance({-3, 0, 0}), T(-1));
  EXPECT_EQ(step.classify({{2, 0, 0}, {3, 1, 1}}), BoxClass::Unknown);
  expectGuarantee(step, 1, {.polish = false});
}

TYPED_TEST(FunctionSDFTest, ClosestPointsAreNotSoughtFarAway) {
  using T = TypeParam;
  // No surface, and a gradient that nearly vanishes: steps to where the value would be 0 lead away.
  T farthest = 0;
  const auto value = [&farthest](const Vec3<T>& p) {
    farthest = std::max(farthest, length(p));
    return std::sqrt(p.x * p.x + 1);
  };
  const FunctionSDF valley(value, Guarantee<T>{.outside = Quality::LowerBound,
                                               .inside = Quality::LowerBound,
                                               .lipschitz = T(1),
                                               .continuous = true});
  for (const T x : {T(0.5), T(1e-2), T(-1e-3), T(1e-5)}) {
    EXPECT_FALSE(valley.closestPoint({x, 1, 0}).exact);
  }
  EXPECT_LT(farthest, T(200));
}

TYPED_TEST(FunctionSDFTest, RefusesNegativePromises) {
  using T = TypeParam;
  const auto zero = [](const Vec3<T>&) { return T(0); };
  EXPECT_THROW(FunctionSDF(zero, Guarantee<T>{.lipschitz = -1}), Error);
  EXPECT_THROW(FunctionSDF(zero, Guarantee<T>{.lipschitz = std::numeric_limits<T>::quiet_NaN()}),
               Error);
  EXPECT_THROW(FunctionSDF(zero, Guarantee<T>{.lipschitz = 1, .ulps = -1}), Error);
}

}  // namespace
}  // namespace cutwater::test
