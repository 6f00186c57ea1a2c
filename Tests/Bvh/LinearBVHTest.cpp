#include <Cutwater/Core/Error.hpp>

#include <set>

#include "Bvh/Balls.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T, int K>
void expectSameAsTryingAll(const std::vector<Ball<T>>& balls, Vec3<T> shift = {}, T scale = 1) {
  const LinearBVH<T, Ball<T>, K> bvh(balls);
  RandomPoints<T> queries(2, /*seed=*/7);
  for (int i = 0; i < 300; ++i) {
    const Vec3<T> q = shift + scale * queries.next();
    std::uint32_t expected = 0;
    for (std::uint32_t k = 1; k < balls.size(); ++k) {
      if (balls[k].distance(q) < balls[expected].distance(q)) expected = k;
    }
    const auto hit = bvh.nearest(q);
    ASSERT_EQ(hit.primitive, expected) << "query " << q;
    ASSERT_EQ(hit.distance, balls[expected].distance(q)) << "query " << q;
  }
}

template <typename T>
class LinearBVHTest : public ::testing::Test {};
TYPED_TEST_SUITE(LinearBVHTest, Precisions);

TYPED_TEST(LinearBVHTest, FindsTheSamePrimitiveAsTryingAll) {
  using T = TypeParam;
  for (const int count : {1, 2, 4, 5, 17, 64, 65, 1000}) {
    SCOPED_TRACE(count);
    for (const T radius : {T(0.01), T(0.3)}) {  // apart; deeply overlapping: negative values
      expectSameAsTryingAll<T, 4>(cloud<T>(count, radius));
      expectSameAsTryingAll<T, 8>(cloud<T>(count, radius));
      expectSameAsTryingAll<T, 16>(cloud<T>(count, radius));
    }
  }
}

TYPED_TEST(LinearBVHTest, IsRightFarFromTheOriginAndAtExtremeSizes) {
  using T = TypeParam;
  const T far = sizeof(T) == sizeof(float) ? T(1e3) : T(1e8);
  expectSameAsTryingAll<T, 16>(cloud<T>(500, T(0.01), {far, -far, far}), {far, -far, far});
  for (const T scale : {T(1e-15), T(1e15)}) {
    expectSameAsTryingAll<T, 16>(cloud<T>(500, T(0.01), {}, scale), {}, scale);
  }
}

TYPED_TEST(LinearBVHTest, TiesGoToTheLowestIndex) {
  using T = TypeParam;
  // Points of a lattice, each many times, queried where several are equally near.
  std::vector<Ball<T>> balls;
  for (int copy = 0; copy < 40; ++copy) {
    for (int i = 0; i < 8; ++i) balls.push_back({{T(i & 1), T(i >> 1 & 1), T(i >> 2)}, T(0.1)});
  }
  const LinearBVH<T, Ball<T>> bvh(balls);
  EXPECT_EQ(bvh.nearest({T(0.5), T(0.5), T(0.5)}).primitive, 0U);
  EXPECT_EQ(bvh.nearest({1, T(0.5), T(0.5)}).primitive, 1U);
  EXPECT_EQ(bvh.nearest({1, 1, T(1.5)}).primitive, 7U);
}

TYPED_TEST(LinearBVHTest, FindsNothingBeyondTheLimitAndInNothing) {
  using T = TypeParam;
  const LinearBVH<T, Ball<T>> one({{{0, 0, 0}, 1}});
  EXPECT_EQ(one.nearest({3, 0, 0}, T(1.5)).primitive, kNone);
  EXPECT_EQ(one.nearest({3, 0, 0}, T(2)).primitive, 0U);  // not above the limit
  const LinearBVH<T, Ball<T>> none(std::vector<Ball<T>>{});
  EXPECT_EQ(none.nearest({0, 0, 0}).primitive, kNone);
}

TYPED_TEST(LinearBVHTest, OverlappingMatchesTryingAll) {
  using T = TypeParam;
  const auto balls = cloud<T>(700, T(0.1));
  const LinearBVH<T, Ball<T>> bvh(balls);
  RandomPoints<T> random(T(1.2), /*seed=*/3);
  for (int i = 0; i < 200; ++i) {
    const Box<T> box = Box<T>{}.extend(random.next()).extend(random.next());
    std::set<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < balls.size(); ++k) {
      if (balls[k].boundingBox().overlaps(box)) expected.insert(k);
    }
    std::set<std::uint32_t> found;
    bvh.overlapping(box, [&](std::uint32_t k) {
      EXPECT_TRUE(found.insert(k).second) << "told twice: " << k;
      return true;
    });
    EXPECT_EQ(found, expected);
  }
}

TYPED_TEST(LinearBVHTest, RefusesBoxesThatAreNotFinite) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  EXPECT_THROW((LinearBVH<T, Ball<T>>({{{0, 0, 0}, inf}})), Error);
}

TYPED_TEST(LinearBVHTest, LeavesAreNearlyFullAndNodesWellFilled) {
  using T = TypeParam;
  const LinearBVH<T, Ball<T>> bvh(cloud<T>(20000, T(0.001)));
  const auto tree = bvh.tree();
  EXPECT_GT(20000.0 / static_cast<double>(tree.slots().size()), 0.9);
  std::size_t children = 0;
  for (const auto& node : tree.nodes()) {
    children +=
        static_cast<std::size_t>(std::popcount(node.nodeMask) + std::popcount(node.leafMask));
  }
  EXPECT_GT(static_cast<double>(children) / static_cast<double>(tree.nodes().size()), 8.0);
}

}  // namespace
}  // namespace cutwater::test
