#pragma once

#include <Cutwater/Core/Box.hpp>

#include <array>
#include <cmath>
#include <cstdint>

namespace cutwater {

/// A point in the frame of a node, and a bound on its rounding error there.
struct BvhLocalPoint {
  Vec3<float> position;
  float error;  ///< on each axis
};

/// A node of a K-ary tree. Stores the boxes of its children component by component, in a frame that
/// they share, and the location of the children.
///
/// Child nodes are contiguous in the tree's node array, child leaves in its leaf array, so the
/// index of a child is the base plus the number of children of its kind in lower lanes.
template <int K>
struct alignas(64) BvhNode {
  static_assert(K >= 2 && K <= 16);
  using Lanes = std::array<float, std::size_t{K}>;  ///< one number per child

  /// In the node's frame, rounded outward. Unused lanes hold the empty box: +-infinity.
  std::array<Lanes, 3> lower;
  std::array<Lanes, 3> upper;
  /// Maps a point p of the tree's frame to axes (p - center). The rows are orthonormal up to
  /// rounding to float: a length in the node's frame is at most 1 + 2^-22 times the true one.
  Vec3<float> center;
  std::array<Vec3<float>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::uint32_t firstNode = 0;  ///< index of the first child that is a node
  std::uint32_t firstLeaf = 0;  ///< index of the first child that is a leaf
  std::uint16_t nodeMask = 0;   ///< bit k: child k is a node
  std::uint16_t leafMask = 0;   ///< bit k: child k is a leaf
  std::uint32_t unused = 0;     ///< pads the cache line for K = 16: equal nodes have equal bytes

  /// Whether the child in a lane is a leaf, and its index among the nodes or leaves.
  [[nodiscard]] CUTWATER_INLINE bool isLeaf(int lane) const { return (leafMask >> lane & 1) != 0; }
  [[nodiscard]] CUTWATER_INLINE std::uint32_t nodeIndex(int lane) const {
    return firstNode + below(nodeMask, lane);
  }
  [[nodiscard]] CUTWATER_INLINE std::uint32_t leafIndex(int lane) const {
    return firstLeaf + below(leafMask, lane);
  }
  /// Bit k: lane k is in use.
  [[nodiscard]] CUTWATER_INLINE std::uint32_t childMask() const {
    return std::uint32_t{nodeMask} | leafMask;
  }

  /// The child's box in the node's frame.
  [[nodiscard]] CUTWATER_INLINE Box<double> localBox(int lane) const {
    const auto k = static_cast<std::size_t>(lane);
    return {{lower[0][k], lower[1][k], lower[2][k]}, {upper[0][k], upper[1][k], upper[2][k]}};
  }
  /// The child's box in the tree's frame; only for trees built without turned frames.
  [[nodiscard]] CUTWATER_INLINE Box<double> alignedBox(int lane) const {
    const Box<double> local = localBox(lane);
    return {Vec3<double>(center) + local.lower, Vec3<double>(center) + local.upper};
  }
  [[nodiscard]] CUTWATER_INLINE Vec3<double> toLocal(const Vec3<double>& p) const {
    const Vec3<double> d = p - Vec3<double>(center);
    return {dot(Vec3<double>(axes[0]), d), dot(Vec3<double>(axes[1]), d),
            dot(Vec3<double>(axes[2]), d)};
  }
  /// The same in single precision. With u = 2^-24 and |d|_1 the sum of the absolute components, the
  /// conversion moves a coordinate by u |d|_1, and three products and two sums by 3 u |d|_1, with
  /// or without fused operations. The rest of 6 u covers the rounding of this bound itself and of
  /// the sum of a coordinate and its error.
  [[nodiscard]] CUTWATER_INLINE BvhLocalPoint toLocalFloat(const Vec3<double>& p) const {
    const Vec3<float> d(p - Vec3<double>(center));
    const Vec3<float> size = abs(d);
    return {.position = {dot(axes[0], d), dot(axes[1], d), dot(axes[2], d)},
            .error = 6 * 0x1p-24F * (size.x + size.y + size.z)};
  }

 private:
  CUTWATER_INLINE static std::uint32_t below(std::uint32_t mask, int lane) {
    return static_cast<std::uint32_t>(__builtin_popcount(mask & ((1U << lane) - 1U)));
  }
};

/// The frame in which a tree stores its boxes in single precision: recentred, and scaled by a power
/// of two so that the longest extent is about 1.
struct BvhFrame {
  Vec3<double> center;
  double scale = 1;

  /// Converts from the coordinates of the primitives to those of the tree, and back.
  [[nodiscard]] CUTWATER_INLINE Vec3<double> toFrame(const Vec3<double>& p) const {
    return scale * (p - center);
  }
  [[nodiscard]] CUTWATER_INLINE Vec3<double> fromFrame(const Vec3<double>& p) const {
    return center + (1 / scale) * p;
  }
};

}  // namespace cutwater
