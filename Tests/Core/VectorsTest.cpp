#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Eigen.hpp>
#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Core/Segment.hpp>

#include <array>
#include <cstddef>
#include <vector>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

static_assert(sizeof(Vec3<float>) == 3 * sizeof(float) &&
              sizeof(Vec3<double>) == 3 * sizeof(double));
static_assert(offsetof(Vec3<double>, z) == 2 * sizeof(double));
static_assert(std::is_trivially_copyable_v<Vec3<double>>);
// Widening is implicit, losing digits is not, and pointers and vectors of integers are no points.
static_assert(std::is_convertible_v<Vec3<float>, Vec3<double>>);
static_assert(!std::is_convertible_v<Vec3<double>, Vec3<float>>);
static_assert(std::is_constructible_v<Vec3<float>, Vec3<double>>);
static_assert(std::is_convertible_v<std::array<double, 3>, Vec3<double>>);
static_assert(std::is_convertible_v<Eigen::Vector3d, Vec3<double>>);
static_assert(!std::is_constructible_v<Vec3<double>, const double*>);
static_assert(!std::is_constructible_v<Vec3<double>, std::array<int, 3>>);

template <typename T>
class VectorsTest : public ::testing::Test {};
TYPED_TEST_SUITE(VectorsTest, Precisions);

TYPED_TEST(VectorsTest, ConvertsFromWhateverIsIndexable) {
  using T = TypeParam;
  const Vec3<T> expected{1, 2, 3};
  EXPECT_EQ(Vec3<T>(std::array<T, 3>{1, 2, 3}), expected);
  EXPECT_EQ(Vec3<T>(std::vector<T>{1, 2, 3}), expected);
  const T raw[3] = {1, 2, 3};
  EXPECT_EQ((Vec3<T>{raw[0], raw[1], raw[2]}), expected);
  const Eigen::Matrix<T, 3, 1> eigen(1, 2, 3);
  EXPECT_EQ(Vec3<T>(eigen), expected);
  EXPECT_EQ(toEigen(expected), eigen);
  RigidTransform<T> motion;
  motion.rotate(90, 2);
  motion.translate({5, 0, 0});
  EXPECT_EQ(Vec3<T>(Eigen::Matrix<T, 3, 1>(toEigen(motion) * eigen)), motion.toWorld(expected));
}

TYPED_TEST(VectorsTest, ComputesByHand) {
  using T = TypeParam;
  const Vec3<T> a{1, -2, 3};
  const Vec3<T> b{4, 5, -6};
  EXPECT_EQ(a + b, (Vec3<T>{5, 3, -3}));
  EXPECT_EQ(a - b, (Vec3<T>{-3, -7, 9}));
  EXPECT_EQ(T(2) * a / T(2), a);
  EXPECT_EQ(dot(a, b), T(-24));
  EXPECT_EQ(cross(a, b), (Vec3<T>{-3, 18, 13}));
  EXPECT_EQ(min(a, b), (Vec3<T>{1, -2, -6}));
  EXPECT_EQ(max(a, b), (Vec3<T>{4, 5, 3}));
  EXPECT_EQ(maxComponent(abs(b)), T(6));
  EXPECT_EQ(nearestAxis(a), 2);
  EXPECT_EQ(nearestAxis(Vec3<T>{-5, 4, 5}), 0);
  EXPECT_EQ(nearestAxis(Vec3<T>{0, -3, 3}), 1);
  EXPECT_EQ(length(Vec3<T>{2, 3, 6}), T(7));
  EXPECT_EQ(normalized(Vec3<T>{0, -4, 0}), (Vec3<T>{0, -1, 0}));
  EXPECT_EQ(normalized(Vec3<T>{}), Vec3<T>{});
  EXPECT_FALSE(isFinite(Vec3<T>{0, std::numeric_limits<T>::infinity(), 0}));
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(a[axis], (std::array<T, 3>{1, -2, 3})[static_cast<std::size_t>(axis)]);
}

