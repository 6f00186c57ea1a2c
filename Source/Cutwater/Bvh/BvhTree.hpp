#pragma once

#include <Cutwater/Bvh/BvhSegment.hpp>
#include <Cutwater/Core/Box.hpp>
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

/// A node of a K-ary tree: the boxes of its children, component by component, and where they are.
///
/// Children that are nodes lie next to each other in the tree's array, children that are leaves in
/// theirs, so the index of a child is its base plus the number of such children in lower lanes.
template <int K>
struct alignas(64) BvhNode {
  static_assert(K >= 2 && K <= 16);
  using Lanes = std::array<float, K>;

  // In the tree's frame, rounded outward. Unused lanes hold the empty box: +-infinity.
  std::array<Lanes, 3> lower;
  std::array<Lanes, 3> upper;
  std::uint32_t firstNode = 0;
  std::uint32_t firstLeaf = 0;
  std::uint16_t nodeMask = 0;  // bit k: child k is a node
  std::uint16_t leafMask = 0;

  [[nodiscard]] bool isLeaf(int lane) const { return (leafMask >> lane & 1) != 0; }
  [[nodiscard]] std::uint32_t nodeIndex(int lane) const {
    return firstNode + below(nodeMask, lane);
  }
  [[nodiscard]] std::uint32_t leafIndex(int lane) const {
    return firstLeaf + below(leafMask, lane);
  }

 private:
  static std::uint32_t below(std::uint32_t mask, int lane) {
    return static_cast<std::uint32_t>(std::popcount(mask & ((1U << lane) - 1U)));
  }
};

/// The frame in which a tree stores its boxes in single precision: recentred, and scaled by a power
/// of two so that the longest extent is about 1.
struct BvhFrame {
  Vec3<double> center;
  double scale = 1;
};

/// A flat K-ary tree of boxes over leaves of W slots; a slot holds the id of a primitive, or kNone.
/// A view of arrays that somebody else owns: it is copied as it is, and knows no primitive.
template <int K, int W>
class BvhTree {
 public:
  static constexpr int kArity = K;
  static constexpr int kLeafWidth = W;
  /// The builder splits by area for at most 32 levels and by halves below, so that 2^32 primitives
  /// are at most 64 levels deep; collapsing two levels into one only lowers that.
  static constexpr int kMaxDepth = 64;

  /// A limit above all keys. Not infinity, which a user's -ffast-math would be free to ignore.
  static constexpr float kNoLimit = std::numeric_limits<float>::max();

  BvhTree() = default;
  BvhTree(const BvhFrame& frame, std::span<const BvhNode<K>> nodes,
          std::span<const std::uint32_t> slots)
      : frame_(frame), nodes_(nodes), slots_(slots) {}

  [[nodiscard]] std::span<const std::uint32_t> leaf(std::uint32_t index) const {
    return slots_.subspan(std::size_t{index} * W, W);
  }
  [[nodiscard]] std::span<const BvhNode<K>> nodes() const { return nodes_; }
  [[nodiscard]] std::span<const std::uint32_t> slots() const { return slots_; }
  [[nodiscard]] const BvhFrame& frame() const { return frame_; }

  /// The one traversal: visits leaves in the order of their keys, those above the limit not at all.
  ///
  /// `keys(node, out)` writes a lower bound for each lane of a node, at most kNoLimit; those of
  /// unused lanes do not matter. `leaf(slots)` handles the ids of a leaf and returns the limit from
  /// then on.
  template <typename Keys, typename Leaf>
  void traverse(Keys&& keys, Leaf&& leafVisitor, float limit) const;

  /// Visits leaves that may hold a primitive whose value at `p` is the least, nearest first.
  ///
  /// `leaf(slots)` returns the best value found so far. A value may be computed with an error of at
  /// most `error`; it is at least the distance to the primitive's box where `p` is outside of it,
  /// and may be anything inside. Every primitive whose computed value could equal or beat the best
  /// is visited. Without a limit, `best` starts at the largest double.
  template <typename Leaf>
  void nearest(const Vec3<double>& p, double best, double error, Leaf&& leafVisitor) const;

