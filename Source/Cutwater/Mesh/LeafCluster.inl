#pragma once

// Nearest triangles of points that share leaves of the tree, but not the triangles. Compiled once
// per instruction set.

#include <Cutwater/Mesh/TriangleCluster.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// From leaves for all of the points to those for a group, then for a brick. Each point looks at
/// these as if they were the children of one node.
template <typename T>
class LeafCluster {
 public:
  using Points = ClusterPoints<T>;

  CUTWATER_INLINE LeafCluster(const TriangleSearch& tree, const TriangleArrays<T>& arrays,
                              const Points& points, TriangleCluster<T>& triangles)
      : tree_(tree), points_(points), triangles_(triangles), search_(tree, arrays) {}

  /// Points [begin, end), whose nearest triangles are in the leaves. `near`: a point of the
  /// surface. False: there are too many leaves, and what was done for some point does no harm.
  template <int kMost>
  [[gnu::noinline]] bool runGroup(const LeafList<kMost>& shared, Vec3<double> near, int begin,
                                  int end) {
    near = searchFirst(shared, near, (begin + end) / 2);
    if (!select(shared, points_.boxAround(begin, end), near, group_)) return false;
    for (; begin < end; begin += Points::kBrick) {
      runBrick(near, begin, begin + Points::kBrick < end ? begin + Points::kBrick : end);
    }
    return true;
  }

 private:
  static constexpr int kMost = 192;
  static constexpr int kFewLeaves = 32;

  [[gnu::noinline]] void runBrick(Vec3<double>& near, int begin, int end) {
    near = searchFirst(group_, near, (begin + end) / 2);
    const ClusterBox box = points_.boxAround(begin, end);
    select(group_, box, near, brick_);  // always: they are no more
    if (brick_.count() <= kFewLeaves &&
        triangles_.collect(brick_, points_.middle(box), points_.boundsFor(box, near)) &&
        triangles_.runGroup(begin, end)) {
      return;
    }
    for (int i = begin; i < end; ++i) search(brick_, near, i);
  }

  template <int kFrom>
  CUTWATER_INLINE bool select(const LeafList<kFrom>& from, const ClusterBox& box,
                              const Vec3<double>& near, LeafList<kMost>& to) {
    std::uint16_t kept[kFrom];
    const int count = from.within(box, points_.boundsFor(box, near), kept);
    if (count > kMost) return false;
    to.clear();
    for (int i = 0; i < count; ++i) to.add(from, kept[i]);
    to.pad();
    return true;
  }
  /// For a point that is to tell the bounds of others; the point of the surface nearest to it.
  template <int kFrom>
  CUTWATER_INLINE Vec3<double> searchFirst(const LeafList<kFrom>& leaves, const Vec3<double>& near,
                                           int i) {
    search(leaves, near, i);
    return points_.closestTo(points_.point(i), points_.best(i).triangle);
  }
  template <int kFrom>
  [[gnu::noinline]] void search(const LeafList<kFrom>& leaves, const Vec3<double>& near, int i) {
    const Vec3<double> way = tree_.frame.toFrame(Vec3<double>(points_.point(i))) - near;
    const double reach = __builtin_sqrt(dot(way, way)) / tree_.frame.scale;
    search_.start(points_.point(i), points_.best(i),
                  reach * (1 + 0x1p-20) + double{points_.best(i).error});
    alignas(64) float keys[16];
    for (int first = 0; first < leaves.count(); first += 16) {
      leaves.keys(first, points_.position(i), keys);
      std::uint32_t lanes = CUTWATER_SIMD::within(keys, search_.limit());
      while (lanes != 0) {
        const int lane = leastLane(keys, lanes);
        if (keys[lane] > search_.limit()) break;
        lanes &= ~(1U << lane);
        search_.look(leaves.leaf(first + lane));
      }
    }
    search_.evaluate();
  }

  const TriangleSearch& tree_;
  const Points& points_;
  TriangleCluster<T>& triangles_;
  Search<T> search_;
  LeafList<kMost> group_;
  LeafList<kMost> brick_;
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
