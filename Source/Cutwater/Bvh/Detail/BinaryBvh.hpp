#pragma once

#include <Cutwater/Core/Box.hpp>

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater::detail {

/// A node of the binary tree that the builder makes first. It has two children or a range of
/// primitives.
struct BinaryNode {
  Box<double> box;
  std::uint32_t begin = 0;  ///< range in BinaryBvh::order
  std::uint32_t end = 0;
  std::uint32_t left = 0;  ///< index of a child; its sibling follows. 0 for a leaf
  [[nodiscard]] bool isLeaf() const { return left == 0; }
  [[nodiscard]] std::uint32_t count() const { return end - begin; }
};

/// Number of top levels on which nodes may be split by area, at any position.
inline constexpr int kAreaLevels = 32;
/// Ranges of at most this many full leaves on one of these levels are split by a sorted sweep, all
/// the way down.
inline constexpr int kSweepLeaves = 16;

/// Bound on the inner nodes of any path of the binary tree, for up to 2^32 primitives: one on each
/// area level, and below these either one for each time that the remaining leaves, at most 2^32 /
/// leafWidth, can be halved, or those of a sweep, which may split off one leaf at a time. Each
/// K-ary node on a path is made of inner nodes of its own, so this bounds the depth of the K-ary
/// tree as well.
[[nodiscard]] constexpr int mostLevels(unsigned leafWidth) {
  const int halvings =
      33 - static_cast<int>(std::bit_width(leafWidth));  // 32 - the integer part of its logarithm
  return kAreaLevels + (halvings > kSweepLeaves ? halvings : kSweepLeaves);
}

/// A binary tree. Children come after their parent; a path has at most mostLevels() inner nodes.
struct BinaryBvh {
  std::vector<BinaryNode> nodes;
  std::vector<std::uint32_t> order;
};

/// Splits until at most `leafWidth` primitives (at most 16) are left. Costs count leaves of that
/// width. Runs in parallel; the tree does not depend on the number of threads.
[[nodiscard]] BinaryBvh buildBinaryBvh(std::span<const Box<double>> boxes, std::uint32_t leafWidth,
                                       int threads);

/// Appends the children of a node, whose range is divided at `middle`. Returns the left one.
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
