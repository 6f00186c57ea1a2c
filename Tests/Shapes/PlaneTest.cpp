#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Plane.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class PlaneTest : public ::testing::Test {};
TYPED_TEST_SUITE(PlaneTest, Precisions);

TYPED_TEST(PlaneTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const Plane<T> plane({1, 2, 3}, {0, 0, 2});
  EXPECT_EQ(plane.signedDistance({0, 0, 3}), T(0));
  EXPECT_EQ(plane.signedDistance({7, -8, 5}), T(2));
  EXPECT_EQ(plane.signedDistance({0, 0, 0}), T(-3));
  EXPECT_EQ(plane.gradient({4, 5, 6}), (Vec3<T>{0, 0, 1}));
  const Plane<T> slanted({0, 0, 0}, {3, 0, -4});
  EXPECT_NEAR(slanted.signedDistance({5, 9, 0}), T(3), tolerance<T>(10));
}

TYPED_TEST(PlaneTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((Plane<T>({0, 0, 0}, {0, 0, 0})), Error);
  EXPECT_THROW((Plane<T>({nan, 0, 0}, {0, 0, 1})), Error);
  EXPECT_THROW((Plane<T>({0, 0, 0}, {0, inf, 1})), Error);
}

TYPED_TEST(PlaneTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(Plane<T>({T(0.1), T(0.2), T(0.3)}, {1, -2, T(0.5)}), 3,
                  {.inside = [](const Vec3<double>& p) {
                    return (p.x - 0.1) - 2 * (p.y - 0.2) + 0.5 * (p.z - 0.3) < 0;
                  }});
  expectGuarantee(Plane<T>({0, 0, T(0.5)}, {0, 0, -1}), 2);
}

TYPED_TEST(PlaneTest, IsBoundedAlongItsNormalOnly) {
  using T = TypeParam;
  const auto box = Plane<T>({1, 2, 3}, {0, -1, 0}).boundingBox();
  EXPECT_NEAR(box.lower.y, T(2), tolerance<T>(10));
  EXPECT_LT(box.lower.y, T(2));
  EXPECT_EQ(box.upper.y, Box<T>::kInf);
  // However slight a tilt, the plane reaches any height.
  EXPECT_EQ(Plane<T>({1, 2, 3}, {T(1e-20), 1, 0}).boundingBox(), Box<T>::everywhere());
  EXPECT_EQ(Plane<T>({1, 2, 3}, {1, 1, 0}).boundingBox(), Box<T>::everywhere());
}

TEST(PlaneRounding, StaysWithinItsBound) {
  expectRounding(Plane<float>({100, 0.2f, 0.3f}, {1, -2, 0.1f}),
                 Plane<double>({100, 0.2f, 0.3f}, {1, -2, 0.1f}), 4);
  expectRounding(Plane<float>({0, 0, 0}, {0, 0, 1}), Plane<double>({0, 0, 0}, {0, 0, 1}), 4);
}

}  // namespace
}  // namespace cutwater::test
