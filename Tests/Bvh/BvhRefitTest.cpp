#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Core/Error.hpp>

#include "Bvh/Comparison.hpp"
#include "Bvh/Triangles.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// Every node's boxes enclose what is below them; returns their summed half areas.
template <int K, int W>
double expectEnclosing(const BvhArrays<K, W>& arrays, const std::vector<Corners>& triangles) {
  std::vector<std::vector<std::uint32_t>> below(arrays.nodes.size());
  double area = 0;
  for (auto n = arrays.nodes.size(); n-- > 0;) {  // children come after their parents
    const auto& node = arrays.nodes[n];
    for (int lane = 0; lane < std::popcount(node.childMask()); ++lane) {
      std::vector<std::uint32_t> ids;
      if (node.isLeaf(lane)) {
        for (const auto id : arrays.tree().leaf(node.leafIndex(lane))) {
          if (id != kNone) ids.push_back(id);
        }
      } else {
        ids = below[node.nodeIndex(lane)];
      }
      const auto box = node.localBox(lane);
      for (const auto id : ids) {
        for (const auto& corner : triangles[id]) {
          EXPECT_TRUE(box.contains(node.toLocal(arrays.frame.toFrame(corner))))
              << "node " << n << ", lane " << lane << ", triangle " << id;
        }
      }
      const auto size = box.size() / arrays.frame.scale;
      area += size.x * size.y + size.y * size.z + size.z * size.x;
      below[n].insert(below[n].end(), ids.begin(), ids.end());
    }
  }
  EXPECT_EQ(below.empty() ? 0 : below.front().size(), triangles.size());
  return area;
}

auto cornersOf(const std::vector<Corners>& triangles) {
  return [&triangles](std::uint32_t id) { return triangles[id]; };
}

constexpr std::size_t kManyRefitted = 20'000;

