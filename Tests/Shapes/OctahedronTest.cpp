#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Octahedron.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OctahedronTest : public ::testing::Test {};
TYPED_TEST_SUITE(OctahedronTest, Precisions);

TYPED_TEST(OctahedronTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const Octahedron<T> solid(3);
  const T root3 = std::sqrt(T(3));
  EXPECT_NEAR(solid.signedDistance({0, 0, 0}), -root3, tolerance<T>(3));
  EXPECT_NEAR(solid.signedDistance({-2, 2, 2}), root3, tolerance<T>(3));            // face
  EXPECT_NEAR(solid.signedDistance({3, -2, 0}), std::sqrt(T(2)), tolerance<T>(3));  // edge
  EXPECT_EQ(solid.signedDistance({0, 0, -7}), T(4));                                // corner
  EXPECT_EQ(solid.signedDistance({0, 7, 3}), T(5));
  EXPECT_EQ(solid.signedDistance({1, 1, 1}), T(0));
  EXPECT_EQ(solid.gradient({0, 0, -7}), (Vec3<T>{0, 0, -1}));
  EXPECT_EQ(solid.gradient({T(-0.5), T(0.25), 1}), normalized(Vec3<T>{-1, 1, 1}));
  EXPECT_EQ(solid.gradient({1, 0, 1}), Vec3<T>{});
}

TYPED_TEST(OctahedronTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW(Octahedron<T>{0}, Error);
  EXPECT_THROW(Octahedron<T>{inf}, Error);
  EXPECT_THROW(Octahedron<T>{nan}, Error);
}

TYPED_TEST(OctahedronTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(
      Octahedron<T>(1), 2,
      {.inside =
           [](const Vec3<double>& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1; },
       .covering = 4});
}

TEST(OctahedronRounding, StaysWithinItsBound) {
  expectRounding(Octahedron<float>(1.3f), Octahedron<double>(1.3f), 4);
}

}  // namespace
}  // namespace cutwater::test
