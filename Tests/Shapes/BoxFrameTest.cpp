#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/BoxFrame.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>

#include <algorithm>
#include <vector>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class BoxFrameTest : public ::testing::Test {};
TYPED_TEST_SUITE(BoxFrameTest, Precisions);

TYPED_TEST(BoxFrameTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const BoxFrame<T> frame({{-4, -4, -4}, {4, 4, 4}}, 2);
  EXPECT_EQ(frame.signedDistance({0, 3, 3}), T(-1));
  EXPECT_EQ(frame.signedDistance({0, 7, 8}), T(5));
  EXPECT_EQ(frame.signedDistance({0, 0, 3}), T(2));  // in a window
  EXPECT_NEAR(frame.signedDistance({0, 0, 0}), T(std::sqrt(T(8))), tolerance<T>(8));
  EXPECT_EQ(frame.signedDistance({2, 2, 0}), T(0));
  // In a corner the hollow's edges count, not the deepest bar.
  EXPECT_EQ(frame.signedDistance({3, 3, 3}), T(-1));
  EXPECT_NEAR(frame.signedDistance({2.5, 2.5, 2.5}), T(-std::sqrt(T(0.5))), tolerance<T>(8));
  EXPECT_EQ(frame.gradient({0, 3.5, 3}), (Vec3<T>{0, 1, 0}));
  EXPECT_EQ(frame.gradient({0, 1, -3}), (Vec3<T>{0, -1, 0}));
  EXPECT_EQ(frame.gradient({-7, 3, 8}), (Vec3<T>{T(-0.6), 0, T(0.8)}));
  EXPECT_EQ(frame.gradient({0, 0, 0}), Vec3<T>{});
  EXPECT_EQ(frame.gradient({3, 3, 3}), Vec3<T>{});
}

TYPED_TEST(BoxFrameTest, IsTheUnionOfTwelveBarsSeenFromOutside) {
  using T = TypeParam;
  const Box<T> box{{-1, -2, T(-0.5)}, {2, 1, T(0.75)}};
  const T thickness = T(0.25);
  const BoxFrame<T> frame(box, thickness);
  std::vector<Cuboid<T>> bars;
  for (int along = 0; along < 3; ++along) {
    for (int side = 0; side < 4; ++side) {
      Box<T> bar = box;
      const int i = (along + 1) % 3;
      const int j = (along + 2) % 3;
      side % 2 == 0 ? bar.upper[i] = box.lower[i] + thickness
                    : bar.lower[i] = box.upper[i] - thickness;
      side / 2 == 0 ? bar.upper[j] = box.lower[j] + thickness
                    : bar.lower[j] = box.upper[j] - thickness;
      bars.emplace_back(bar);
    }
  }
  RandomPoints<T> points(3);
  int outside = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto p = points.next();
    T least = std::numeric_limits<T>::max();
    for (const auto& bar : bars) least = std::min(least, bar.signedDistance(p));
    const T value = frame.signedDistance(p);
    EXPECT_EQ(value < 0, least < 0) << p;
    if (least < 0) {
      EXPECT_LE(value, least + tolerance<T>(3)) << p;  // deeper where bars meet
      continue;
    }
    ++outside;
    EXPECT_NEAR(value, least, tolerance<T>(6, 4)) << p;
  }
  EXPECT_GT(outside, 4000);
}

TYPED_TEST(BoxFrameTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  const Box<T> box{{-1, -1, -2}, {1, 1, 2}};
  EXPECT_THROW((BoxFrame<T>(box, 0)), Error);
  EXPECT_THROW((BoxFrame<T>(box, 1)), Error);
  EXPECT_THROW((BoxFrame<T>(box, nan)), Error);
  EXPECT_THROW((BoxFrame<T>({{0, 0, 0}, {1, 1, inf}}, T(0.1))), Error);
  EXPECT_THROW((BoxFrame<T>({{0, 0, 0}, {1, 0, 1}}, T(0.1))), Error);
}

TYPED_TEST(BoxFrameTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(BoxFrame<T>({{-1, -1, T(-0.75)}, {1, T(0.75), 1}}, T(0.25)), 2);
  expectGuarantee(BoxFrame<T>({{-1, -1, -1}, {1, 1, 1}}, T(0.875)), 2);
}

TEST(BoxFrameRounding, StaysWithinItsBound) {
  expectRounding(BoxFrame<float>({{-1, -2, -3}, {1, 2, 3}}, 0.125f),
                 BoxFrame<double>({{-1, -2, -3}, {1, 2, 3}}, 0.125), 4);
  expectRounding(BoxFrame<float>({{99, 99, 0}, {100, 100.5f, 1}}, 0.001f),
                 BoxFrame<double>({{99, 99, 0}, {100, 100.5f, 1}}, 0.001f), 4);
}

}  // namespace
}  // namespace cutwater::test
