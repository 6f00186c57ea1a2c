#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Link.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class LinkTest : public ::testing::Test {};
TYPED_TEST_SUITE(LinkTest, Precisions);

TYPED_TEST(LinkTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const Link<T> link(4, 3, 1);
  EXPECT_EQ(link.signedDistance({3, 1, 0}), T(-1));
  EXPECT_EQ(link.signedDistance({0, 5, 0}), T(-1));
  EXPECT_EQ(link.signedDistance({0, 0, 4}), T(4));
  EXPECT_EQ(link.signedDistance({-6, -2, 4}), T(4));
  EXPECT_EQ(link.signedDistance({0, -9, 3}), T(4));
  EXPECT_EQ(link.gradient({-6, -2, 4}), (Vec3<T>{T(-0.6), 0, T(0.8)}));
  EXPECT_EQ(link.gradient({0, -9, 0}), (Vec3<T>{0, -1, 0}));
  EXPECT_EQ(link.gradient({0, 1, 1}), Vec3<T>{});
}

TYPED_TEST(LinkTest, IsATorusWithoutLengthAndACapsulesRimWithout) {
  using T = TypeParam;
  const Link<T> round(0, 2, T(0.5));
  const Torus<T> torus(2, T(0.5));
  const Link<T> link(3, 2, T(0.5));
  const Capsule<T> capsule({0, T(-1.5), 0}, {0, T(1.5), 0}, 2);
  RandomPoints<T> points(4);
  for (int i = 0; i < 1000; ++i) {
    const auto p = points.next();
    EXPECT_NEAR(round.signedDistance(p), torus.signedDistance(p), tolerance<T>(8, 2)) << p;
    // In the plane of the link its centre line is the outline of a capsule.
    const T outline = std::abs(capsule.signedDistance({p.x, p.y, 0}));
    EXPECT_NEAR(link.signedDistance(p), std::hypot(outline, p.z) - T(0.5), tolerance<T>(8, 4)) << p;
  }
}

TYPED_TEST(LinkTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((Link<T>(-1, 2, 1)), Error);
  EXPECT_THROW((Link<T>(inf, 2, 1)), Error);
  EXPECT_THROW((Link<T>(1, 1, 1)), Error);
  EXPECT_THROW((Link<T>(1, 1, 0)), Error);
  EXPECT_THROW((Link<T>(1, nan, T(0.5))), Error);
}

TYPED_TEST(LinkTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(Link<T>(1, T(0.5), T(0.25)), 2);
  expectGuarantee(Link<T>(T(0.5), T(0.75), T(0.7)), 2);
}

TEST(LinkRounding, StaysWithinItsBound) {
  expectRounding(Link<float>(3, 2, 0.5f), Link<double>(3, 2, 0.5), 4);
  expectRounding(Link<float>(0.001f, 2, 0.001f), Link<double>(0.001f, 2, 0.001f), 4);
}

}  // namespace
}  // namespace cutwater::test
