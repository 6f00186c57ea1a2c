#pragma once

// Leaves of the tree that may hold the nearest triangles of a cluster's points. Compiled once per
// instruction set.

#include <Cutwater/Triangles/Search/ClusterBounds.inl>
#include <Cutwater/Triangles/Search/PointSearch.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// The gap between a point and the box of each lane, in the node's frame. It never overestimates
/// the true distance.
CUTWATER_INLINE inline Floats missed(Floats lower, Floats upper, Floats least, Floats most) {
  const Floats none = broadcast(0.0F);
  return CUTWATER_SIMD::most(least - upper, none) - CUTWATER_SIMD::most(lower - most, none);
}

/// The boxes of leaves, each in a frame of its own, lane by lane; points are relative to the
/// cluster's origin.
template <int kMostOf>
class LeafList {
 public:
  static constexpr int kMost = kMostOf;

  CUTWATER_INLINE void clear() { count_ = 0; }
  CUTWATER_INLINE int count() const { return count_; }
  CUTWATER_INLINE std::uint32_t leaf(int i) const { return leaves_[i]; }

  /// Adds a leaf. All points are within `reach` of the origin, in the sum of absolute components.
  CUTWATER_INLINE void add(const TrianglePacket* packets, std::uint32_t leaf,
                           const Vec3<double>& origin, float reach) {
    const float* const box = boxOf(packets[leaf]);
    const Vec3<float> d(origin - Vec3<double>(packets[leaf].center));
    // As of BvhNode::toLocalFloat().
    const float error = 6 * 0x1p-24F * (magnitudeOf(d.x) + magnitudeOf(d.y) + magnitudeOf(d.z));
    for (int i = 0; i < 3; ++i) {
      const float* const axis = box + std::ptrdiff_t{3} * i;
      const float shift = axis[0] * d.x + axis[1] * d.y + axis[2] * d.z;
      const float half = box[9 + i];
      // The error of the origin's position, and the rounding of the following steps and of the
      // points.
      const float margin = error + 0x1p-21F * (2 * half + magnitudeOf(shift) + reach);
      rows_[i][count_] = -half - shift - margin;
      rows_[3 + i][count_] = half - shift + margin;
      for (int k = 0; k < 3; ++k) rows_[6 + 3 * i + k][count_] = axis[k];
    }
    leaves_[count_++] = leaf;
  }
  template <int kOther>
  CUTWATER_INLINE void add(const LeafList<kOther>& other, int i) {
    for (int row = 0; row < kRows; ++row) rows_[row][count_] = other.at(row, i);
    leaves_[count_++] = other.leaf(i);
  }
  /// Pads to a full vector with boxes that no limit reaches.
  CUTWATER_INLINE void pad() {
    for (int i = count_; i % 16 != 0; ++i) {
      for (int row = 0; row < kRows; ++row) rows_[row][i] = 0;
      for (int row = 0; row < 6; ++row) rows_[row][i] = kNowhere;
    }
  }
  CUTWATER_INLINE float at(int row, int i) const { return rows_[row][i]; }

  /// Squared distances to the boxes of 16 leaves; see Search::enter().
  CUTWATER_INLINE void keys(int first, const Vec3<float>& p, float* keys) const {
    for (int lane = 0; lane < 16; lane += kFloats) {
      const Floats3 w = gap(first + lane, p);
      store(keys + lane, fusedDot(w, w));
    }
  }
  /// The leaf whose box is nearest to a point.
  CUTWATER_INLINE std::uint32_t nearestTo(const Vec3<float>& p) const {
    alignas(64) float keys[16];
    float least = kFar;
    int nearest = 0;
    for (int first = 0; first < count_; first += 16) {
      this->keys(first, p, keys);
      const int lane = leastLane(keys, 0xffffU);
      if (keys[lane] < least) least = keys[lane], nearest = first + lane;
    }
    return leaves_[nearest];
  }
  /// Writes the indices of the leaves that may hold a nearest point of the box; returns how many.
  [[gnu::noinline]] int within(const ClusterBox& box, const ClusterBounds& bounds,
                               std::uint16_t* kept) const {
    int found = 0;
    for (int i = 0; i < count_; i += kFloats) {
      const Floats3 w = gap(i, box.middle);
      const Floats squared = fusedDot(w, w);
      const Floats3 along{broadcast(box.half.x) * fusedDot(w, column(0, i)),
                          broadcast(box.half.y) * fusedDot(w, column(1, i)),
                          broadcast(box.half.z) * fusedDot(w, column(2, i))};
      std::uint32_t lanes = ~bounds.isBeyond(squared, squareRoot(squared), along);
      const int used = count_ - i < kFloats ? count_ - i : kFloats;
      for (lanes &= (1U << used) - 1U; lanes != 0; lanes &= lanes - 1) {
        kept[found++] = static_cast<std::uint16_t>(i + __builtin_ctz(lanes));
      }
    }
    return found;
  }

 private:
  static constexpr int kRows = 15;  // lower, upper, and the axes
  static constexpr float kNowhere = 0x1p62F;

  CUTWATER_INLINE static float magnitudeOf(float x) { return x < 0 ? -x : x; }
  CUTWATER_INLINE Floats3 row(int i, int first) const {
    return {load(rows_[6 + 3 * i] + first), load(rows_[7 + 3 * i] + first),
            load(rows_[8 + 3 * i] + first)};
  }
  CUTWATER_INLINE Floats3 column(int k, int first) const {
    return {load(rows_[6 + k] + first), load(rows_[9 + k] + first), load(rows_[12 + k] + first)};
  }
  CUTWATER_INLINE Floats3 gap(int first, const Vec3<float>& p) const {
    const Floats3 q{broadcast(p.x), broadcast(p.y), broadcast(p.z)};
    const auto along = [&](int i) __attribute__((always_inline)) {
      const Floats x = fusedDot(row(i, first), q);
      return missed(load(rows_[i] + first), load(rows_[3 + i] + first), x, x);
    };
    return {along(0), along(1), along(2)};
  }

  alignas(64) float rows_[kRows][kMost];
  std::uint32_t leaves_[kMost];
  int count_ = 0;
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
