#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class RoundedBoxTest : public ::testing::Test {};
TYPED_TEST_SUITE(RoundedBoxTest, Precisions);

TYPED_TEST(RoundedBoxTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const RoundedBox<T> box({-2, -2, -2}, {2, 2, 2}, 1);
  EXPECT_EQ(box.signedDistance({0, 0, 0}), T(-2));
  EXPECT_EQ(box.signedDistance({5, 0, 0}), T(3));
  EXPECT_EQ(box.signedDistance({1, 4, 5}), T(4));
  EXPECT_EQ(box.signedDistance({4, 5, 1}), T(4));
  EXPECT_NEAR(box.signedDistance({2, 2, 1}), T(std::sqrt(T(2)) - 1), tolerance<T>(4));
  EXPECT_EQ(box.signedDistance({2, 0.5, 0.5}), T(0));
  const RoundedBox<T> ball({-1, -1, -1}, {1, 1, 1}, 1);
  EXPECT_NEAR(ball.signedDistance({3, 4, 0}), T(4), tolerance<T>(4));
}

TYPED_TEST(RoundedBoxTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((RoundedBox<T>({0, 0, 0}, {1, 1, 1}, 0)), Error);
  EXPECT_THROW((RoundedBox<T>({0, 0, 0}, {1, 1, 1}, T(0.75))), Error);
  EXPECT_THROW((RoundedBox<T>({0, 0, 0}, {1, 1, -1}, T(0.1))), Error);
  EXPECT_THROW((RoundedBox<T>({0, 0, 0}, {1, 1, 1}, nan)), Error);
  EXPECT_THROW((RoundedBox<T>({0, 0, 0}, {1, 1, inf}, T(0.1))), Error);
}

TYPED_TEST(RoundedBoxTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(RoundedBox<T>({-1, T(-0.5), -1}, {1, T(0.75), T(0.25)}, T(0.25)), 2);
  expectGuarantee(RoundedBox<T>({-1, T(-0.5), -1}, {1, T(0.75), T(0.3)}, T(0.625)), 2);
}

TEST(RoundedBoxRounding, StaysWithinItsBound) {
  expectRounding(RoundedBox<float>({-1, -2, -3}, {1, 2, 3}, 0.3f),
                 RoundedBox<double>({-1, -2, -3}, {1, 2, 3}, 0.3f), 4);
  expectRounding(RoundedBox<float>({99, 99, 0}, {100, 100.5f, 1}, 0.5f),
                 RoundedBox<double>({99, 99, 0}, {100, 100.5f, 1}, 0.5f), 4);
}

}  // namespace
}  // namespace cutwater::test
