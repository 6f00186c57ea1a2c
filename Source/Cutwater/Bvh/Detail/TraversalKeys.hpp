#pragma once

#include <Cutwater/Bvh/Detail/BvhNode.hpp>
#include <Cutwater/Core/OrientedBox.hpp>
#include <Cutwater/Core/Segment.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// Keys for BvhTree::traverse(): lower bounds for each child of a node.

namespace cutwater {

/// A segment for separating-axis tests against boxes. All coordinates are in the frame of a node,
/// where boxes are at most about 2 wide and at most about 2 from the origin.
class BvhSegment {
 public:
  CUTWATER_INLINE BvhSegment(const Vec3<double>& start, const Vec3<double>& end)
      : start_(start), half_(0.5 * (end - start)), middle_(start + half_) {
    // Positions are off by a few 2^-53 of their magnitude in the tree's frame, which is at most 1
    // larger.
    const double size = 1 + maxComponent(abs(start)) + maxComponent(abs(end));
    slack_ = 0x1p-48 * size;
    crossSlack_ = 0x1p-46 * size * size;
    const double lengthSquared = 4 * dot(half_, half_);
    direction_ = lengthSquared > 0 ? (2 / lengthSquared) * half_ : Vec3<double>{};
    directionLength_ = length(direction_);
    parameterSlack_ = 0x1p-20 + 0x1p-48 * size * directionLength_;
  }

  /// Whether an axis of the box, or a cross product of one with the segment, separates the two.
  [[nodiscard]] CUTWATER_INLINE bool isApart(const Vec3<double>& boxMiddle,
                                             const Vec3<double>& boxHalf) const {
    const Vec3<double> m = boxMiddle - middle_;
    for (int i = 0; i < 3; ++i) {
      if (std::abs(m[i]) > boxHalf[i] + std::abs(half_[i]) + slack_) return true;
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const double reach = boxHalf[j] * std::abs(half_[k]) + boxHalf[k] * std::abs(half_[j]);
      if (std::abs(m[j] * half_[k] - m[k] * half_[j]) > reach + crossSlack_) return true;
    }
    return false;
  }
  /// Lower bound on the parameters at which points of the box project onto the segment; at least
  /// -1, which is before its start.
  [[nodiscard]] CUTWATER_INLINE float firstParameter(const Vec3<double>& boxMiddle,
                                                     const Vec3<double>& boxHalf) const {
    const Vec3<double> m = boxMiddle - start_;
    const double first = dot(m, direction_) - dot(boxHalf, abs(direction_));
    // The frame's axes are off by 2^-24, so products in it are off by less than 2^-20 of the
    // lengths.
    const Vec3<double> far = abs(m) + boxHalf;
    const double skew = 0x1p-20 * directionLength_ * (far.x + far.y + far.z);
    const double parameter = first - skew - parameterSlack_;
    return parameter > -1 ? static_cast<float>(parameter) : -1.0F;
  }

 private:
  Vec3<double> start_;
  Vec3<double> half_;
  Vec3<double> middle_;
  Vec3<double> direction_;  // dot product with it: parameter along the segment
  double slack_ = 0;
  double crossSlack_ = 0;
  double directionLength_ = 0;
  double parameterSlack_ = 0;
};

/// Upper bound of all keys. Not infinity, which -ffast-math in the user's code could ignore.
inline constexpr float kMostKey = std::numeric_limits<float>::max();

/// Sums, over the axes, the squared gaps between [first, last] and the extents of a node's
/// children.
template <int K>
class SquaredGaps {
 public:
  // The lane loop is innermost and writes to an array of its own, so that compilers vectorise it.
  /// Adds the gaps along one axis.
  CUTWATER_INLINE void add(const BvhNode<K>& node, int axis, float first, float last) {
    const auto& lowers = node.lower[static_cast<std::size_t>(axis)];
    const auto& uppers = node.upper[static_cast<std::size_t>(axis)];
    for (std::size_t k = 0; k < K; ++k) {
      const float under = lowers[k] - last;
      const float over = first - uppers[k];
      const float gap = under > over ? under : over;
      sums_[k] += gap > 0 ? gap * gap : 0;
    }
  }
  /// Writes the sums, clamped to kMostKey.
  CUTWATER_INLINE void writeTo(typename BvhNode<K>::Lanes& out) const {
    for (std::size_t k = 0; k < K; ++k) out[k] = sums_[k] < kMostKey ? sums_[k] : kMostKey;
  }

