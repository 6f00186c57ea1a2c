#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "Bvh/Triangles.hpp"

namespace cutwater::test {
namespace {

// Enough for several tasks, and for several chunks of the first splits.
constexpr std::size_t kManyBuilt = 150'000;

TEST(BvhBuilderTest, TheTreeDoesNotDependOnTheNumberOfThreads) {
  const auto all = manyTriangles(kManyBuilt);
  const auto expected = turnedTree(all, 1);
  EXPECT_GT(expected.nodes.size(), kManyBuilt / 300);
  for (const int threads : {2, 3, 8, 0}) {
    SCOPED_TRACE(threads);
    expectSame(turnedTree(all, threads), expected);
  }
  parallelFor(2, {.threads = 2}, [&](std::size_t begin, std::size_t) {
    if (begin == 0) expectSame(turnedTree(all, 8), expected);  // serial within a parallel region
  });
}

TEST(BvhBuilderTest, HoldsEveryPrimitiveOnceInLeavesThatAreFull) {
  for (const std::size_t count : {1U, 15U, 16U, 17U, 256U, 257U, 5000U, 100'000U}) {
    SCOPED_TRACE(count);
    auto slots = turnedTree(manyTriangles(count), 2).slots;
    EXPECT_LE(static_cast<double>(slots.size()), 1.35 * static_cast<double>(count) + 16);
    std::ranges::sort(slots);
    ASSERT_GE(slots.size(), count);
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(slots[i], i);
    EXPECT_TRUE(slots.size() == count || slots[count] == kNone);
  }
}

TEST(BvhBuilderTest, SeparatesACrowdFarBelowTheResolutionOfTheWhole) {
  RandomPoints<double> random(1);
  std::vector<Box<double>> boxes;
  for (int i = 0; i < 4096; ++i) boxes.push_back(Box<double>{}.extend(1e-10 * random.next()));
  boxes.push_back(Box<double>{}.extend({1, 1, 1}));
  const auto arrays = buildBvh<16, 4>(boxes);
  double sum = 0;
  for (std::size_t first = 0; first < arrays.slots.size(); first += 4) {
    Box<double> leaf;
    for (const auto id : std::span(arrays.slots).subspan(first, 4)) {
      if (id < 4096) leaf.extend(boxes[id]);
    }
    if (!leaf.empty()) sum += maxComponent(leaf.size());
  }
  // 1024 leaves would be a tenth of the crowd wide on each axis.
  EXPECT_LT(sum / (static_cast<double>(arrays.slots.size()) / 4), 0.15 * 2e-10);
}

/// Nodes on the longest path, counted from the root down.
template <int K, int W>
int depthOf(const BvhArrays<K, W>& arrays) {
  std::vector<int> levels(arrays.nodes.size(), 1);
  int deepest = arrays.nodes.empty() ? 0 : 1;
  for (std::size_t n = 0; n < arrays.nodes.size(); ++n) {
    const auto& node = arrays.nodes[n];
    for (int lane = 0; lane < K; ++lane) {
      if ((node.nodeMask >> lane & 1) == 0) continue;
      levels[node.nodeIndex(lane)] = levels[n] + 1;
      deepest = std::max(deepest, levels[n] + 1);
    }
  }
  return deepest;
}

template <int K, int W>
int expectKnownDepth(std::span<const Box<double>> boxes) {
  const auto arrays = buildBvh<K, W>(boxes, /*threads=*/1);
  const int depth = depthOf(arrays);
  EXPECT_EQ(arrays.depth, depth);
  EXPECT_EQ(arrays.tree().depth(), depth);
  EXPECT_LE(depth, (BvhTree<K, W>::kMaxDepth));
  return depth;
}

int expectKnownDepths(std::span<const Box<double>> boxes) {
  expectKnownDepth<8, 4>(boxes);
  expectKnownDepth<16, 4>(boxes);
  expectKnownDepth<16, 16>(boxes);
  return expectKnownDepth<4, 4>(boxes);
}

TEST(BvhBuilderTest, KnowsTheDepthOfWhatWouldMakeADeepTree) {
  // Each split by area peels off a few boxes; without a bound the tree would be hundreds deep.
  std::vector<Box<double>> nested;
  std::vector<Box<double>> onALine;
  std::vector<Box<double>> sparser;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1.0, -(i % 900));
    nested.push_back({{0, 0, 0}, {size, size, size}});
    onALine.push_back({{1.0 * i, 0, 0}, {1.0 * i + 0.5, 0, 0}});
    sparser.push_back(Box<double>{}.extend({size, 0, 0}));  // points that crowd towards one end
  }
  EXPECT_GE(expectKnownDepths(nested), 16);
  EXPECT_GE(expectKnownDepths(sparser), 16);
  EXPECT_LE(expectKnownDepths(onALine), 20);  // boxes without area: halves
  EXPECT_LE(expectKnownDepths(std::vector<Box<double>>(20000, Box<double>{{1, 1, 1}, {2, 2, 2}})),
            10);
  EXPECT_EQ(expectKnownDepths(std::vector<Box<double>>(1, Box<double>{{1, 1, 1}, {1, 1, 1}})), 1);
  EXPECT_EQ(expectKnownDepths({}), 0);
}

}  // namespace
}  // namespace cutwater::test