  /// Visits the leaves whose box meets `box`: leaf(slots) answers whether to go on.
  template <typename Leaf>
  void overlapping(const Box<double>& box, Leaf&& leafVisitor) const;

  /// Visits the leaves whose box the segment meets, about in the order in which it does.
  ///
  /// `leaf(slots)` returns a parameter along the segment: leaves that begin beyond it are skipped.
  template <typename Leaf>
  void along(const Segment<double>& segment, Leaf&& leafVisitor) const;

 private:
  struct Level {
    const BvhNode<K>* node;
    std::uint32_t pending;  // lanes not yet visited
    typename BvhNode<K>::Lanes keys;
  };

  /// A bit for every lane whose key is not above the limit.
  static std::uint32_t notAbove(float limit, const typename BvhNode<K>::Lanes& keys) {
    std::uint32_t lanes = 0;
    for (std::size_t k = 0; k < K; ++k) lanes |= static_cast<std::uint32_t>(keys[k] <= limit) << k;
    return lanes;
  }

  static int nearestLane(const Level& level) {
    int best = std::countr_zero(level.pending);
    for (auto rest = level.pending & (level.pending - 1); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      if (level.keys[static_cast<std::size_t>(lane)] < level.keys[static_cast<std::size_t>(best)]) {
        best = lane;
      }
    }
    return best;
  }

  /// Keys for traverse(): the squared distances from `q`, in the tree's frame, to boxes.
  struct SquaredDistances {
    Vec3<float> q;

    CUTWATER_INLINE void operator()(const BvhNode<K>& node, typename BvhNode<K>::Lanes& out) const {
      for (std::size_t k = 0; k < K; ++k) {
        float sum = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const float coordinate = axis == 0 ? q.x : axis == 1 ? q.y : q.z;
          const float under = node.lower[axis][k] - coordinate;
          const float over = coordinate - node.upper[axis][k];
          const float gap = under > over ? under : over;
          sum += gap > 0 ? gap * gap : 0;
        }
        out[k] = sum < kNoLimit ? sum : kNoLimit;
      }
    }
  };

  [[nodiscard]] CUTWATER_INLINE Vec3<double> toFrame(const Vec3<double>& p) const {
    return frame_.scale * (p - frame_.center);
  }

  BvhFrame frame_;
  std::span<const BvhNode<K>> nodes_;
  std::span<const std::uint32_t> slots_;
};

