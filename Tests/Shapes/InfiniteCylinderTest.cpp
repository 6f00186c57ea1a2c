#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class InfiniteCylinderTest : public ::testing::Test {};
TYPED_TEST_SUITE(InfiniteCylinderTest, Precisions);

TYPED_TEST(InfiniteCylinderTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const InfiniteCylinder<T> pipe({1, 1, 0}, {0, 0, -3}, 2);
  EXPECT_EQ(pipe.signedDistance({1, 1, 900}), T(-2));
  EXPECT_EQ(pipe.signedDistance({4, 5, -70}), T(3));
  EXPECT_EQ(pipe.signedDistance({1, 3, 0}), T(0));
  EXPECT_NEAR(pipe.gradient({4, 5, 1}).y, T(0.8), tolerance<T>(1));
  EXPECT_EQ(pipe.gradient({1, 1, 5}), Vec3<T>{});
}

TYPED_TEST(InfiniteCylinderTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((InfiniteCylinder<T>({0, 0, 0}, {0, 0, 0}, 1)), Error);
  EXPECT_THROW((InfiniteCylinder<T>({0, 0, 0}, {0, 0, 1}, 0)), Error);
  EXPECT_THROW((InfiniteCylinder<T>({0, 0, 0}, {0, 0, 1}, inf)), Error);
  EXPECT_THROW((InfiniteCylinder<T>({nan, 0, 0}, {0, 0, 1}, 1)), Error);
}

TYPED_TEST(InfiniteCylinderTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(InfiniteCylinder<T>({T(0.1), T(0.2), 0}, {0, 0, 1}, T(0.75)), 2,
                  {.inside = [](const Vec3<double>& p) {
                    return std::hypot(p.x - double(T(0.1)), p.y - double(T(0.2))) < 0.75;
                  }});
  expectGuarantee(InfiniteCylinder<T>({T(0.1), T(0.2), 0}, {1, -1, 2}, T(0.75)), 3);
}

TYPED_TEST(InfiniteCylinderTest, IsBoundedAcrossACoordinateAxisOnly) {
  using T = TypeParam;
  const auto along = InfiniteCylinder<T>({1, 1, 0}, {0, 0, 2}, 2).boundingBox();
  EXPECT_NEAR(along.lower.x, T(-1), tolerance<T>(10));
  EXPECT_EQ(along.upper.z, Box<T>::kInf);
  const auto inPlane = InfiniteCylinder<T>({1, 1, 0}, {0, 1, 2}, 2).boundingBox();
  EXPECT_NEAR(inPlane.upper.x, T(3), tolerance<T>(10));
  EXPECT_EQ(inPlane.lower.y, -Box<T>::kInf);
}

TEST(InfiniteCylinderRounding, StaysWithinItsBound) {
  expectRounding(InfiniteCylinder<float>({1, 1, 0}, {0, 0, -3}, 2),
                 InfiniteCylinder<double>({1, 1, 0}, {0, 0, -3}, 2), 4);
  expectRounding(InfiniteCylinder<float>({10, 10, 0}, {1, 2, -3}, 0.1f),
                 InfiniteCylinder<double>({10, 10, 0}, {1, 2, -3}, 0.1f), 4);
}

}  // namespace
}  // namespace cutwater::test