TYPED_TEST(VectorsTest, BoxesAreClosed) {
  using T = TypeParam;
  Box<T> box;
  EXPECT_TRUE(box.empty());
  box.extend({1, 2, 3});
  EXPECT_FALSE(box.empty());  // a point
  box.extend(Box<T>{{-1, 0, 3}, {0, 0, 4}});
  EXPECT_EQ(box, (Box<T>{{-1, 0, 3}, {1, 2, 4}}));
  EXPECT_EQ(box.center(), (Vec3<T>{0, 1, T(3.5)}));
  EXPECT_EQ(box.diagonal(), T(3));
  EXPECT_TRUE(box.contains({1, 2, 4}));
  EXPECT_FALSE(box.contains({1, 2, T(4.5)}));
  EXPECT_FALSE(box.contains({1, std::numeric_limits<T>::quiet_NaN(), 4}));
  EXPECT_EQ(box.corner(5), (Vec3<T>{1, 0, 4}));
  EXPECT_EQ(box.grown(1).lower, (Vec3<T>{-2, -1, 2}));
  EXPECT_TRUE(box.intersection({{5, 5, 5}, {6, 6, 6}}).empty());
  EXPECT_FALSE(isFinite(Box<T>::everywhere()));
  const T huge = std::numeric_limits<T>::max();
  EXPECT_EQ((Box<T>{{huge, 0, 0}, {huge, 0, 0}}).center().x, huge);
}

TYPED_TEST(VectorsTest, BoxesCoverThoseOfWhichTheyHaveBothEnds) {
  using T = TypeParam;
  const Box<T> box{{0, 0, 0}, {1, 2, 3}};
  EXPECT_TRUE(box.covers(box));
  EXPECT_TRUE(Box<T>::everywhere().covers(box));
  EXPECT_TRUE(box.covers(Box<T>{{T(0.5), 0, 1}, {1, 1, 2}}));
  for (int axis = 0; axis < 3; ++axis) {
    auto larger = box;
    larger.lower[axis] -= 1;
    EXPECT_FALSE(box.covers(larger));
    EXPECT_TRUE(larger.covers(box));
    larger = box;
    larger.upper[axis] += 1;
    EXPECT_FALSE(box.covers(larger));
  }
}

TYPED_TEST(VectorsTest, BoxesOverlapWhereTheyShareAPoint) {
  using T = TypeParam;
  const auto overlap = [](const Box<T>& a, const Box<T>& b) {
    EXPECT_EQ(a.overlaps(b), b.overlaps(a));
    return a.overlaps(b);
  };
  const Box<T> box{{0, 0, 0}, {1, 2, 3}};
  EXPECT_TRUE(overlap(box, box));
  EXPECT_TRUE(overlap(box, {{-1, -1, -1}, {4, 4, 4}}));
  EXPECT_TRUE(overlap(box, {{1, 2, 3}, {4, 4, 4}}));  // a corner
  EXPECT_TRUE(overlap(box, {{T(0.5), 1, 0}, {T(0.5), 1, 0}}));
  EXPECT_TRUE(overlap(box, Box<T>::everywhere()));
  for (int axis = 0; axis < 3; ++axis) {
    for (const T offset : {T(-3.5), T(3.5)}) {
      Box<T> other = box;
      other.lower[axis] += offset;
      other.upper[axis] += offset;
      EXPECT_FALSE(overlap(box, other)) << axis << ' ' << offset;
    }
  }
  EXPECT_FALSE(overlap(box, {}));
  EXPECT_FALSE(overlap(Box<T>::everywhere(), {}));
  EXPECT_FALSE(overlap(box, {{T(0.5), T(0.5), 2}, {T(0.5), T(0.5), 1}}));
}

TYPED_TEST(VectorsTest, IntervalsAndSegments) {
  using T = TypeParam;
  const Interval<T> i{-1, 2};
  EXPECT_TRUE(i.contains(2));
  EXPECT_FALSE(i.contains(3));
  EXPECT_EQ(-i, (Interval<T>{-2, 1}));
  EXPECT_EQ(i.grown(1), (Interval<T>{-2, 3}));
  const Segment<T> s{{T(0.1), T(0.2), T(0.3)}, {7, T(1e7), T(-0.7)}};
  EXPECT_EQ(s.at(0), s.start);
  EXPECT_EQ(s.at(1), s.end);
  EXPECT_EQ((Segment<T>{{0, 0, 0}, {2, 4, 8}}.at(T(0.25))), (Vec3<T>{T(0.5), 1, 2}));
}

}  // namespace
}  // namespace cutwater::test
