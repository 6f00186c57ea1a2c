#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Pyramid.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class PyramidTest : public ::testing::Test {};
TYPED_TEST_SUITE(PyramidTest, Precisions);

TYPED_TEST(PyramidTest, MatchesHandComputedValues) {
  using T = TypeParam;
  // Flanks (x - 3) 4 + z 3 = 0: normal (4, 0, 3) / 5.
  const Pyramid<T> solid(6, 4);
  EXPECT_NEAR(solid.signedDistance({0, 0, 8}), T(4), tolerance<T>(8));
  EXPECT_EQ(solid.signedDistance({1, 2, -5}), T(5));
  EXPECT_EQ(solid.signedDistance({0, 6, -4}), T(5));
  EXPECT_EQ(solid.signedDistance({0, 0, T(0.5)}), T(-0.5));
  EXPECT_NEAR(solid.signedDistance({0, 0, 3}), T(-0.6), tolerance<T>(6));
  EXPECT_NEAR(solid.signedDistance({T(-5.5), 0, 5}), T(5), tolerance<T>(10));
  EXPECT_NEAR(solid.signedDistance({6, 6, 0}), T(std::sqrt(T(18))), tolerance<T>(10));
  // From (3/2, 3/2, 2), the middle of a slanted edge, along the sum of its flanks' normals.
  const Vec3<T> off = T(3) * normalized(Vec3<T>{4, 4, 6});
  EXPECT_NEAR(solid.signedDistance(Vec3<T>{1.5, 1.5, 2} + off), T(3), tolerance<T>(10));
  EXPECT_EQ(solid.gradient({T(0.5), 1, -2}), (Vec3<T>{0, 0, -1}));
  EXPECT_LT(length(solid.gradient({0, -6, 4}) - Vec3<T>{0, T(-0.8), T(0.6)}), tolerance<T>(1));
  EXPECT_LT(length(solid.gradient({T(-0.5), 0, 3}) - Vec3<T>{T(-0.8), 0, T(0.6)}), tolerance<T>(1));
  EXPECT_EQ(solid.gradient({T(0.25), T(-0.25), 3}), Vec3<T>{});
}

TYPED_TEST(PyramidTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  EXPECT_THROW((Pyramid<T>(0, 1)), Error);
  EXPECT_THROW((Pyramid<T>(1, 0)), Error);
  EXPECT_THROW((Pyramid<T>(inf, 1)), Error);
  EXPECT_THROW((Pyramid<T>(1, std::numeric_limits<T>::quiet_NaN())), Error);
}

TYPED_TEST(PyramidTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(Pyramid<T>(2, 1), 2,
                  {.inside =
                       [](const Vec3<double>& p) {
                         return p.z > 0 && std::abs(p.x) + p.z < 1 && std::abs(p.y) + p.z < 1;
                       },
                   .covering = 4});
  expectGuarantee(Pyramid<T>(1, T(1.75)), 2, {.covering = 5});
  expectGuarantee(Pyramid<T>(2, T(0.25)), 2, {.covering = 4});
}

TEST(PyramidRounding, StaysWithinItsBound) {
  expectRounding(Pyramid<float>(2, 1), Pyramid<double>(2, 1), 4);
  expectRounding(Pyramid<float>(2, 0.001f), Pyramid<double>(2, 0.001f), 4);
  expectRounding(Pyramid<float>(0.001f, 2), Pyramid<double>(0.001f, 2), 4);
}

}  // namespace
}  // namespace cutwater::test
