// Ranges of values in boxes, where shapes know them in closed form.

#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <gtest/gtest.h>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class BoxBoundsTest : public ::testing::Test {
 protected:
  /// No value is outside, and the ends are values, but for rounding.
  static void expectTight(const Solid<T>& solid) {
    RandomPoints<T> points(2, 31);
    for (int i = 0; i < 200; ++i) {
      const auto center = points.next();
      const auto half = T(0.5) * abs(points.next());
      const Box<T> box{center - half, center + half};
      const auto range = solid.bounds(box);
      T least = std::numeric_limits<T>::max();
      T most = -least;
      constexpr int kSteps = 24;
      for (int k = 0; k < kSteps * kSteps * kSteps; ++k) {
        const auto at = [](int step) { return T(step % kSteps) / T(kSteps - 1); };
        const Vec3<T> t{at(k), at(k / kSteps), at(k / kSteps / kSteps)};
        const auto size = box.size();
        const T value =
            solid.signedDistance(box.lower + Vec3<T>{t.x * size.x, t.y * size.y, t.z * size.z});
        least = std::min(least, value);
        most = std::max(most, value);
      }
      const T rounding = 100 * std::numeric_limits<T>::epsilon();
      ASSERT_LE(range.lower, least + rounding) << i;
      ASSERT_GE(range.upper, most - rounding) << i;
      // No point is farther from a sample than half a step on each axis.
      const T step = length(half) / T(kSteps - 1);
      ASSERT_GE(range.lower, least - step - rounding) << i;
      ASSERT_LE(range.upper, most + step + rounding) << i;
      // What one value tells would be this wide.
      if (range.upper - range.lower < T(1.2) * length(half)) ++narrow;
    }
  }
  static inline int narrow = 0;
};
TYPED_TEST_SUITE(BoxBoundsTest, Precisions);

TYPED_TEST(BoxBoundsTest, AreTheRange) {
  using T = TypeParam;
  this->narrow = 0;
  this->expectTight(Sphere<T>({T(0.25), 0, T(-0.5)}, T(0.75)));
  this->expectTight(Cuboid<T>({-1, T(-0.5), 0}, {T(0.5), 1, T(0.75)}));
  this->expectTight(RoundedBox<T>(Box<T>{{-1, T(-0.5), 0}, {T(0.5), 1, T(0.75)}}, T(0.25)));
  this->expectTight(Plane<T>({T(0.1), T(0.2), T(0.3)}, {1, 2, -1}));
  EXPECT_GT(this->narrow, 50);
}

TYPED_TEST(BoxBoundsTest, OfTurnedSpheresAndPlanesToo) {
  using T = TypeParam;
  Solid<T> sphere = Sphere<T>({1, 0, 0}, T(0.75));
  sphere.rotate(35, {1, 2, 3});
  this->expectTight(sphere);
  Solid<T> plane = Plane<T>({0, 0, 0}, {0, 0, 1});
  plane.rotate(35, {1, 2, 3});
  this->expectTight(plane);
}

TYPED_TEST(BoxBoundsTest, DistancesAreNeverNegative) {
  using T = TypeParam;
  const Sphere<T> ball({0, 0, 0}, 1);
  const auto across = ball.distanceBounds({{T(0.5), T(-0.1), T(-0.1)}, {2, T(0.1), T(0.1)}});
  EXPECT_EQ(across.lower, 0);
  EXPECT_GE(across.upper, 1);
  EXPECT_LT(across.upper, T(1.1));
  const auto inside = ball.distanceBounds({{T(-0.1), T(-0.1), T(-0.1)}, {T(0.1), T(0.1), T(0.1)}});
  EXPECT_NEAR(double(inside.lower), 1 - 0.1 * std::sqrt(3), 1e-5);
  EXPECT_NEAR(double(inside.upper), 1, 1e-5);
  EXPECT_EQ(ball.distanceBounds({}).upper, std::numeric_limits<T>::infinity());
}

}  // namespace
}  // namespace cutwater::test
