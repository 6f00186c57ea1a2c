#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Cone.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ConeTest : public ::testing::Test {};
TYPED_TEST_SUITE(ConeTest, Precisions);

TYPED_TEST(ConeTest, MatchesHandComputedValues) {
  using T = TypeParam;
  // Apex at the origin, base of radius 3 at z = 4: flank 5 long, normal (4, -3) / 5.
  const Cone<T> cone({0, 0, 0}, {0, 0, 4}, 3);
  EXPECT_EQ(cone.signedDistance({0, 0, -2}), T(2));
  EXPECT_EQ(cone.signedDistance({0, 0, 7}), T(3));
  EXPECT_EQ(cone.signedDistance({1, 2, 7}), T(3));
  EXPECT_EQ(cone.signedDistance({6, 0, 8}), T(5));
  EXPECT_EQ(cone.signedDistance({0, 0, 3.75}), T(-0.25));
  EXPECT_NEAR(cone.signedDistance({0, 0, 1}), T(T(-0.6)), tolerance<T>(4));
  EXPECT_NEAR(cone.signedDistance({4, 0, -3}), T(5), tolerance<T>(5));
  EXPECT_NEAR(cone.signedDistance({0, 5, 0}), T(4), tolerance<T>(5));
  EXPECT_NEAR(cone.gradient({4, 0, 2}).x, T(0.8), tolerance<T>(1));
  EXPECT_EQ(cone.gradient({0, 0, -1}), (Vec3<T>{0, 0, -1}));
  EXPECT_EQ(cone.gradient({0, 0, 4}), (Vec3<T>{0, 0, 1}));
}

TYPED_TEST(ConeTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((Cone<T>({0, 0, 0}, {0, 0, 0}, 1)), Error);
  EXPECT_THROW((Cone<T>({0, 0, 0}, {0, 0, 1}, 0)), Error);
  EXPECT_THROW((Cone<T>({0, 0, 0}, {0, 0, 1}, inf)), Error);
  EXPECT_THROW((Cone<T>({0, 0, nan}, {0, 0, 1}, 1)), Error);
}

TYPED_TEST(ConeTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(
      Cone<T>({0, 0, 1}, {0, 0, -1}, 1), 2,
      {.inside =
           [](const Vec3<double>& p) { return p.z > -1 && std::hypot(p.x, p.y) < (1 - p.z) / 2; },
       .covering = 4});
  expectGuarantee(Cone<T>({T(-0.6), T(0.1), T(-0.5)}, {T(0.5), T(0.7), T(0.9)}, T(0.9)), 2.5,
                  {.covering = 4});
}

TEST(ConeRounding, StaysWithinItsBound) {
  expectRounding(Cone<float>({0, 0, 0}, {0, 0, 4}, 3), Cone<double>({0, 0, 0}, {0, 0, 4}, 3), 4);
  expectRounding(Cone<float>({10, 11, 12}, {12, 10, 11.5f}, 0.001f),
                 Cone<double>({10, 11, 12}, {12, 10, 11.5f}, 0.001f), 4);
  expectRounding(Cone<float>({1, 2, 3}, {1, 2.001f, 3}, 10),
                 Cone<double>({1, 2, 3}, {1, 2.001f, 3}, 10), 4);
}

}  // namespace
}  // namespace cutwater::test
