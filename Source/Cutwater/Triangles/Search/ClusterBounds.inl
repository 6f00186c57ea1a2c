#pragma once

// Finds triangles and boxes that hold no nearest point for a whole cluster of points. Compiled once
// per instruction set.

#include <Cutwater/Triangles/Search/PacketDistance.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// An axis-parallel box around points, in the tree's frame.
struct ClusterBox {
  Vec3<float> middle;  ///< relative to some origin
  Vec3<float> half;    ///< extents, rounded upward
};

/// The test, given one point c of the surface: whatever is farther than c from each point of the
/// box can be discarded.
///
/// Let w be any vector and s the least w . (m - x), where m is the box's middle and x any point of
/// a triangle (or box). Then the distance from m + e is at least (s + w . e) / |w|. The condition
/// to be shown for all e, s + w . e > |w| |m + e - c|, holds in the whole box if it does at its 8
/// corners, as the right side is convex. The best w is about m minus its nearest point; it need not
/// be exact.
class ClusterBounds {
 public:
  /// `off` = m - c. `margin` bounds the distance of c from the surface, and must include all errors
  /// of the points.
  CUTWATER_INLINE ClusterBounds(const Vec3<float>& half, const Vec3<float>& off, float margin)
      : half_(half) {
    const float rounding = roundingOf(half);
    for (int i = 0; i < 8; ++i) {
      const Vec3<float> v{off.x + (i % 2 == 0 ? -half.x : half.x),
                          off.y + (i / 2 % 2 == 0 ? -half.y : half.y),
                          off.z + (i / 4 == 0 ? -half.z : half.z)};
      const float length = squareRoot(v.x * v.x + v.y * v.y + v.z * v.z);
      farther_[i] = length * (1 + 0x1p-20F) + rounding + margin;
    }
  }
  /// Without c: only limit() says what can be discarded.
  CUTWATER_INLINE explicit ClusterBounds(const Vec3<float>& half) : half_(half) {
    for (float& farther : farther_) farther = kFar;
  }
  /// Whatever is farther than that from each point can be discarded as well. The distance must
  /// include all errors of the points.
  CUTWATER_INLINE void limit(float distance) {
    limit_ = distance * (1 + 0x1p-20F) + roundingOf(half_);
  }

  /// Bit mask of the lanes that can be discarded. `separation` is at most s, `length` is |w|;
  /// `along` holds w . e for the box's half extents one by one.
  CUTWATER_INLINE std::uint32_t isBeyond(Floats separation, Floats length,
                                         const Floats3& along) const {
    const Floats sums[4] = {along.x + along.y, along.x - along.y, along.y - along.x,
                            broadcast(0.0F) - along.x - along.y};  // of corners 3, 1, 2, 0
    constexpr int kCorner[4] = {3, 1, 2, 0};
    Floats most = broadcast(-kFar);
    for (int i = 0; i < 4; ++i) {
      const int corner = kCorner[i];
      most = CUTWATER_SIMD::most(
          most, multiplyAdd(broadcast(farther_[corner]), length, along.z - sums[i]));
      most = CUTWATER_SIMD::most(most, multiplyAdd(broadcast(farther_[corner + 4]), length,
                                                   broadcast(0.0F) - along.z - sums[i]));
    }
    // In no direction e is |w| times the limit less w . e larger than this.
    const Floats limit = multiplyAdd(broadcast(limit_), length,
                                     magnitude(along.x) + magnitude(along.y) + magnitude(along.z));
    most = least(most, limit);
    return bits(both(isPositive(separation * broadcast(1 - 0x1p-20F) - most),
                     isPositive(length - broadcast(kLeast))));
  }

  CUTWATER_INLINE const Vec3<float>& half() const { return half_; }

 private:
  /// Squares of shorter vectors underflow, so that their length is not known.
  static constexpr float kLeast = 0x1p-50F;

  /// Relative rounding here and in isBeyond(): below 16 u, u = 2^-24, of the lengths |off + e| and
  /// of |e|; this is that of |e|.
  CUTWATER_INLINE static float roundingOf(const Vec3<float>& half) {
    return 0x1p-20F * (half.x + half.y + half.z);
  }

  Vec3<float> half_;
  float farther_[8];  // |corner - c| plus the margin
  float limit_ = kFar;
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
