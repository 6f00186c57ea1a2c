#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class CappedConeTest : public ::testing::Test {};
TYPED_TEST_SUITE(CappedConeTest, Precisions);

TYPED_TEST(CappedConeTest, MatchesHandComputedValues) {
  using T = TypeParam;
  // Radii 4 and 1 over a height of 4: flank 5 long, normal (4, 3) / 5.
  const CappedCone<T> cone({0, 0, 0}, {0, 0, 4}, 4, 1);
  EXPECT_EQ(cone.signedDistance({1, 2, -2}), T(2));
  EXPECT_EQ(cone.signedDistance({0, 0.5, 7}), T(3));
  EXPECT_EQ(cone.signedDistance({4, 0, 8}), T(5));
  EXPECT_EQ(cone.signedDistance({0, 7, -4}), T(5));
  EXPECT_EQ(cone.signedDistance({0, 0, 0.5}), T(-0.5));
  EXPECT_NEAR(cone.signedDistance({8, 0, 3}), T(5), tolerance<T>(8));
  EXPECT_EQ(cone.signedDistance({4, 0, 0}), T(0));
  EXPECT_NEAR(cone.gradient({8, 0, 3}).z, T(0.6), tolerance<T>(1));
  EXPECT_EQ(cone.gradient({0, 0, 0}), (Vec3<T>{0, 0, -1}));
  EXPECT_EQ(cone.gradient({4, 0, 0}), Vec3<T>{});  // on the rim
  const CappedCone<T> can({0, 0, 0}, {0, 0, 4}, 2, 2);
  EXPECT_EQ(can.signedDistance({5, 0, 2}), T(3));
}

TYPED_TEST(CappedConeTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((CappedCone<T>({0, 0, 0}, {0, 0, 0}, 1, 2)), Error);
  EXPECT_THROW((CappedCone<T>({0, 0, 0}, {0, 0, 1}, 0, 0)), Error);
  EXPECT_THROW((CappedCone<T>({0, 0, 0}, {0, 0, 1}, -1, 1)), Error);
  EXPECT_THROW((CappedCone<T>({0, 0, 0}, {0, 0, 1}, 1, inf)), Error);
  EXPECT_THROW((CappedCone<T>({0, 0, 0}, {0, nan, 1}, 1, 1)), Error);
}

TYPED_TEST(CappedConeTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(CappedCone<T>({0, 0, -1}, {0, 0, 1}, 1, T(0.5)), 2,
                  {.inside = [](const Vec3<double>& p) {
                    return std::abs(p.z) < 1 && std::hypot(p.x, p.y) < 0.75 - 0.25 * p.z;
                  }});
  expectGuarantee(
      CappedCone<T>({T(-0.6), T(0.1), T(-0.5)}, {T(0.5), T(0.7), T(0.9)}, T(0.3), T(0.9)), 2.5);
  expectGuarantee(CappedCone<T>({0, 0, 0}, {0, 0, T(0.25)}, T(1.25), T(0.1)), 2, {.covering = 6});
}

TEST(CappedConeRounding, StaysWithinItsBound) {
  expectRounding(CappedCone<float>({0, 0, 0}, {0, 0, 4}, 4, 1),
                 CappedCone<double>({0, 0, 0}, {0, 0, 4}, 4, 1), 4);
  expectRounding(CappedCone<float>({10, 11, 12}, {12, 10, 11.5f}, 0.001f, 3),
                 CappedCone<double>({10, 11, 12}, {12, 10, 11.5f}, 0.001f, 3), 4);
  expectRounding(CappedCone<float>({1, 2, 3}, {1, 2.001f, 3}, 10, 9),
                 CappedCone<double>({1, 2, 3}, {1, 2.001f, 3}, 10, 9), 4);
}

}  // namespace
}  // namespace cutwater::test
