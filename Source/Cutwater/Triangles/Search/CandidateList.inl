#pragma once

// Triangles that may be nearest to points of a cluster. Compiled once per instruction set.

#include <Cutwater/Triangles/Search/ClusterBounds.inl>
#include <Cutwater/Triangles/Search/PacketDistance.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Triangles in single precision, relative to the cluster's origin; stored in rows as in a packet.
template <int kMostOf>
class CandidateList {
 public:
  static constexpr int kMost = kMostOf;

  CUTWATER_INLINE void clear() {
    count_ = 0;
    radius_ = 0;
  }
  /// Adds a triangle. Its rows are `stride` apart; its corners are relative to a point that is
  /// `shift` from the origin, and within `radius` of that point.
  CUTWATER_INLINE void add(const float* rows, int stride, const Vec3<float>& shift, float radius,
                           std::uint32_t id) {
    rows_[0][count_] = rows[0] + shift.x;
    rows_[1][count_] = rows[stride] + shift.y;
    rows_[2][count_] = rows[2 * stride] + shift.z;
    for (int row = 3; row < PackedTriangle::kRows; ++row) rows_[row][count_] = rows[row * stride];
    ids_[count_++] = id;
    const Vec3<float> size = abs(shift);
    const float reach = size.x + size.y + size.z + radius;
    radius_ = reach > radius_ ? reach : radius_;
  }
  /// Repeats the last candidate up to a full vector.
  CUTWATER_INLINE void pad() {
    for (int i = count_; i % kFloats != 0; ++i) {
      for (auto& row : rows_) row[i] = row[count_ - 1];
    }
  }

  CUTWATER_INLINE int count() const { return count_; }
  CUTWATER_INLINE std::uint32_t id(int i) const { return ids_[i]; }
  CUTWATER_INLINE const float* rows() const { return rows_[0]; }
  CUTWATER_INLINE PackedTriangle triangles(int i) const {
    return packedTriangle(rows_[0], kMost, i);
  }
  /// All corners are within this distance of the origin, in the sum of absolute components.
  CUTWATER_INLINE float radius() const { return radius_; }
  /// The unit of rounding errors at a point; see PacketPoint::unit.
  CUTWATER_INLINE float unitAt(const Vec3<float>& p) const {
    const Vec3<float> size = abs(p);
    return 0x1p-24F * (size.x + size.y + size.z + radius_);
  }

  /// Writes the indices of the candidates that may be nearest to a point in the box, and within
  /// `limit` of it; returns how many.
  [[gnu::noinline]] int within(const ClusterBox& box, float slack, float limit,
                               std::uint16_t* kept) const {
    alignas(64) float squared[kMost];
    alignas(64) float separation[kMost];
    alignas(64) float offset[3][kMost];
    const float unit = unitAt(box.middle);
    const Floats3 p{broadcast(box.middle.x), broadcast(box.middle.y), broadcast(box.middle.z)};
    Floats nearest = broadcast(kFar);
    for (int i = 0; i < count_; i += kFloats) {
      const auto t = triangles(i);
      const auto off = packedOffset(t, p, unit);
      nearest = least(nearest, off.squared);
      store(squared + i, off.squared);
      store(separation + i, packedSeparation(t, p, off, unit));
      store(offset[0] + i, off.offset.x);
      store(offset[1] + i, off.offset.y);
      store(offset[2] + i, off.offset.z);
    }
    if (count_ == 0) return 0;
    int best = 0;
    for (const float value = leastOf(nearest); squared[best] != value && best + 1 < count_;) ++best;
    ClusterBounds bounds(box.half, {offset[0][best], offset[1][best], offset[2][best]},
                         kOffsetError * unit + slack);
    bounds.limit(limit + kOffsetError * unit);
    int found = 0;
    for (int i = 0; i < count_; i += kFloats) {
      const Floats3 w{load(offset[0] + i), load(offset[1] + i), load(offset[2] + i)};
      const Floats3 along{broadcast(box.half.x) * w.x, broadcast(box.half.y) * w.y,
                          broadcast(box.half.z) * w.z};
      std::uint32_t lanes =
          ~bounds.isBeyond(load(separation + i), squareRoot(load(squared + i)), along);
      const int used = count_ - i < kFloats ? count_ - i : kFloats;
      for (lanes &= (1U << used) - 1U; lanes != 0; lanes &= lanes - 1) {
        kept[found++] = static_cast<std::uint16_t>(i + __builtin_ctz(lanes));
      }
    }
    return found;
  }

 private:
  alignas(64) float rows_[PackedTriangle::kRows][kMost];
  std::uint32_t ids_[kMost];
  int count_ = 0;
  float radius_ = 0;
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