TEST(BvhRefitTest, WithoutMotionNothingChanges) {
  for (const std::size_t count : {0U, 1U, 16U, 17U, 300U, 20'000U}) {
    SCOPED_TRACE(count);
    const auto all = manyTriangles(count);
    const auto boxes = boxesOf(all);
    const auto turned = turnedTree(all, 2);
    auto again = turned;
    refitTurnedBvh<16, 16>(again, boxes, cornersOf(all));
    expectSame(again, turned);
    const auto aligned = buildBvh<8, 4>(boxes);
    auto alignedAgain = aligned;
    refitBvh(alignedAgain, boxes);
    expectSame(alignedAgain, aligned);
  }
}

TEST(BvhRefitTest, BoxesEncloseWhatHasMoved) {
  const auto all = manyTriangles(kManyRefitted);
  const auto start = turnedTree(all, 2);
  const auto areaBefore = expectEnclosing(start, all);
  RandomPoints<double> random(1, /*seed=*/5);
  const Vec3<double> far{1e6, -3e7, 5e3};
  const auto moved = [&](auto motion) {
    auto result = all;
    for (auto& corners : result) {
      for (auto& corner : corners) corner = motion(corner);
    }
    return result;
  };
  const auto expectRight = [&](const std::vector<Corners>& triangles, double growth) {
    const auto boxes = boxesOf(triangles);
    auto byCorners = start;
    refitTurnedBvh<16, 16>(byCorners, boxes, cornersOf(triangles));
    const double area = expectEnclosing(byCorners, triangles);
    EXPECT_LE(area, growth * areaBefore);
    auto byBoxes = start;
    refitBvh(byBoxes, boxes);
    EXPECT_GE(expectEnclosing(byBoxes, triangles), area);
    auto alone = start;
    refitTurnedBvh<16, 16>(alone, boxes, cornersOf(triangles), /*threads=*/1);
    expectSame(alone, byCorners);
    expectSame(start, turnedTree(all, 2));
  };
  expectRight(moved([&](const auto& p) { return p + 0.01 * random.next(); }), 3);
  expectRight(moved([&](const auto& p) { return p + far; }), 1.001);
  expectRight(moved([&](const auto& p) { return Vec3<double>{p.y, -p.x, p.z}; }), 10);
  expectRight(moved([&](const auto& p) { return 1e-200 * p; }), 1e-30);
  expectRight(moved([&](const auto& p) { return 1e100 * p; }), 1.001e200);
  expectRight(moved([&](const auto&) { return random.next(); }), 1e9);
  expectRight(moved([&](const auto&) { return far; }), 1e-9);
}

TEST(BvhRefitTest, RefusesTooFewBoxesAndTooMany) {
  const auto boxes = boxesOf(manyTriangles(100));
  auto arrays = buildBvh<16, 4>(boxes);
  const auto before = arrays;
  EXPECT_THROW(refitBvh(arrays, std::span(boxes).first(99)), Error);
  EXPECT_THROW(refitBvh(arrays, {}), Error);
  EXPECT_THROW(refitBvh(arrays, boxesOf(manyTriangles(101))), Error);
  expectSame(arrays, before);
  BvhArrays<16, 4> none;
  EXPECT_THROW(refitBvh(none, boxes), Error);
}

template <typename T>
class LinearBVHRefitTest : public ::testing::Test {};
TYPED_TEST_SUITE(LinearBVHRefitTest, Precisions);

TYPED_TEST(LinearBVHRefitTest, AnswersAreThoseOfTryingAll) {
  using T = TypeParam;
  const T far = sizeof(T) == sizeof(float) ? T(1e3) : T(1e8);
  for (const int count : {1, 5, 700}) {
    SCOPED_TRACE(count);
    Comparison<T, 16> comparison(cloud<T>(count, T(0.1)));
    RandomPoints<T> random(1, /*seed=*/9);
    auto balls = cloud<T>(count, T(0.1));
    for (int step = 0; step < 3; ++step) {
      for (auto& ball : balls) ball.center += T(0.2) * random.next();
      comparison.move(balls);
      comparison.expectSame(count == 700 ? 30 : 300);
    }
    for (auto& ball : balls) ball = {random.next(), ball.radius * T(0.01)};
    comparison.move(balls);
    comparison.expectSame(100);
    comparison.move(cloud<T>(count, T(0.1), {far, far, far}), {far, far, far});
    comparison.expectSame(300);
    comparison.move(cloud<T>(count, T(0.1), {}, T(1e-15)), {}, T(1e-15));
    comparison.expectSame(300);
    comparison.move(cloud<T>(count, T(0.1), {}, T(1e15)), {}, T(1e15));
    comparison.expectSame(300);
  }
}

TYPED_TEST(LinearBVHRefitTest, RefusesWhatWouldNotFitAndStaysAsItWas) {
  using T = TypeParam;
  const auto balls = cloud<T>(100, T(0.1));
  LinearBVH<T, Ball<T>> bvh(balls);
  auto wrong = cloud<T>(100, T(0.1), {5, 5, 5});
  wrong[70].radius = std::numeric_limits<T>::infinity();
  EXPECT_THROW(bvh.refit(wrong), Error);
  EXPECT_THROW(bvh.refit(cloud<T>(99, T(0.1))), Error);
  EXPECT_THROW(bvh.refit({}), Error);
  EXPECT_EQ(bvh.nearest(balls[42].center, T(0)).distance, bvh.nearest(balls[42].center).distance);
  EXPECT_LE(bvh.nearest(balls[42].center).distance, balls[42].distance(balls[42].center));
}

TYPED_TEST(LinearBVHRefitTest, ReturnsThePrimitivesBefore) {
  using T = TypeParam;
  const auto before = cloud<T>(100, T(0.1));
  auto after = cloud<T>(100, T(0.1), {5, 5, 5});
  const auto* const memory = after.data();
  LinearBVH<T, Ball<T>> bvh(before);
  const auto spare = bvh.refit(std::move(after));
  EXPECT_EQ(bvh.primitives().data(), memory);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(spare[i].center, before[i].center);
}

}  // namespace
}  // namespace cutwater::test
