#include <Cutwater/Bvh/BvhBuilder.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

using Corners = std::array<Vec3<double>, 3>;
using Arrays = BvhArrays<16, 16>;

Box<double> boxOf(const Corners& corners) {
  Box<double> box;
  for (const auto& corner : corners) box.extend(corner);
  return box;
}

/// Small triangles on a sphere, some of them many times, and a crowd far below their size.
std::vector<Corners> triangles(std::size_t count) {
  RandomPoints<double> random(1);
  std::vector<Corners> result;
  while (result.size() < count) {
    const std::size_t kind = result.size() % 16;
    if (kind == 0 && !result.empty()) {
      result.push_back(result[result.size() / 2]);
      continue;
    }
    const Vec3<double> center = kind == 1 ? 1e-9 * random.next() : normalized(random.next());
    const double size = kind == 1 ? 1e-10 : 0.01;
    auto& corners = result.emplace_back();
    for (auto& corner : corners) corner = center + size * random.next();
  }
  return result;
}

Arrays turnedTree(const std::vector<Corners>& triangles, int threads) {
  std::vector<Box<double>> boxes;
  for (const auto& corners : triangles) boxes.push_back(boxOf(corners));
  const auto corners = [&](std::uint32_t id) { return triangles[id]; };
  return buildTurnedBvh<16, 16>(boxes, corners, threads);
}

void expectSame(const Arrays& one, const Arrays& other) {
  EXPECT_EQ(one.slots, other.slots);
  ASSERT_EQ(one.nodes.size(), other.nodes.size());
  const auto fields = [](const BvhNode<16>& n) {
    return std::tie(n.lower, n.upper, n.center, n.axes, n.firstNode, n.firstLeaf, n.nodeMask,
                    n.leafMask);
  };
  for (std::size_t i = 0; i < one.nodes.size(); ++i) {
    ASSERT_EQ(fields(one.nodes[i]), fields(other.nodes[i])) << "node " << i;
  }
}

// Enough for several tasks, and for several chunks of the first splits.
constexpr std::size_t kMany = 150'000;

TEST(BvhBuilderTest, TheTreeDoesNotDependOnTheNumberOfThreads) {
  const auto all = triangles(kMany);
  const auto expected = turnedTree(all, 1);
  EXPECT_GT(expected.nodes.size(), kMany / 300);
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
    auto slots = turnedTree(triangles(count), 2).slots;
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
