#pragma once

// Nearest triangles to points that share leaves of the tree, but not triangles. Compiled once per
// instruction set.

#include <Cutwater/Triangles/Search/TriangleCluster.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Narrows the leaves for all points to those for a group, then to those for a brick. Each point
/// visits the latter as if they were the children of one node.
template <typename T>
class LeafCluster {
 public:
  using Points = ClusterPoints<T>;

  CUTWATER_INLINE LeafCluster(const TriangleSearch& tree, const KernelTriangles<T>& arrays,
                              const Points& points, TriangleCluster<T>& triangles)
      : tree_(tree), points_(points), triangles_(triangles), search_(tree, arrays) {}

  /// Searches for points [begin, end), whose nearest triangles are in the leaves. `near` is a point
  /// of the surface. Returns false if there are too many leaves; work already done for a point is
  /// harmless.
  template <int kMost>
  [[gnu::noinline]] bool runGroup(const LeafList<kMost>& shared, Vec3<double> near, int begin,
                                  int end) {
    near = searchFirst(shared, near, (begin + end) / 2);
    const bool isNarrowed = select(shared, points_.boxAround(begin, end), near, group_);
    for (; begin < end; begin += Points::kBrick) {
      const int last = begin + Points::kBrick < end ? begin + Points::kBrick : end;
      if (!(isNarrowed ? runBrick(group_, near, begin, last)
                       : runBrick(shared, near, begin, last))) {
        return false;
      }
    }
    return true;
  }

 private:
  static constexpr int kMost = 192;
  static constexpr int kFewLeaves = 32;

  /// The same for a brick.
  template <int kFrom>
  [[gnu::noinline]] bool runBrick(const LeafList<kFrom>& leaves, Vec3<double>& near, int begin,
                                  int end) {
    near = searchFirst(leaves, near, (begin + end) / 2);
    const ClusterBox box = points_.boxAround(begin, end);
    if (!select(leaves, box, near, brick_)) return false;
    if (brick_.count() <= kFewLeaves &&
        triangles_.collect(brick_, points_.middle(box), points_.boundsFor(box, near)) &&
        triangles_.runGroup(begin, end)) {
      return true;
    }
    for (int i = begin; i < end; ++i) search(brick_, near, i);
    return true;
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
  /// Searches first for a point whose result bounds those of others. Returns the point of the
  /// surface nearest to it.
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
