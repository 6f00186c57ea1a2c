#pragma once

#include <Cutwater/Bvh/Detail/TraversalKeys.hpp>
#include <Cutwater/Core/Segment.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace cutwater {

/// The value that a visitor of BvhTree::nearest() or along() returns to end the traversal.
inline constexpr double kStopTraversal = std::numeric_limits<double>::lowest();

/// A flat K-ary tree of boxes whose leaves have W slots; a slot holds the id of a primitive, or
/// kNone. A non-owning view of the arrays: copies are shallow. It does not access the primitives.
template <int K, int W>
class BvhTree {
 public:
  /// Children per node, and slots per leaf.
  static constexpr int kArity = K;
  static constexpr int kLeafWidth = W;
  /// Upper bound on the depth of any tree from the builder: see detail::mostLevels() in
  /// BinaryBvh.hpp.
  static constexpr int kMaxDepth = 65 - static_cast<int>(std::bit_width(unsigned{W}));

  BvhTree() = default;
  /// `depth` is that of the deepest node, counted from 1 at the root; at most kMaxDepth.
  BvhTree(const BvhFrame& frame, std::span<const BvhNode<K>> nodes,
          std::span<const std::uint32_t> slots, int depth)
      : frame_(frame), nodes_(nodes), slots_(slots), depth_(depth) {
    assert(0 <= depth && depth <= kMaxDepth);
  }

  /// The ids in the slots of a leaf.
  [[nodiscard]] std::span<const std::uint32_t> leaf(std::uint32_t index) const {
    return slots_.subspan(std::size_t{index} * W, W);
  }
  [[nodiscard]] std::span<const BvhNode<K>> nodes() const { return nodes_; }
  [[nodiscard]] std::span<const std::uint32_t> slots() const { return slots_; }
  [[nodiscard]] const BvhFrame& frame() const { return frame_; }
  /// Number of nodes on the longest path from the root to a leaf; 0 for an empty tree.
  [[nodiscard]] int depth() const { return depth_; }

  /// The traversal behind all queries. Visits leaves in the order of their keys and skips those
  /// whose key is above the limit.
  ///
  /// `keys(node, out)` writes a lower bound for each lane of a node, at most kMostKey; values in
  /// unused lanes are ignored. `leaf(slots)` processes the ids of a leaf and returns the new limit;
  /// one below all keys ends the traversal.
  template <typename Keys, typename Leaf>
  void traverse(Keys&& keys, Leaf&& leafVisitor, float limit) const;

  /// Visits the leaves that may hold the primitive with the least value at `p`, nearest first.
  ///
  /// `leaf(slots)` returns the best value found so far. Values may be computed with an error of up
  /// to `error`. Where `p` is outside a primitive's box, its value must be at least the distance to
  /// the box; inside, it may be anything. Every primitive whose computed value could equal or beat
  /// the best is visited. To search without a limit, start `best` at the largest double.
  template <typename Leaf>
  void nearest(const Vec3<double>& p, double best, double error, Leaf&& leafVisitor) const;

  /// Visits the leaves that may hold a primitive nearest to some point of the box, nearest first.
  /// leaf(slots) returns the least distance found so far between a primitive and the box; leaves
  /// farther away are not visited.
  template <typename Leaf>
  void nearest(const OrientedBox<double>& box, double best, Leaf&& leafVisitor) const;

  /// Visits the leaves whose box meets `box`. leaf(slots) returns whether to continue.
  template <typename Leaf>
  void overlapping(const OrientedBox<double>& box, Leaf&& leafVisitor) const;

  /// Visits the leaves whose box the segment meets, or approaches within `margin` on every axis,
  /// roughly in order along the segment.
  ///
  /// `leaf(slots)` returns a parameter along the segment: leaves that begin beyond it are skipped.
  template <typename Leaf>
  void along(const Segment<double>& segment, Leaf&& leafVisitor, double margin = 0) const;

 private:
  struct Level {
    const BvhNode<K>* node;
    std::uint32_t pending;  // lanes not yet visited
    typename BvhNode<K>::Lanes keys;
  };

  /// Bit k is set if the key of lane k is not above the limit.
  CUTWATER_INLINE static std::uint32_t notAbove(float limit,
                                                const typename BvhNode<K>::Lanes& keys) {
    std::uint32_t lanes = 0;
    for (std::size_t k = 0; k < K; ++k) lanes |= static_cast<std::uint32_t>(keys[k] <= limit) << k;
    return lanes;
  }

  CUTWATER_INLINE static int nearestLane(const Level& level) {
    int best = std::countr_zero(level.pending);
    for (auto rest = level.pending & (level.pending - 1); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      if (level.keys[static_cast<std::size_t>(lane)] < level.keys[static_cast<std::size_t>(best)]) {
        best = lane;
      }
    }
    return best;
  }

