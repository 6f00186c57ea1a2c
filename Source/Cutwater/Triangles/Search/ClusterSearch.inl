#pragma once

// The nearest triangles to neighbouring points, whose searches share most of the work. Compiled
// once per instruction set.

#include <Cutwater/Triangles/Search/LeafCluster.inl>
#include <Cutwater/Triangles/Search/TriangleCluster.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

// Functions that process many points at once are not inlined: inlining would only cost compile
// time.

/// Collects the leaves of the tree that may hold a triangle nearest to some of the points.
/// Continues with their triangles if these are few, else with the leaves.
template <typename T>
class ClusterSearch {
 public:
  using Points = ClusterPoints<T>;
  using Nearest = typename Points::Nearest;

  CUTWATER_INLINE ClusterSearch(const TriangleSearch& tree, const KernelTriangles<T>& arrays)
      : tree_(tree),
        arrays_(arrays),
        points_(tree, arrays),
        triangles_(tree, arrays, points_),
        leafwise_(tree, arrays, points_, triangles_) {}

  /// Returns false if the points have too little in common; those from `next()` on are not
  /// processed.
  CUTWATER_INLINE bool run(const Vec3<T>* points, Nearest* bests, int count) {
    next_ = 0;
    if (!points_.place(points, bests, count)) return false;
    const bool isShared = collect(points_.boxAround(0, count));
    for (; next_ < count; next_ += Points::kGroup) {
      const int end = next_ + Points::kGroup < count ? next_ + Points::kGroup : count;
      if (!isShared && !collect(points_.boxAround(next_, end))) return false;
      if (!(hasTriangles_ && triangles_.runGroup(next_, end))) {
        if (!leafwise_.runGroup(leaves_, near_, next_, end)) return false;
        hasTriangles_ = false;  // the leaf-wise search uses the list itself
      }
    }
    return true;
  }
  CUTWATER_INLINE int next() const { return next_; }

  /// The same for triangles within `reach` of each point, in the surface's units; those farther
  /// away are left out, or not. Returns false if the points are too far away, or the leaves too
  /// many.
  CUTWATER_INLINE bool runWithin(const Vec3<T>* points, Nearest* bests, int count, double reach) {
    if (!points_.place(points, bests, count)) return false;
    points_.limit(reach);
    const ClusterBox box = points_.boxAround(0, count);
    const ClusterBounds bounds = points_.boundsFor(box);
    if (!collectLeaves(points_.middle(box), bounds)) return false;
    if (leaves_.count() == 0) return true;
    hasTriangles_ =
        leaves_.count() <= kLeastLeaves && triangles_.collect(leaves_, points_.middle(box), bounds);
    for (int begin = 0; begin < count; begin += Points::kGroup) {
      const int end = begin + Points::kGroup < count ? begin + Points::kGroup : count;
      runGroupWithin(begin, end, reach);
    }
    return true;
  }

 private:
  static constexpr int kMostLeaves = 512;
  static constexpr int kFewLeaves = 64;
  static constexpr int kLeastLeaves = 16;  // narrowed no further
  static constexpr int kMostWaiting = 256;
  static constexpr float kWidest = 0.125F;  // half the width; the surface is about 1 wide

