#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/HexagonalPrism.hpp>

#include <numbers>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class HexagonalPrismTest : public ::testing::Test {};
TYPED_TEST_SUITE(HexagonalPrismTest, Precisions);

TYPED_TEST(HexagonalPrismTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const HexagonalPrism<T> prism(2, 6);
  const T corner = 4 / std::sqrt(T(3));  // from the axis
  EXPECT_EQ(prism.signedDistance({0, 0, 0}), T(-2));
  EXPECT_EQ(prism.signedDistance({0, 5, 0}), T(3));
  EXPECT_EQ(prism.signedDistance({1, -1, 2.5}), T(-0.5));
  EXPECT_EQ(prism.signedDistance({0, -6, 6}), T(5));
  EXPECT_NEAR(prism.signedDistance({corner + 4, 0, -6}), T(5), tolerance<T>(10));
  const T outer = T(0.5) * corner + 3;
  EXPECT_NEAR(prism.signedDistance({-outer, 6, 0}), T(5), tolerance<T>(10));  // off a corner
  EXPECT_EQ(prism.gradient({0, -3, 0}), (Vec3<T>{0, -1, 0}));
  EXPECT_EQ(prism.gradient({0, 5, 7}), (Vec3<T>{0, T(0.6), T(0.8)}));
  EXPECT_NEAR(prism.gradient({-1, T(-0.5), 0}).x, -std::sqrt(T(0.75)), tolerance<T>(1));
  EXPECT_EQ(prism.gradient({1, 0, 0}), Vec3<T>{});
}

TYPED_TEST(HexagonalPrismTest, LooksTheSameFromSixSides) {
  using T = TypeParam;
  const HexagonalPrism<T> prism(1, 1);
  auto turned = prism;
  turned.rotate(60, 2);
  RandomPoints<T> points(2);
  for (int i = 0; i < 1000; ++i) {
    const auto p = points.next();
    EXPECT_NEAR(prism.signedDistance(p), turned.signedDistance(p), tolerance<T>(4)) << p;
  }
}

TYPED_TEST(HexagonalPrismTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((HexagonalPrism<T>(0, 1)), Error);
  EXPECT_THROW((HexagonalPrism<T>(inf, 1)), Error);
  EXPECT_THROW((HexagonalPrism<T>(1, 0)), Error);
  EXPECT_THROW((HexagonalPrism<T>(1, -1)), Error);
  EXPECT_THROW((HexagonalPrism<T>(1, nan)), Error);
  EXPECT_THROW((HexagonalPrism<T>(1, inf)), Error);
}

TYPED_TEST(HexagonalPrismTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(HexagonalPrism<T>(1, 1), 2, {.inside = [](const Vec3<double>& p) {
                    bool inside = std::abs(p.z) < 0.5;
                    for (int side = 0; side < 6; ++side) {
                      const double angle = (30 + 60 * side) * std::numbers::pi / 180;
                      inside = inside && p.x * std::cos(angle) + p.y * std::sin(angle) < 1;
                    }
                    return inside;
                  }});
  expectGuarantee(HexagonalPrism<T>(T(0.5), 2), 2);
}

TEST(HexagonalPrismRounding, StaysWithinItsBound) {
  expectRounding(HexagonalPrism<float>(1, 3), HexagonalPrism<double>(1, 3), 4);
  expectRounding(HexagonalPrism<float>(3, 0.001f), HexagonalPrism<double>(3, 0.001f), 4);
}

}  // namespace
}  // namespace cutwater::test
