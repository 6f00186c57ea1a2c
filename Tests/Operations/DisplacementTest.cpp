#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

/// Ripples of amplitude 1/16 whose slope is at most 3/8.
template <typename T>
T ripples(const Vec3<T>& p) {
  return T(0.0625) * std::sin(4 * p.x) * std::cos(4 * p.y);
}

template <typename T>
class DisplacementTest : public ::testing::Test {
 protected:
  static constexpr FunctionLimits<T> kRipples{.lipschitz = T(0.375), .amplitude = T(0.0625)};
  Sphere<T> ball_{{0, 0, 0}, 2};
  Cuboid<T> box_{{-1, -1, -1}, {1, 1, 1}};
};
TYPED_TEST_SUITE(DisplacementTest, Precisions);

TYPED_TEST(DisplacementTest, AddsTheFunction) {
  using T = TypeParam;
  const auto sea = displaced(Plane<T>({0, 0, 0}, {0, 0, 1}), ripples<T>, this->kRipples);
  RandomPoints<T> points(3);
  for (int i = 0; i < 300; ++i) {
    const auto p = points.next();
    EXPECT_EQ(sea.signedDistance(p), p.z + ripples(p));
  }
  EXPECT_NEAR(sea.boundingBox().upper.z, T(0.0625), tolerance<T>(1, 256));
  // The Lipschitz constants alone would not decide these, but the amplitude does.
  EXPECT_EQ(sea.classify({{-1, -1, T(1.6)}, {1, 1, T(1.8)}}), BoxClass::Outside);
  EXPECT_EQ(sea.classify({{-1, -1, T(-1.8)}, {1, 1, T(-1.6)}}), BoxClass::Inside);
}

TYPED_TEST(DisplacementTest, ByAConstantIsAnOffsetToTheBit) {
  using T = TypeParam;
  const auto h = [](const Vec3<T>&) { return T(-0.3); };
  const auto grown = displaced(this->box_, h, {.amplitude = T(0.3)});
  EXPECT_EQ(grown.guarantee().outside, Quality::LowerBound);
  RandomPoints<T> points(3);
  for (int i = 0; i < 300; ++i) {
    const auto p = points.next();
    EXPECT_EQ(grown.signedDistance(p), offset(this->box_, T(0.3)).signedDistance(p));
  }
  EXPECT_NEAR(grown.boundingBox().upper.x, T(1.3), tolerance<T>(2, 256));
}

TYPED_TEST(DisplacementTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto rough = displaced(this->ball_, ripples<T>, this->kRipples);
  EXPECT_EQ(rough.guarantee().lipschitz, T(1.375));
  EXPECT_EQ(rough.guarantee().outside, Quality::SignOnly);
  expectGuarantee(rough, 3, {.inside = [](const Vec3<double>& p) {
                    return length(p) - 2 + 0.0625 * std::sin(4 * p.x) * std::cos(4 * p.y) < 0;
                  }});
  expectGuarantee(rotated(displaced(this->ball_ - this->box_, ripples<T>, {.lipschitz = T(0.375)}),
                          30, {1, 2, 3}),
                  3);
  expectGuarantee(
      displaced(this->box_ | translated(this->ball_, {2, 0, 0}), ripples<T>, this->kRipples), 4.5);
}

TYPED_TEST(DisplacementTest, KeepsThePatchesOfTheOperand) {
  using T = TypeParam;
  const auto two = named(this->box_, "hull") | named(translated(this->ball_, {4, 0, 0}), "buoy");
  const auto rough = displaced(two, ripples<T>, this->kRipples);
  EXPECT_EQ(rough.patchNames(), (std::vector<std::string>{"hull", "buoy"}));
  EXPECT_EQ(rough.closestPoint({9, 0, 0}).owner.patch, 1U);
  EXPECT_EQ(rough.closestPoint({-9, 0, 0}).owner.patch, 0U);
  EXPECT_EQ(displaced(two, ripples<T>, {.lipschitz = 1}).boundingBox(), Box<T>::everywhere());
}

TYPED_TEST(DisplacementTest, RefusesImpossibleLimits) {
  using T = TypeParam;
  const auto refuses = [&](const FunctionLimits<T>& limits) {
    EXPECT_THROW(static_cast<void>(displaced(this->box_, ripples<T>, limits)), Error);
  };
  refuses({.lipschitz = -1});
  refuses({.lipschitz = std::numeric_limits<T>::infinity()});
  refuses({.lipschitz = 1, .amplitude = -1});
}

}  // namespace
}  // namespace cutwater::test