  /// Collects all leaves that may hold a triangle nearest to a point in the box. Returns false if
  /// there are too many.
  [[gnu::noinline]] bool collect(const ClusterBox& box) {
    if (maxComponent(box.half) > kWidest) return false;
    const Vec3<double> middle = points_.middle(box);
    near_ = closestTo(middle);
    const ClusterBounds bounds = points_.boundsFor(box, near_);
    if (!collectLeaves(middle, bounds)) return false;
    hasTriangles_ = leaves_.count() <= kFewLeaves && triangles_.collect(leaves_, middle, bounds);
    return leaves_.count() > 0;
  }
  [[gnu::noinline]] bool collectLeaves(const Vec3<double>& middle, const ClusterBounds& bounds) {
    leaves_.clear();
    std::uint32_t waiting[kMostWaiting];
    int count = 0;
    waiting[count++] = 0;
    while (count > 0) {
      const Node& node = tree_.nodes[waiting[--count]];
      for (std::uint32_t lanes = remaining(node, middle, bounds); lanes != 0; lanes &= lanes - 1) {
        const int lane = __builtin_ctz(lanes);
        if (node.isLeaf(lane)) {
          if (leaves_.count() == kMostLeaves) return false;
          leaves_.add(tree_.packets, node.leafIndex(lane), points_.origin(), points_.reach());
        } else {
          if (count == kMostWaiting) return false;
          waiting[count++] = node.nodeIndex(lane);
        }
      }
    }
    leaves_.pad();
    return true;
  }
  /// For points [begin, end).
  [[gnu::noinline]] void runGroupWithin(int begin, int end, double reach) {
    const ClusterBox box = points_.boxAround(begin, end);
    if (!hasTriangles_) {
      selectLeaves(box, points_.boundsFor(box));
      if (ofGroup_.count() == 0) return;
      const ClusterBounds bounds = triangles_.boundsBy(ofGroup_.nearestTo(box.middle), box);
      if (ofGroup_.count() > kLeastLeaves) selectLeaves(box, bounds);
      if (ofGroup_.count() > kFewLeaves ||
          !triangles_.collect(ofGroup_, points_.middle(box), bounds)) {
        near_ = closestTo(points_.middle(box));
        if (leafwise_.runGroup(ofGroup_, near_, begin, end)) return;
        return runOneByOne(begin, end, reach);
      }
    }
    if (triangles_.runGroup(begin, end)) return;
    for (; begin < end; begin += Points::kBrick) {
      const int last = begin + Points::kBrick < end ? begin + Points::kBrick : end;
      if (!triangles_.runGroup(begin, last)) runOneByOne(begin, last, reach);
    }
  }
  CUTWATER_INLINE void runOneByOne(int begin, int end, double reach) {
    for (int i = begin; i < end; ++i) {
      nearestOne(tree_, arrays_, points_.point(i), points_.best(i), reach);
    }
  }
  /// Narrows the leaves for all points to those for a group.
  CUTWATER_INLINE void selectLeaves(const ClusterBox& box, const ClusterBounds& bounds) {
    std::uint16_t kept[kMostLeaves];
    const int count = leaves_.within(box, bounds, kept);
    ofGroup_.clear();
    for (int i = 0; i < count; ++i) ofGroup_.add(leaves_, kept[i]);
    ofGroup_.pad();
  }

  /// The point of the surface that is nearest to `q`.
  CUTWATER_INLINE Vec3<double> closestTo(const Vec3<double>& q) const {
    const Vec3<T> p(tree_.frame.fromFrame(q));
    Nearest best;
    best.error = points_.error();
    nearestOne(tree_, arrays_, p, best);
    return points_.closestTo(p, best.triangle);
  }

  CUTWATER_INLINE static std::uint32_t remaining(const Node& node, const Vec3<double>& middle,
                                                 const ClusterBounds& bounds) {
    const BvhLocalPoint local = node.toLocalFloat(middle);
    std::uint32_t beyond = 0;
    for (int lane = 0; lane < 16; lane += kFloats) {
      Floats3 w;
      Floats* const components[3] = {&w.x, &w.y, &w.z};
      for (int axis = 0; axis < 3; ++axis) {
        const float x = local.position[axis];
        *components[axis] =
            missed(load(lowerSide(node, axis) + lane), load(upperSide(node, axis) + lane),
                   broadcast(x - local.error), broadcast(x + local.error));
      }
      const Floats squared = fusedDot(w, w);
      beyond |= bounds.isBeyond(squared, squareRoot(squared), alongAxes(node, w, bounds.half()))
                << lane;
    }
    return ~beyond & node.childMask();
  }
  /// Products of w, in the node's frame, with the half extents of the cluster's box.
  CUTWATER_INLINE static Floats3 alongAxes(const Node& node, const Floats3& w,
                                           const Vec3<float>& half) {
    const auto along = [&](int axis) __attribute__((always_inline)) {
      const Floats3 row{broadcast(axisOf(node, 0)[axis] * half[axis]),
                        broadcast(axisOf(node, 1)[axis] * half[axis]),
                        broadcast(axisOf(node, 2)[axis] * half[axis])};
      return fusedDot(w, row);
    };
    return {along(0), along(1), along(2)};
  }

  const TriangleSearch& tree_;
  const KernelTriangles<T>& arrays_;
  Points points_;
  TriangleCluster<T> triangles_;
  LeafCluster<T> leafwise_;
  int next_ = 0;
  LeafList<kMostLeaves> leaves_;
  LeafList<kMostLeaves> ofGroup_;
  bool hasTriangles_ = false;
  Vec3<double> near_;  // on the surface
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
