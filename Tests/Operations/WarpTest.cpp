#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

/// Sideways waves along z, of amplitude 1/4 and slope at most 1/2.
template <typename T>
Vec3<T> waves(const Vec3<T>& p) {
  return {T(0.25) * std::sin(2 * p.z), 0, 0};
}

template <typename T>
class WarpTest : public ::testing::Test {
 protected:
  static constexpr FunctionLimits<T> kWaves{.lipschitz = T(0.5), .amplitude = T(0.25)};
  Cuboid<T> beam_{{T(-0.5), T(-0.5), -2}, {T(0.5), T(0.5), 2}};
  Sphere<T> ball_{{0, 0, 0}, 1};
};
TYPED_TEST_SUITE(WarpTest, Precisions);

TYPED_TEST(WarpTest, AsksTheOperandAtShiftedPoints) {
  using T = TypeParam;
  const auto bent = warped(this->beam_, waves<T>, this->kWaves);
  RandomPoints<T> points(3);
  for (int i = 0; i < 300; ++i) {
    const auto p = points.next();
    EXPECT_EQ(bent.signedDistance(p), this->beam_.signedDistance(p + waves(p)));
  }
  EXPECT_NEAR(bent.boundingBox().upper.x, T(0.75), tolerance<T>(4, 256));
  EXPECT_EQ(bent.patchNames(), this->beam_.patchNames());
  // A constant shift is a translation the other way.
  const auto moved = warped(this->ball_,
                            [](const Vec3<T>&) {
                              return Vec3<T>{-3, 0, 0};
                            },
                            {.lipschitz = 0, .amplitude = 3});
  EXPECT_EQ(moved.signedDistance({3, 0, 0}), T(-1));
  EXPECT_EQ(moved.guarantee().outside, Quality::LowerBound);
  EXPECT_EQ(moved.closestPoint({6, 0, 0}).point, (Vec3<T>{4, 0, 0}));
}

TYPED_TEST(WarpTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto bent = warped(this->beam_, waves<T>, this->kWaves);
  EXPECT_EQ(bent.guarantee().lipschitz, T(1.5));
  EXPECT_EQ(bent.guarantee().outside, Quality::SignOnly);
  expectGuarantee(bent, 2.5, {.inside = [](const Vec3<double>& p) {
                    return std::abs(p.x + 0.25 * std::sin(2 * p.z)) < 0.5 && std::abs(p.y) < 0.5 &&
                           std::abs(p.z) < 2;
                  }});
  const auto body = this->beam_ | translated(this->ball_, {1, 0, 0});
  expectGuarantee(rotated(warped(body, waves<T>, {.lipschitz = T(0.5)}), 30, {1, 2, 3}), 3);
  // A shear, far from the origin, with no amplitude to go by.
  const auto shear = [](const Vec3<T>& p) { return Vec3<T>{T(0.5) * p.y + 3, 0, 0}; };
  expectGuarantee(warped(this->ball_, shear, {.lipschitz = T(0.5)}), 4.5);
}

TYPED_TEST(WarpTest, BoxesAreAskedOfTheOperand) {
  using T = TypeParam;
  const auto bent = warped(this->beam_, waves<T>, this->kWaves);
  // Value and Lipschitz constant alone would not decide this one: it is long.
  EXPECT_EQ(bent.classify({{T(0.8), 0, 0}, {T(0.9), T(0.1), T(1.9)}}), BoxClass::Outside);
  EXPECT_EQ(bent.classify({{T(1.8), 0, 0}, {T(1.9), T(0.1), T(1.9)}}), BoxClass::Outside);
  EXPECT_EQ(bent.classify({{T(-0.05), T(-0.05), T(-0.05)}, {T(0.05), T(0.05), T(0.05)}}),
            BoxClass::Inside);
}

TYPED_TEST(WarpTest, RefusesImpossibleLimits) {
  using T = TypeParam;
  EXPECT_THROW(static_cast<void>(warped(this->ball_, waves<T>, {.lipschitz = -1})), Error);
  EXPECT_THROW(static_cast<void>(warped(this->ball_, waves<T>, {.lipschitz = 1, .ulps = -1})),
               Error);
}

}  // namespace
}  // namespace cutwater::test