template <int K, int W>
template <typename Keys, typename Leaf>
void BvhTree<K, W>::traverse(Keys&& keys, Leaf&& leafVisitor, float limit) const {
  if (nodes_.empty()) return;
  // One entry per level of the path from the root: the siblings still to be visited.
  std::array<Level, kMaxDepth> path;
  int depth = 0;
  const auto enter = [&](const BvhNode<K>& node) {
    assert(depth < kMaxDepth);
    Level& level = path[static_cast<std::size_t>(depth++)];
    level.node = &node;
    keys(node, level.keys);
    level.pending = (std::uint32_t{node.nodeMask} | node.leafMask) & notAbove(limit, level.keys);
  };

  enter(nodes_.front());
  while (depth > 0) {
    Level& level = path[static_cast<std::size_t>(depth - 1)];
    const int lane = level.pending != 0 ? nearestLane(level) : 0;
    // Overtaken while it waited, or nothing left; ties stay.
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
  // Why no primitive is lost. All lengths in the tree's frame; u = 2^-24, the unit roundoff of
  // float. Boxes enclose exactly. The query q = float((p - c) s) is off by at most u |q| (1 +
  // tiny), so the distance from the true point to a box is at least D - 1.001 u |q|, where D is
  // that from q. The key is the computed D^2: a difference, a square and two sums, each within a
  // factor 1 +- u, so key <= D^2 (1 + u)^5 and, but for underflow (below 2^-126, added), D >=
  // sqrt(key) (1 - 3 u). A primitive that could win has D - 1.001 u |q| <= (best + error) s, hence
  // key <= ((best + error) s + 1.001 u |q|)^2 (1 + 6 u); 2^-20 leaves room for the double
  // arithmetic and the last rounding to float.
  constexpr double kUnit = 0x1p-24;
  const Vec3<double> local = toFrame(p);
  const Vec3<float> q(local);
  const double offset = 1.01 * kUnit * length(local);
  const auto limitFor = [&](double value) {
    constexpr double kFar = 1e18;  // its square is about the largest float
    if (value >= kFar / frame_.scale) return kNoLimit;
    const double reach = (value + error) * frame_.scale + offset;
    const double squared = reach > 0 ? reach * reach : 0;  // only boxes that contain q
    return reach < kFar ? static_cast<float>(squared * (1 + 0x1p-20) + 0x1p-126) : kNoLimit;
  };
  traverse(
      SquaredDistances{q},
      [&](std::span<const std::uint32_t> slots) { return limitFor(leafVisitor(slots)); },
      limitFor(best));
}

template <int K, int W>
template <typename Leaf>
void BvhTree<K, W>::overlapping(const Box<double>& box, Leaf&& leafVisitor) const {
  // In the tree's frame, rounded outward by more than the error of the conversion to float. Boxes
  // of the tree end at about 1, so far beyond it nothing needs to be told apart.
  constexpr double kFar = 1e30;
  const Vec3<double> lower = toFrame(box.lower);
  const Vec3<double> upper = toFrame(box.upper);
  Vec3<float> from;
  Vec3<float> to;
  for (int axis = 0; axis < 3; ++axis) {
    const double margin = 0x1p-23 * (std::abs(lower[axis]) + std::abs(upper[axis])) + 0x1p-126;
    from[axis] = static_cast<float>(std::clamp(lower[axis] - margin, -kFar, kFar));
    to[axis] = static_cast<float>(std::clamp(upper[axis] + margin, -kFar, kFar));
  }
  // The lane loop is innermost and writes to an array of its own: so compilers vectorise it.
  const auto keys = [from, to](const BvhNode<K>& node, typename BvhNode<K>::Lanes& out) {
    typename BvhNode<K>::Lanes gaps{};  // on the axis on which they are farthest apart
    for (int axis = 0; axis < 3; ++axis) {
      const auto& lowers = node.lower[static_cast<std::size_t>(axis)];
      const auto& uppers = node.upper[static_cast<std::size_t>(axis)];
      const float first = from[axis];
      const float last = to[axis];
      for (std::size_t k = 0; k < K; ++k) {
        const float under = lowers[k] - last;
        const float over = first - uppers[k];
        const float gap = under > over ? under : over;
        gaps[k] = gap > gaps[k] ? gap : gaps[k];
      }
    }
    out = gaps;
  };
  traverse(
      keys, [&](std::span<const std::uint32_t> slots) { return leafVisitor(slots) ? 0.0F : -1.0F; },
      0.0F);
}

template <int K, int W>
template <typename Leaf>
void BvhTree<K, W>::along(const Segment<double>& segment, Leaf&& leafVisitor) const {
  const BvhSegment local(toFrame(segment.start), toFrame(segment.end));
  const auto keys = [&](const BvhNode<K>& node, typename BvhNode<K>::Lanes& out) {
    const auto side = [](const auto& sides, std::size_t k) {
      return Vec3<double>(Vec3<float>{sides[0][k], sides[1][k], sides[2][k]});
    };
    for (std::size_t k = 0; k < K; ++k) {
      const Vec3<double> lower = side(node.lower, k);
      const Vec3<double> upper = side(node.upper, k);
      const Vec3<double> middle = 0.5 * (lower + upper);
      const Vec3<double> half = 0.5 * (upper - lower);
      out[k] = local.isApart(middle, half) ? kNoLimit : local.firstParameter(middle, half);
    }
  };
  constexpr float kBeyond = 2;  // above every parameter, below the key of what is apart
  traverse(
      keys,
      [&](std::span<const std::uint32_t> slots) {
        return std::min(static_cast<float>(leafVisitor(slots)), kBeyond);
      },
      kBeyond);
}

}  // namespace cutwater
