#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>

#include <array>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "Support/Random.hpp"

namespace cutwater::test {

using Corners = std::array<Vec3<double>, 3>;
inline Box<double> boxOf(const Corners& corners) {
  Box<double> box;
  for (const auto& corner : corners) box.extend(corner);
  return box;
}

/// Small triangles on a sphere, some of them many times, and a crowd far below their size.
inline std::vector<Corners> manyTriangles(std::size_t count) {
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

inline std::vector<Box<double>> boxesOf(const std::vector<Corners>& triangles) {
  std::vector<Box<double>> boxes;
  for (const auto& corners : triangles) boxes.push_back(boxOf(corners));
  return boxes;
}

inline BvhArrays<16, 16> turnedTree(const std::vector<Corners>& triangles, int threads) {
  const auto corners = [&](std::uint32_t id) { return triangles[id]; };
  return buildTurnedBvh<16, 16>(boxesOf(triangles), corners, threads);
}

template <int K, int W>
void expectSame(const BvhArrays<K, W>& one, const BvhArrays<K, W>& other) {
  EXPECT_EQ(one.slots, other.slots);
  EXPECT_EQ(one.depth, other.depth);
  EXPECT_EQ(one.frame.center, other.frame.center);
  EXPECT_EQ(one.frame.scale, other.frame.scale);
  ASSERT_EQ(one.nodes.size(), other.nodes.size());
  const auto fields = [](const BvhNode<K>& n) {
    return std::tie(n.lower, n.upper, n.center, n.axes, n.firstNode, n.firstLeaf, n.nodeMask,
                    n.leafMask);
  };
  for (std::size_t i = 0; i < one.nodes.size(); ++i) {
    ASSERT_EQ(fields(one.nodes[i]), fields(other.nodes[i])) << "node " << i;
  }
}

}  // namespace cutwater::test
