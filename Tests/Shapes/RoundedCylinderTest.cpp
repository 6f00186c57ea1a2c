#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/RoundedCylinder.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class RoundedCylinderTest : public ::testing::Test {};
TYPED_TEST_SUITE(RoundedCylinderTest, Precisions);

TYPED_TEST(RoundedCylinderTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const RoundedCylinder<T> can({0, 0, -2}, {0, 0, 2}, 2, 1);
  EXPECT_EQ(can.signedDistance({0, 0, 0}), T(-2));
  EXPECT_EQ(can.signedDistance({5, 0, 0.5}), T(3));
  EXPECT_EQ(can.signedDistance({0, 0.5, 6}), T(4));
  EXPECT_EQ(can.signedDistance({0, 4, 5}), T(4));
  EXPECT_NEAR(can.signedDistance({2, 0, 2}), T(std::sqrt(T(2)) - 1), tolerance<T>(4));
  const RoundedCylinder<T> pill({0, 0, -2}, {0, 0, 2}, 1, 1);  // a capsule
  EXPECT_EQ(pill.signedDistance({3, 0, 5}), T(4));
}

TYPED_TEST(RoundedCylinderTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((RoundedCylinder<T>({0, 0, 0}, {0, 0, 1}, 1, 0)), Error);
  EXPECT_THROW((RoundedCylinder<T>({0, 0, 0}, {0, 0, 1}, 1, T(0.625))), Error);
  EXPECT_THROW((RoundedCylinder<T>({0, 0, 0}, {0, 0, 9}, 1, T(1.5))), Error);
  EXPECT_THROW((RoundedCylinder<T>({0, 0, 0}, {0, 0, 0}, 1, T(0.5))), Error);
  EXPECT_THROW((RoundedCylinder<T>({0, 0, 0}, {0, 0, 1}, nan, T(0.1))), Error);
  EXPECT_THROW((RoundedCylinder<T>({0, 0, 0}, {0, 0, 1}, inf, T(0.1))), Error);
}

TYPED_TEST(RoundedCylinderTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(
      RoundedCylinder<T>({T(-0.6), T(0.1), T(-0.5)}, {T(0.5), T(0.7), T(0.9)}, T(0.5), T(0.2)), 2);
  expectGuarantee(RoundedCylinder<T>({0, 0, -1}, {0, 0, 1}, T(0.5), T(0.5)), 2);
}

TEST(RoundedCylinderRounding, StaysWithinItsBound) {
  expectRounding(RoundedCylinder<float>({0, 0, 0}, {0, 0, 4}, 2, 1),
                 RoundedCylinder<double>({0, 0, 0}, {0, 0, 4}, 2, 1), 4);
  expectRounding(RoundedCylinder<float>({10, 11, 12}, {12, 10, 11.5f}, 0.25f, 0.2f),
                 RoundedCylinder<double>({10, 11, 12}, {12, 10, 11.5f}, 0.25f, 0.2f), 4);
}

}  // namespace
}  // namespace cutwater::test