 private:
  typename BvhNode<K>::Lanes sums_{};
};

/// Squared distances from `p`, in the tree's frame, to boxes; never more than the true ones except
/// for the rounding of the squares.
template <int K>
struct PointDistances {
  Vec3<double> p;

  /// A key for each lane: see BvhTree::traverse().
  CUTWATER_INLINE void operator()(const BvhNode<K>& node, typename BvhNode<K>::Lanes& out) const {
    const BvhLocalPoint local = node.toLocalFloat(p);
    SquaredGaps<K> gaps;
    for (int axis = 0; axis < 3; ++axis) {
      const float x = local.position[axis];
      gaps.add(node, axis, x - local.error, x + local.error);
    }
    gaps.writeTo(out);
  }
};

/// Squared distances, in the tree's frame, from a box to the boxes of a node's children; strictly,
/// from its bounding box in the node's frame. Never more than the true ones except for the rounding
/// of the squares, and 0 where the boxes meet, or might meet within rounding.
template <int K>
class BoxDistances {
 public:
  CUTWATER_INLINE BoxDistances(const BvhFrame& frame, const OrientedBox<double>& box)
      : middle_(frame.toFrame(box.center)),
        half_{frame.scale * box.halfAxis[0], frame.scale * box.halfAxis[1],
              frame.scale * box.halfAxis[2]},
        slack_(1.5 * frame.scale * box.slack + 0x1p-48 * (1 + oneNorm(middle_) + oneNorm(half_[0]) +
                                                          oneNorm(half_[1]) + oneNorm(half_[2]))) {}

  /// A key for each lane: see BvhTree::traverse().
  CUTWATER_INLINE void operator()(const BvhNode<K>& node, typename BvhNode<K>::Lanes& out) const {
    const Vec3<double> center = node.toLocal(middle_);
    SquaredGaps<K> gaps;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3<double> row(node.axes[static_cast<std::size_t>(axis)]);
      // Half the extent of the box, plus more than all rounding errors.
      const double reach =
          size(dot(row, half_[0])) + size(dot(row, half_[1])) + size(dot(row, half_[2])) + slack_;
      gaps.add(node, axis, outward(center[axis] - reach, -1), outward(center[axis] + reach, 1));
    }
    gaps.writeTo(out);
  }

 private:
  CUTWATER_INLINE static double size(double x) { return x < 0 ? -x : x; }
  /// Rounds to float towards `direction`, and further by more than an ulp. The boxes of the tree
  /// end at about 1, so values far beyond that need not be distinguished.
  CUTWATER_INLINE static float outward(double value, int direction) {
    constexpr double kFar = 1e15;  // its square does not overflow
    const double margin = 0x1p-23 * size(value) + 0x1p-126;
    return static_cast<float>(std::clamp(value + direction * margin, -kFar, kFar));
  }

  Vec3<double> middle_;
  std::array<Vec3<double>, 3> half_;
  double slack_;
};

/// The parameter along the segment at which a child's box begins, never less than -1.
template <int K>
class FirstParameters {
 public:
  CUTWATER_INLINE FirstParameters(const BvhFrame& frame, const Segment<double>& segment,
                                  double margin)
      : start_(frame.toFrame(segment.start)), end_(frame.toFrame(segment.end)) {
    // A cube reaches sqrt(3) times as far along the axes of a turned frame.
    const double reach = 2 * margin * frame.scale;
    reach_ = {reach, reach, reach};
  }

  /// A key for each lane: see BvhTree::traverse().
  CUTWATER_INLINE void operator()(const BvhNode<K>& node, typename BvhNode<K>::Lanes& out) const {
    const BvhSegment local(node.toLocal(start_), node.toLocal(end_));
    for (std::size_t k = 0; k < K; ++k) {
      const Box<double> box = node.localBox(static_cast<int>(k));
      const Vec3<double> middle = box.center();
      const Vec3<double> half = 0.5 * box.size() + reach_;
      out[k] = local.isApart(middle, half) ? kMostKey : local.firstParameter(middle, half);
    }
  }

 private:
  Vec3<double> start_;
  Vec3<double> end_;
  Vec3<double> reach_;
};

}  // namespace cutwater
