#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Capsule.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class CapsuleTest : public ::testing::Test {};
TYPED_TEST_SUITE(CapsuleTest, Precisions);

TYPED_TEST(CapsuleTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const Capsule<T> pill({0, 0, 0}, {0, 0, 4}, 2);
  EXPECT_EQ(pill.signedDistance({0, 0, 2}), T(-2));
  EXPECT_EQ(pill.signedDistance({5, 0, 2}), T(3));
  EXPECT_EQ(pill.signedDistance({0, 3, 8}), T(3));
  EXPECT_EQ(pill.signedDistance({0, 3, -4}), T(3));
  EXPECT_EQ(pill.signedDistance({0, 0, -2}), T(0));
  EXPECT_EQ(pill.gradient({0, 0, 2}), Vec3<T>{});
  EXPECT_EQ(pill.gradient({0, 0, 5}), (Vec3<T>{0, 0, 1}));
  const Capsule<T> ball({1, 2, 3}, {1, 2, 3}, 5);  // no length: a ball
  EXPECT_EQ(ball.signedDistance({1, 2, 11}), T(3));
  EXPECT_EQ(ball.signedDistance({4, 6, 3}), T(0));
}

TYPED_TEST(CapsuleTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((Capsule<T>({0, 0, 0}, {0, 0, 1}, 0)), Error);
  EXPECT_THROW((Capsule<T>({0, 0, nan}, {0, 0, 1}, 1)), Error);
  EXPECT_THROW((Capsule<T>({0, 0, 0}, {0, 0, inf}, 1)), Error);
  EXPECT_THROW((Capsule<T>({0, 0, 0}, {0, 0, 1}, inf)), Error);
}

TYPED_TEST(CapsuleTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(Capsule<T>({T(-0.6), T(0.1), T(-0.5)}, {T(0.5), T(0.7), T(0.9)}, T(0.5)), 2.5,
                  {.inside = [](const Vec3<double>& p) {
                    const Vec3<double> a{double(T(-0.6)), double(T(0.1)), -0.5};
                    const Vec3<double> d = Vec3<double>{0.5, double(T(0.7)), double(T(0.9))} - a;
                    const double h = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
                    return length(p - a - h * d) < 0.5;
                  }});
  expectGuarantee(Capsule<T>({0, 0, 0}, {0, 0, 0}, 1), 2);
}

TEST(CapsuleRounding, StaysWithinItsBound) {
  expectRounding(Capsule<float>({0, 0, 0}, {0, 0, 4}, 2), Capsule<double>({0, 0, 0}, {0, 0, 4}, 2),
                 4);
  expectRounding(Capsule<float>({10, 11, 12}, {12, 10, 11.5f}, 0.25f),
                 Capsule<double>({10, 11, 12}, {12, 10, 11.5f}, 0.25f), 4);
  expectRounding(Capsule<float>({1, 2, 3}, {1, 2, 3}, 1), Capsule<double>({1, 2, 3}, {1, 2, 3}, 1),
                 4);
}

}  // namespace
}  // namespace cutwater::test