  BvhFrame frame_;
  std::span<const BvhNode<K>> nodes_;
  std::span<const std::uint32_t> slots_;
  int depth_ = 0;
};

template <int K, int W>
template <typename Keys, typename Leaf>
void BvhTree<K, W>::traverse(Keys&& keys, Leaf&& leafVisitor, float limit) const {
  if (nodes_.empty()) return;
  // One entry per level of the path from the root: the siblings still to be visited. At most depth_
  // entries are used, and no others are touched.
  std::array<Level, std::size_t{kMaxDepth}> path;
  int depth = 0;
  const auto enter = [&](const BvhNode<K>& node) {
    assert(depth < depth_);
    Level& level = path[static_cast<std::size_t>(depth++)];
    level.node = &node;
    keys(node, level.keys);
    level.pending = node.childMask() & notAbove(limit, level.keys);
  };

  enter(nodes_.front());
  while (depth > 0) {
    Level& level = path[static_cast<std::size_t>(depth - 1)];
    const int lane = level.pending != 0 ? nearestLane(level) : 0;
    // Nothing left, or the limit has dropped below the key meanwhile. Ties are still visited.
    if (level.pending == 0 || !(level.keys[static_cast<std::size_t>(lane)] <= limit)) {
      --depth;
      continue;
    }
    level.pending &= ~(1U << lane);
    if (level.node->isLeaf(lane)) {
      limit = leafVisitor(leaf(level.node->leafIndex(lane)));
    } else {
      enter(nodes_[level.node->nodeIndex(lane)]);
    }
  }
}

template <int K, int W>
template <typename Leaf>
void BvhTree<K, W>::nearest(const Vec3<double>& p, double best, double error,
                            Leaf&& leafVisitor) const {
  // Why no primitive is lost. All lengths are in the tree's frame; u = 2^-24 is the unit roundoff
  // of float. Boxes enclose exactly, and the point in the node's frame lies within its error. So a
  // gap on an axis is at most the true one times 1 + u. A key (three squares and two sums) is at
  // most D^2 (1 + u)^5, where D is the distance in the node's frame, which is at most 1 + 2 u times
  // the true one. A primitive that could win has a true distance of at most best + error, hence a
  // key of at most its square times 1 + 10 u; 2^-20 = 16 u leaves room for the last rounding to
  // float. Positions in the frames are off by a few 2^-53 of their magnitudes.
  const Vec3<double> local = frame_.toFrame(p);
  const double slack = error * frame_.scale + 0x1p-50 * (1 + length(local));
  const auto limitFor = [&](double value) {
    constexpr double kFar = 1e18;  // its square is about the largest float
    if (value == kStopTraversal) return -1.0F;
    if (value >= kFar / frame_.scale) return kMostKey;
    const double reach = value * frame_.scale + slack;
    const double squared = reach > 0 ? reach * reach : 0;  // only boxes that contain q
    return reach < kFar ? static_cast<float>(squared * (1 + 0x1p-20) + 0x1p-126) : kMostKey;
  };
  traverse(
      PointDistances<K>{local},
      [&](std::span<const std::uint32_t> slots) { return limitFor(leafVisitor(slots)); },
      limitFor(best));
}

template <int K, int W>
template <typename Leaf>
void BvhTree<K, W>::nearest(const OrientedBox<double>& box, double best, Leaf&& leafVisitor) const {
  const auto limitFor = [&](double distance) {
    if (distance <= 0) return -1.0F;  // nothing can be nearer
    const double reach = distance * frame_.scale;
    return reach < 1e18 ? static_cast<float>(reach * reach * (1 + 0x1p-20) + 0x1p-126) : kMostKey;
  };
  traverse(
      BoxDistances<K>(frame_, box),
      [&](std::span<const std::uint32_t> slots) { return limitFor(leafVisitor(slots)); },
      limitFor(best));
}

template <int K, int W>
template <typename Leaf>
void BvhTree<K, W>::overlapping(const OrientedBox<double>& box, Leaf&& leafVisitor) const {
  traverse(
      BoxDistances<K>(frame_, box),
      [&](std::span<const std::uint32_t> slots) { return leafVisitor(slots) ? 0.0F : -1.0F; },
      0.0F);
}

template <int K, int W>
template <typename Leaf>
void BvhTree<K, W>::along(const Segment<double>& segment, Leaf&& leafVisitor, double margin) const {
  constexpr double kBeyond = 2;  // above every parameter, below the key of separated boxes
  traverse(
      FirstParameters<K>(frame_, segment, margin),
      [&](std::span<const std::uint32_t> slots) {
        return static_cast<float>(std::clamp<double>(leafVisitor(slots), -kBeyond, kBeyond));
      },
      float{kBeyond});
}

}  // namespace cutwater
