#pragma once

#include <Cutwater/Core/Box.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater::detail {

/// A node of the binary tree that the builder makes first: two children, or a range of primitives.
struct BinaryNode {
  Box<double> box;
  std::uint32_t begin = 0;  ///< range in BinaryBvh::order
  std::uint32_t end = 0;
  std::uint32_t left = 0;  ///< index of a child; its sibling follows. 0: a leaf
  [[nodiscard]] bool isLeaf() const { return left == 0; }
  [[nodiscard]] std::uint32_t count() const { return end - begin; }
};

/// Children come after their parent. At most BvhTree::kMaxDepth levels.
struct BinaryBvh {
  std::vector<BinaryNode> nodes;
  std::vector<std::uint32_t> order;
};

/// Splits until at most `leafWidth` primitives are left; that is at most 16. Costs count leaves of
/// that width. In parallel; the same tree whatever the number of threads.
[[nodiscard]] BinaryBvh buildBinaryBvh(std::span<const Box<double>> boxes, std::uint32_t leafWidth,
                                       int threads);

/// Appends the children of a node, which part its range at `middle`. Returns the left one.
inline std::uint32_t splitNode(std::vector<BinaryNode>& nodes, std::size_t parent,
                               std::uint32_t middle) {
  const auto left = static_cast<std::uint32_t>(nodes.size());
  const BinaryNode whole = nodes[parent];
  nodes[parent].left = left;
  nodes.push_back({.box = {}, .begin = whole.begin, .end = middle});
  nodes.push_back({.box = {}, .begin = middle, .end = whole.end});
  return left;
}

/// Half the surface area of a box; 0 if it is empty.
[[nodiscard]] inline double halfArea(const Box<double>& box) {
  if (box.empty()) return 0;
  const auto s = box.size();
  return s.x * s.y + s.y * s.z + s.z * s.x;
}

}  // namespace cutwater::detail
