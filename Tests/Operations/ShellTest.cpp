#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ShellTest : public ::testing::Test {
 protected:
  Sphere<T> ball_{{1, 0, 0}, 2};
  Cuboid<T> box_{{-1, -1, -1}, {1, 1, 1}};
};
TYPED_TEST_SUITE(ShellTest, Precisions);

TYPED_TEST(ShellTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const auto wall = shell(this->ball_, T(0.5));
  EXPECT_EQ(wall.signedDistance({1, 0, 0}), T(1.5));  // the hollow's middle
  EXPECT_EQ(wall.signedDistance({3, 0, 0}), T(-0.5));
  EXPECT_EQ(wall.signedDistance({6, 0, 0}), T(2.5));
  EXPECT_EQ(wall.gradient({2, 0, 0}), (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(wall.closestPoint({2, 0, 0}).point, (Vec3<T>{T(2.5), 0, 0}));
  EXPECT_EQ(wall.closestPoint({2, 0, 0}).normal, (Vec3<T>{-1, 0, 0}));
  EXPECT_NEAR(wall.boundingBox().upper.x, T(3.5), tolerance<T>(4, 256));
  std::size_t found = 0;
  wall.crossings({{-9, 0, 0}, {9, 0, 0}}, [&](const Crossing<T>&) { return ++found > 0; });
  EXPECT_EQ(found, 4U);
  const auto range = wall.bounds({{-9, -9, -9}, {9, 9, 9}});
  EXPECT_NEAR(range.lower, T(-0.5), tolerance<T>(8));  // nowhere deeper, however large the box
  EXPECT_EQ(wall.classify({{0, -1, -1}, {2, 1, 1}}), BoxClass::Cut);  // corners in the wall
  EXPECT_EQ(wall.classify({{T(0.5), T(-0.5), T(-0.5)}, {T(1.5), T(0.5), T(0.5)}}),
            BoxClass::Outside);
}

TYPED_TEST(ShellTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto wall = shell(this->box_, T(0.25));
  EXPECT_EQ(wall.guarantee().outside, Quality::Exact);
  EXPECT_EQ(wall.guarantee().inside, Quality::LowerBound);
  expectGuarantee(wall, 2, {.inside = [](const Vec3<double>& p) {
                    const bool isNear = length(max(abs(p) - Vec3<double>{1, 1, 1}, {})) < 0.25;
                    return isNear && maxComponent(abs(p)) > 0.75;
                  }});
  expectGuarantee(shell(this->ball_, T(0.75)), 4.5);
  const auto both = shell(this->box_ | this->ball_, T(0.25));
  EXPECT_EQ(both.guarantee().outside, Quality::LowerBound);
  expectGuarantee(rotated(both, 30, {1, 2, 3}), 4.5);
  expectGuarantee(shell(shell(this->ball_, T(0.5)), T(0.125)), 4.5);
  expectGuarantee(shell(Plane<T>({0, 0, 0}, {1, 2, 3}), T(0.5)), 3);
}

TYPED_TEST(ShellTest, IsTheSameForTheComplementToTheBit) {
  using T = TypeParam;
  for (const T x : {T(-3), T(0.3), T(1), T(2.9), T(3), T(7)}) {
    const Vec3<T> p{x, T(0.1), T(0.7)};
    EXPECT_EQ(shell(this->ball_, T(0.1)).signedDistance(p),
              shell(~this->ball_, T(0.1)).signedDistance(p));
  }
}

TYPED_TEST(ShellTest, RefusesImpossibleThickness) {
  using T = TypeParam;
  for (const T bad :
       {T(0), T(-1), std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN()}) {
    EXPECT_THROW(static_cast<void>(shell(this->ball_, bad)), Error);
  }
}

}  // namespace
}  // namespace cutwater::test
