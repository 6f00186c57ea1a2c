#include <Cutwater/Bvh/BvhBuilder.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>

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

}  // namespace
}  // namespace cutwater::test
