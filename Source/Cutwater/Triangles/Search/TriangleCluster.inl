#pragma once

// Nearest triangles to points that share few of them. Compiled once per instruction set.

#include <Cutwater/Triangles/Search/BrickDistances.inl>
#include <Cutwater/Triangles/Search/BrickEvaluation.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Narrows the triangles that may be nearest to any of the points to those for a group of points,
/// then to those for a brick; then tests each point of a brick with each remaining triangle.
template <typename T>
class TriangleCluster {
 public:
  using Points = ClusterPoints<T>;

  CUTWATER_INLINE TriangleCluster(const TriangleSearch& tree, const KernelTriangles<T>& arrays,
                                  const Points& points)
      : tree_(tree), points_(points), evaluation_(arrays, points) {}

  /// Collects the triangles of leaves that may be nearest to a point within the bounds, or none.
  /// Returns false if there are too many.
  template <int kMost>
  CUTWATER_INLINE bool collect(const LeafList<kMost>& leaves, const Vec3<double>& middle,
                               const ClusterBounds& bounds) {
    shared_.clear();
    for (int i = 0; i < leaves.count(); ++i) {
      if (!collectFrom(leaves.leaf(i), middle, bounds)) return false;
    }
    shared_.pad();
    return true;
  }
  /// Bounds for the box by the nearest of a leaf's triangles.
  [[gnu::noinline]] ClusterBounds boundsBy(std::uint32_t leaf, const ClusterBox& box) const {
    const TrianglePacket& packet = tree_.packets[leaf];
    const PacketPoint local = relativeTo(packet, points_.middle(box));
    Vec3<float> off;
    float nearest = kFar;
    for (int lane = 0; lane < kWidth; lane += kFloats) {
      const auto t = packedTriangle(rowsOf(packet), kWidth, lane);
      const auto found = packedOffset(t, local.position, local.unit);
      const float least = leastOf(found.squared);
      if (!(least < nearest)) continue;
      nearest = least;
      const int best = __builtin_ctz(bits(isAtMost(found.squared, broadcast(least))));
      alignas(64) float components[3][kFloats];
      store(components[0], found.offset.x);
      store(components[1], found.offset.y);
      store(components[2], found.offset.z);
      off = {components[0][best], components[1][best], components[2][best]};
    }
    return points_.boundsBy(box, off, kOffsetError * local.unit);
  }
  /// Processes points [begin, end). Returns false, having done nothing, if there are too many
  /// triangles.
  [[gnu::noinline]] bool runGroup(int begin, int end) {
    std::uint16_t kept[kMostShared];
    const int count =
        shared_.within(points_.boxAround(begin, end), points_.slack(), points_.limit(), kept);
    if (count > kMostOfGroup) return false;
    group_.clear();
    for (int i = 0; i < count; ++i) {
      group_.add(shared_.rows() + kept[i], kMostShared, {}, shared_.radius(), shared_.id(kept[i]));
    }
    group_.pad();
    prepared_.prepare(group_);
    for (; begin < end; begin += kBrick) {
      runBrick(begin, end - begin < kBrick ? end - begin : kBrick);
    }
    return true;
  }

 private:
  static constexpr int kBrick = Points::kBrick;
  static constexpr int kMostShared = 512;
  static constexpr int kMostOfGroup = BrickEvaluation<T>::kMost;

  [[gnu::noinline]] bool collectFrom(std::uint32_t leaf, const Vec3<double>& middle,
                                     const ClusterBounds& bounds) {
    const TrianglePacket& packet = tree_.packets[leaf];
    const PacketPoint local = relativeTo(packet, middle);
    const Vec3<float> half = bounds.half();
    std::uint32_t beyond = 0;
    for (int lane = 0; lane < kWidth; lane += kFloats) {
      const auto t = packedTriangle(rowsOf(packet), kWidth, lane);
      const auto off = packedOffset(t, local.position, local.unit);
      const Floats3 along{broadcast(half.x) * off.offset.x, broadcast(half.y) * off.offset.y,
                          broadcast(half.z) * off.offset.z};
      beyond |= bounds.isBeyond(packedSeparation(t, local.position, off, local.unit),
                                squareRoot(off.squared), along)
                << lane;
    }
    const Vec3<float> shift(Vec3<double>(packet.center) - points_.origin());
    for (std::uint32_t lanes = ~beyond & 0xffffU; lanes != 0; lanes &= lanes - 1) {
      const int lane = __builtin_ctz(lanes);
      const std::uint32_t id = tree_.slots[leaf * kWidth + static_cast<std::uint32_t>(lane)];
      if (id == kNone) break;
      if (shared_.count() == kMostShared) return false;
      shared_.add(rowsOf(packet) + lane, kWidth, shift, packet.radius, id);
    }
    return true;
  }

  [[gnu::noinline]] void runBrick(int begin, int used) {
    std::uint16_t kept[kMostOfGroup];
    const int count = group_.within(points_.boxAround(begin, begin + kBrick), points_.slack(),
                                    points_.limit(), kept);
    alignas(64) float squared[kMostOfGroup][kBrick];
    alignas(64) float limits[kBrick];
    for (int lane = 0; lane < kBrick; lane += kFloats) {
      const int at = begin + lane;
      const Floats3 p = points_.positions(at);
      const Floats unit = broadcast(0x1p-24F) * (sizeOf(p) + broadcast(group_.radius()));
      const Floats margin = broadcast(kSideError) * unit;
      Floats nearest = broadcast(kFar);
      for (int i = 0; i < count; ++i) {
        const Floats d = prepared_.squaredDistances(kept[i], p, margin);
        store(squared[i] + lane, d);
        nearest = least(nearest, d);
      }
      // The nearest distance has an error, and so do those of its competitors.
      const Floats lower = squareRoot(nearest);
      const Floats isNear = broadcast(kNearby) * unit - lower;
      const Floats error =
          where(isPositive(isNear), broadcast(kErrorNearby + 2), broadcast(kError + 2)) * unit;
      const Floats reach = lower + error + error + broadcast(points_.slack());
      // None is wanted beyond the limit.
      const auto isWanted = isAtMost(lower, error + broadcast(points_.limit()));
      store(limits + lane,
            where(isWanted, reach * reach * broadcast(1 + 0x1p-19F), broadcast(-1.0F)));
    }
    evaluation_.begin(begin, used);
    for (int i = 0; i < count; ++i) {
      std::uint32_t near = 0;
      for (int lane = 0; lane < kBrick; lane += kFloats) {
        near |= bits(isAtMost(load(squared[i] + lane), load(limits + lane))) << lane;
      }
      if (near != 0) evaluation_.add(group_.id(kept[i]), near);
    }
    evaluation_.finish();
  }

  const TriangleSearch& tree_;
  const Points& points_;
  CandidateList<kMostShared> shared_;
  CandidateList<kMostOfGroup> group_;
  PreparedTriangles<kMostOfGroup> prepared_;
  BrickEvaluation<T> evaluation_;
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
