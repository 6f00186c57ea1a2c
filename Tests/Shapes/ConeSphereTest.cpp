#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/ConeSphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ConeSphereTest : public ::testing::Test {};
TYPED_TEST_SUITE(ConeSphereTest, Precisions);

TYPED_TEST(ConeSphereTest, MatchesHandComputedValues) {
  using T = TypeParam;
  // l = 5, s = 3/5, c = 4/5: tangent circles at radius 4 c and 1 c.
  const ConeSphere<T> drop({0, 0, 0}, {0, 0, 5}, 4, 1);
  EXPECT_EQ(drop.signedDistance({0, 0, -7}), T(3));
  EXPECT_EQ(drop.signedDistance({0, 0, 8}), T(2));
  EXPECT_EQ(drop.signedDistance({3, 0, -4}), T(1));
  EXPECT_EQ(drop.signedDistance({0, 3, 9}), T(4));
  const Vec3<T> onFlank{T(4) * T(0.8), 0, T(4) * T(0.6)};
  EXPECT_NEAR(drop.signedDistance(onFlank), T(0), tolerance<T>(5));
  EXPECT_NEAR(drop.signedDistance({8, 0, 8}), T(7.2), tolerance<T>(16));  // 8 c + 8 s - 4
  EXPECT_NEAR(drop.gradient({8, 0, 8}).z, T(0.6), tolerance<T>(1));
  // One ball swallows the other, also just touching it from within, at either end.
  EXPECT_EQ((ConeSphere<T>({0, 0, 0}, {0, 0, 1}, 3, 1).signedDistance({0, 0, 5})), T(2));
  EXPECT_EQ((ConeSphere<T>({0, 0, 0}, {0, 0, 2}, 3, 1).signedDistance({3, 0, 4})), T(2));
  EXPECT_EQ((ConeSphere<T>({0, 0, 0}, {0, 0, 1}, 1, 3).signedDistance({0, 0, -5})), T(3));
  EXPECT_EQ((ConeSphere<T>({1, 0, 0}, {1, 0, 0}, 1, 3).signedDistance({1, 0, 0})), T(-3));
}

TYPED_TEST(ConeSphereTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((ConeSphere<T>({0, 0, 0}, {0, 0, 1}, 0, 0)), Error);
  EXPECT_THROW((ConeSphere<T>({0, 0, 0}, {0, 0, 1}, -1, 2)), Error);
  EXPECT_THROW((ConeSphere<T>({0, 0, 0}, {0, 0, 1}, 1, nan)), Error);
  EXPECT_THROW((ConeSphere<T>({0, 0, 0}, {0, 0, inf}, 1, 1)), Error);
  EXPECT_THROW((ConeSphere<T>({0, 0, 0}, {0, 0, 1}, inf, 1)), Error);
}

TYPED_TEST(ConeSphereTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(
      ConeSphere<T>({T(-0.5), 0, T(-0.25)}, {T(0.5), T(0.25), T(0.75)}, T(0.75), T(0.25)), 2.5,
      {.inside = [](const Vec3<double>& p) {
        // The hull of two balls is the union of the balls between them, with centres a + t d: one
        // of them holds p if the quadratic |p - a - t d|^2 - (radius at t)^2 is negative somewhere.
        const Vec3<double> a{-0.5, 0, -0.25};
        const Vec3<double> d{1, 0.25, 1};
        const double t = std::clamp((dot(p - a, d) - 0.75 * 0.5) / (dot(d, d) - 0.25), 0.0, 1.0);
        return length(p - a - t * d) < 0.75 - 0.5 * t;
      }});
  expectGuarantee(ConeSphere<T>({0, 0, -1}, {0, 0, 1}, 0, T(0.5)), 2, {.covering = 6});
  expectGuarantee(ConeSphere<T>({0, 0, 0}, {0, 0, T(0.5)}, 1, T(0.25)), 2);
  expectGuarantee(ConeSphere<T>({0, 0, 0}, {0, 0, T(0.5)}, 1, T(0.5001)), 2);
}

TEST(ConeSphereRounding, StaysWithinItsBound) {
  expectRounding(ConeSphere<float>({0, 0, 0}, {0, 0, 5}, 4, 1),
                 ConeSphere<double>({0, 0, 0}, {0, 0, 5}, 4, 1), 4);
  expectRounding(ConeSphere<float>({0, 0, 0}, {0, 0, 1}, 2, 1.0000001f),
                 ConeSphere<double>({0, 0, 0}, {0, 0, 1}, 2, 1.0000001f), 4);
  expectRounding(ConeSphere<float>({10, 11, 12}, {12, 10, 11.5f}, 0.25f, 0),
                 ConeSphere<double>({10, 11, 12}, {12, 10, 11.5f}, 0.25f, 0), 4);
  expectRounding(ConeSphere<float>({0, 0, 0}, {1, 2, 3}, 0.5f, 0.499f),
                 ConeSphere<double>({0, 0, 0}, {1, 2, 3}, 0.5f, 0.499f), 4);
}

}  // namespace
}  // namespace cutwater::test
