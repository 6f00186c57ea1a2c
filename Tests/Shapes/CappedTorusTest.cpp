#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/CappedTorus.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <algorithm>
#include <numbers>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class CappedTorusTest : public ::testing::Test {};
TYPED_TEST_SUITE(CappedTorusTest, Precisions);

TYPED_TEST(CappedTorusTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const CappedTorus<T> half(3, 1, 90);
  EXPECT_EQ(half.signedDistance({3, 0, 0}), T(-1));
  EXPECT_EQ(half.signedDistance({0, 0, 0}), T(2));
  EXPECT_NEAR(half.signedDistance({-4, 6, 0}), T(4), tolerance<T>(10));  // beyond the end (0, 3, 0)
  EXPECT_NEAR(half.signedDistance({-3, -3, 4}), T(4), tolerance<T>(10));
  EXPECT_NEAR(half.signedDistance({3, 4, 0}), T(1), tolerance<T>(10));
  EXPECT_EQ(half.gradient({6, 0, 4}), (Vec3<T>{T(0.6), 0, T(0.8)}));
  EXPECT_LT(length(half.gradient({-1, -3, 0}) - Vec3<T>{-1, 0, 0}), tolerance<T>(1));
  EXPECT_EQ(half.gradient({0, 0, 1}), Vec3<T>{});
  EXPECT_EQ(half.gradient({-1, 0, 1}), Vec3<T>{});
}

TYPED_TEST(CappedTorusTest, IsATorusIfNothingIsCutOff) {
  using T = TypeParam;
  const CappedTorus<T> whole(2, T(0.5), 180);
  const Torus<T> torus(2, T(0.5));
  RandomPoints<T> points(4);
  for (int i = 0; i < 1000; ++i) {
    auto p = points.next();
    if (i % 3 == 0) p = {-std::abs(p.x), 0, p.z};
    EXPECT_NEAR(whole.signedDistance(p), torus.signedDistance(p), tolerance<T>(8, 2)) << p;
  }
  EXPECT_EQ(whole.gradient({-3, 0, 0}), (Vec3<T>{-1, 0, 0}));  // no ends that are equally near
  EXPECT_EQ(whole.guarantee().inside, Quality::Exact);
}

TYPED_TEST(CappedTorusTest, IsATubeAroundItsArc) {
  using T = TypeParam;
  constexpr int kSamples = 4000;
  for (const int degrees : {20, 90, 135, 175}) {
    const CappedTorus<T> solid(2, T(0.125), static_cast<T>(degrees));
    RandomPoints<T> points(4);
    for (int i = 0; i < 100; ++i) {
      const auto p = points.next();
      double least = 1e9;
      for (int k = -kSamples; k <= kSamples; ++k) {
        const double angle = k * (degrees * std::numbers::pi / 180) / kSamples;
        const Vec3<double> q{2 * std::cos(angle), 2 * std::sin(angle), 0};
        least = std::min(least, length(Vec3<double>(p) - q));
      }
      EXPECT_NEAR(solid.signedDistance(p), least - 0.125, 2e-4) << p << " at " << degrees;
    }
  }
}

TYPED_TEST(CappedTorusTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((CappedTorus<T>(1, 1, 90)), Error);
  EXPECT_THROW((CappedTorus<T>(1, 0, 90)), Error);
  EXPECT_THROW((CappedTorus<T>(nan, T(0.5), 90)), Error);
  EXPECT_THROW((CappedTorus<T>(1, T(0.5), 0)), Error);
  EXPECT_THROW((CappedTorus<T>(1, T(0.5), 181)), Error);
  EXPECT_THROW((CappedTorus<T>(1, T(0.5), nan)), Error);
}

TYPED_TEST(CappedTorusTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(CappedTorus<T>(1, T(0.25), 60), 2);
  expectGuarantee(CappedTorus<T>(1, T(0.5), 130), 2.2);
  expectGuarantee(CappedTorus<T>(1, T(0.5), 170), 2.2);
  EXPECT_EQ(CappedTorus<T>(1, T(0.5), 149).guarantee().inside, Quality::Exact);
  EXPECT_EQ(CappedTorus<T>(1, T(0.5), 151).guarantee().inside, Quality::LowerBound);
}

TYPED_TEST(CappedTorusTest, FitsItsBoundingBox) {
  using T = TypeParam;
  const auto box = CappedTorus<T>(2, T(0.5), 30).boundingBox();
  EXPECT_NEAR(box.lower.x, T(std::sqrt(T(3)) - T(0.5)), tolerance<T>(8));
  EXPECT_NEAR(box.upper.y, T(1.5), tolerance<T>(20));
  EXPECT_NEAR(CappedTorus<T>(2, T(0.5), 120).boundingBox().upper.y, T(2.5), tolerance<T>(20));
}

TEST(CappedTorusRounding, StaysWithinItsBound) {
  expectRounding(CappedTorus<float>(2, 0.5f, 90), CappedTorus<double>(2, 0.5, 90), 4);
  expectRounding(CappedTorus<float>(2, 0.001f, 179), CappedTorus<double>(2, 0.001f, 179), 4);
  expectRounding(CappedTorus<float>(2, 0.5f, 1), CappedTorus<double>(2, 0.5, 1), 4);
}

}  // namespace
}  // namespace cutwater::test
