#include <Cutwater/Core/OrientedBox.hpp>
#include <Cutwater/Core/RigidTransform.hpp>

#include <gtest/gtest.h>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OrientedBoxTest : public ::testing::Test {
 protected:
  /// Turned by any angles; some are flat, some a point.
  static OrientedBox<T> turned(RandomPoints<T>& points, int i) {
    auto half = abs(points.next());
    if (i % 3 == 0) half.x = 0;
    if (i % 6 == 0) half.y = 0;
    if (i % 12 == 0) half.z = 0;
    RigidTransform<T> motion;
    motion.rotate(T(10 * i % 360), {1, 2, T(i % 5)});
    OrientedBox<T> box;
    box.center = points.next();
    for (int axis = 0; axis < 3; ++axis) {
      box.halfAxis[static_cast<std::size_t>(axis)] = half[axis] * motion.axis(axis);
    }
    return box;
  }
  static constexpr T kEps = std::numeric_limits<T>::epsilon();
};
TYPED_TEST_SUITE(OrientedBoxTest, Precisions);

TYPED_TEST(OrientedBoxTest, EnclosesDistancesAndNoMore) {
  using T = TypeParam;
  RandomPoints<T> points(2, 9);
  for (int i = 0; i < 300; ++i) {
    const auto box = this->turned(points, i);
    const auto p = points.next();
    const auto distances = box.distancesFrom(p);
    T nearest = std::numeric_limits<T>::max();
    T farthest = 0;
    constexpr int kSteps = 16;
    for (int k = 0; k < (kSteps + 1) * (kSteps + 1) * (kSteps + 1); ++k) {
      Vec3<T> q = box.center;
      int rest = k;
      for (const auto& half : box.halfAxis) {
        q += (T(2) * T(rest % (kSteps + 1)) / T(kSteps) - 1) * half;
        rest /= kSteps + 1;
      }
      nearest = std::min(nearest, length(q - p));
      farthest = std::max(farthest, length(q - p));
    }
    ASSERT_LE(distances.lower, nearest + 8 * this->kEps) << i;
    ASSERT_GE(distances.upper, farthest - 8 * this->kEps) << i;
    ASSERT_LE(distances.upper, farthest + 200 * this->kEps) << i;  // it is a corner
    ASSERT_GE(distances.lower, nearest - 2 * box.radius() / kSteps - 200 * this->kEps) << i;
  }
}

TYPED_TEST(OrientedBoxTest, ReachIsThatOfTheFarthestCornerAndSlack) {
  using T = TypeParam;
  RandomPoints<T> points(1, 5);
  for (int i = 0; i < 1000; ++i) {
    auto box = this->turned(points, i);
    box.slack = i % 2 == 0 ? T(0) : T(0.01);
    const auto p = points.next();
    T farthest = 0;
    for (int k = 0; k < 8; ++k) farthest = std::max(farthest, length(box.corner(k) - p));
    const T reach = box.distancesFrom(p).upper;
    ASSERT_GE(reach, farthest + T(0.99) * box.slack);
    ASSERT_LE(reach, farthest + T(1.8) * box.slack + 200 * this->kEps);
  }
}

TYPED_TEST(OrientedBoxTest, OfExtremeSizesHasRadii) {
  using T = TypeParam;
  const T huge = sizeof(T) == sizeof(float) ? T(1e30) : T(1e250);
  for (const T size : {huge, T(1), 1 / huge}) {
    OrientedBox<T> box;
    box.halfAxis = {Vec3<T>{size, 0, 0}, Vec3<T>{0, 2 * size, 0}, Vec3<T>{0, 0, 2 * size}};
    EXPECT_NEAR(double(box.radius() / size), 3, 1e-5);
    EXPECT_NEAR(double(box.innerRadius() / size), 1, 1e-5);
    EXPECT_LE(box.innerRadius(), size);
    EXPECT_GE(box.radius(), 3 * size);
  }
}

TYPED_TEST(OrientedBoxTest, WithinADomain) {
  using T = TypeParam;
  const auto box = OrientedBox<T>::of({{0, 0, 0}, {1, 1, 1}});
  EXPECT_TRUE(box.isWithin(Box<T>::everywhere()));
  EXPECT_TRUE(box.isWithin({{-1, -1, -1}, {2, 2, 2}}));
  EXPECT_FALSE(box.isWithin({{-1, -1, -1}, {T(0.5), 2, 2}}));
}

}  // namespace
}  // namespace cutwater::test
