#pragma once

// The nearest triangle to one point. Compiled once per instruction set.

#include <Cutwater/Triangles/Search/NodeReach.inl>
#include <Cutwater/Triangles/Search/TriangleCompetition.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

constexpr double kFarthest = 0x1p58;

/// Bit mask of the 16 squared distances that are at most the limit.
CUTWATER_INLINE inline std::uint32_t within(const float* squares, float limit) {
  std::uint32_t lanes = 0;
  for (int lane = 0; lane < 16; lane += kFloats) {
    lanes |= bits(isAtMost(load(squares + lane), broadcast(limit))) << lane;
  }
  return lanes;
}

/// Bound, in the tree's frame, on how much farther than the nearest triangle one may be that is the
/// nearest, or ties with it, by computed distances; includes the rounding of positions in the
/// frames. `size` is the magnitude of the point's largest coordinate.
CUTWATER_INLINE inline double slackOf(double error, double size, const BvhFrame& frame) {
  return 4 * error * frame.scale + 0x1p-49 * (1 + size) + 0x1p-60;
}

/// Receives the events of a search and ignores them; the benchmarks have an observer that counts.
struct NoObserver {
  CUTWATER_INLINE void onNode() const {}
  CUTWATER_INLINE void onLeaf() const {}
  CUTWATER_INLINE void onEvaluation(int /*triangles*/) const {}
};

/// The search for the triangles nearest to one point, in steps, so that several searches can be
/// interleaved.
template <typename T, typename Observer = NoObserver>
class Search {
 public:
  CUTWATER_INLINE Search(const TriangleSearch& tree, const KernelTriangles<T>& surface,
                         Observer observer = {})
      : tree_(tree), surface_(surface), observer_(observer) {}

  /// The nearest triangle is known to be within `reach`, in the surface's units.
  CUTWATER_INLINE void start(const Vec3<T>& p, typename TriangleSurface<T>::Nearest& best,
                             double reach) {
    p_ = &p;
    best_ = &best;
    q_ = tree_.frame.toFrame(Vec3<double>(p));
    const double size = maxComponent(abs(q_));
    slack_ = slackOf(double{best.error}, size, tree_.frame);
    // Beyond that, the slack exceeds the tree and all triangles compete: any point as far away is
    // equivalent, and squares do not overflow.
    if (size > kFarthest) q_ *= kFarthest / size;
    upper_ = reach * tree_.frame.scale;
    setLimit();
    depth_ = 0;
    isLeaf_ = false;
    isCrowded_ = false;
    target_ = 0;
  }

  /// Processes a node or a leaf and determines the next one. Returns false if there is none.
  CUTWATER_INLINE bool step() {
    if (isLeaf_) {
      observer_.onLeaf();
      look(target_);
    } else {
      observer_.onNode();
      Level& level = path_[depth_++];
      level.node = &tree_.nodes[target_];
      level.pending = enter(*level.node, level.keys);
    }
    while (depth_ > 0) {
      Level& level = path_[depth_ - 1];
      if (level.pending != 0) {
        // The choice of lane does not depend on the limit, so that a processor can begin to load it
        // while it still computes the limit from the last one.
        const int lane = leastLane(level.keys, level.pending);
        level.pending &= ~(1U << lane);
        if (level.keys[lane] <= limit_) {
          if (isCrowded_ && !reaches(*level.node, lane)) continue;
          setTarget(*level.node, lane);
          return true;
        }
      }
      // Nothing is left, or the limit has dropped below the rest meanwhile.
      --depth_;
    }
    return false;
  }

  /// Prefetches what step() processes next.
  CUTWATER_INLINE void prefetch() const {
    prefetch(isLeaf_, target_);
    if (isLeaf_) __builtin_prefetch(&tree_.slots[std::size_t{target_} * kWidth]);
  }
  /// Prefetches what most likely comes after that.
  CUTWATER_INLINE void prefetchSecond() const {
    const Level& level = path_[depth_ - 1];
    if (level.pending == 0) return;
    const int lane = leastLane(level.keys, level.pending);
    if (level.keys[lane] > limit_) return;
    const bool isLeaf = level.node->isLeaf(lane);
    prefetch(isLeaf, isLeaf ? level.node->leafIndex(lane) : level.node->nodeIndex(lane));
  }

  /// Squared distances in the tree's frame above this no longer matter.
  CUTWATER_INLINE float limit() const { return limit_; }

  /// Records the triangles of a leaf that may be the nearest.
  CUTWATER_INLINE void look(std::uint32_t leaf) {
    const TrianglePacket& packet = tree_.packets[leaf];
    const PacketPoint local = relativeTo(packet, q_);
    alignas(64) float found[kWidth];
    // Most leaves hold no candidate: this is found without waiting for the square root.
    const Floats most = broadcast(squaredReach(kErrorNearby * local.unit));
    Floats nearest = broadcast(kFar);
    std::uint32_t lanes = 0;
    for (int lane = 0; lane < kWidth; lane += kFloats) {
      const Floats d = packedDistances(packet, lane, local);
      store(found + lane, d);
      nearest = least(nearest, d);
      lanes |= bits(isAtMost(d, most)) << lane;
    }
    if (lanes == 0) return;
    const float lower = squareRoot(leastOf(nearest));
    const float error =
        (lower > kNearby * local.unit ? kError : kErrorNearby) * local.unit + 0x1p-60F;
    if (const double upper = double{lower} + double{error}; upper < upper_) {
      upper_ = upper;
      setLimit();
    }
    for (lanes = within(found, squaredReach(error)); lanes != 0; lanes &= lanes - 1) {
      const int lane = __builtin_ctz(lanes);
      const std::uint32_t id = tree_.slots[leaf * kWidth + static_cast<std::uint32_t>(lane)];
      if (id == kNone) break;
      note(id, squareRoot(found[lane]) - error);
    }
    if (count_ > kCrowd && tree_.hullsOfNode != nullptr) narrow();
  }

  /// Evaluates the candidates in full.
  [[gnu::noinline]] void evaluate() {
    drop();
    observer_.onEvaluation(count_);
    Competition<T>(surface_, *p_).run(ids_, count_, *best_);
    count_ = 0;
  }

 private:
  struct Level {
    alignas(64) float keys[16];
    const Node* node;
    std::uint32_t pending;  // lanes
  };

  CUTWATER_INLINE void prefetch(bool isLeaf, std::uint32_t index) const {
    const void* const from = isLeaf ? static_cast<const void*>(&tree_.packets[index])
                                    : static_cast<const void*>(&tree_.nodes[index]);
    const std::size_t size = isLeaf ? sizeof(TrianglePacket) : sizeof(Node);
    for (std::size_t at = 0; at < size; at += 64) {
      __builtin_prefetch(static_cast<const char*>(from) + at);
    }
  }
  CUTWATER_INLINE void setTarget(const Node& node, int lane) {
    isLeaf_ = node.isLeaf(lane);
    target_ = isLeaf_ ? node.leafIndex(lane) : node.nodeIndex(lane);
  }
  /// The squared limit for distance bounds that are off by `error`.
  CUTWATER_INLINE float squaredReach(float error) const {
    const double reach = upper_ + slack_ + double{error};
    const double squared = reach * reach * (1 + 0x1p-19);
    return squared < kFar ? static_cast<float>(squared) : kFar;
  }
  CUTWATER_INLINE void setLimit() { limit_ = squaredReach(0); }

  /// Lower bounds of the squared distances to the node's children, up to relative rounding: see
  /// BvhTree::nearest(). Returns the lanes within the limit.
  CUTWATER_INLINE std::uint32_t enter(const Node& node, float* keys) const {
    const BvhLocalPoint local = node.toLocalFloat(q_);
    const Floats limit = broadcast(limit_);
    std::uint32_t lanes = 0;
    for (int lane = 0; lane < 16; lane += kFloats) {
      Floats sum = broadcast(0.0F);
      for (int axis = 0; axis < 3; ++axis) {
        const float x = local.position[axis];
        const Floats under = load(lowerSide(node, axis) + lane) - broadcast(x + local.error);
        const Floats over = broadcast(x - local.error) - load(upperSide(node, axis) + lane);
        const Floats gap = most(most(under, over), broadcast(0.0F));
        sum = multiplyAdd(gap, gap, sum);
      }
      store(keys + lane, sum);
      lanes |= bits(isAtMost(sum, limit)) << lane;
    }
    lanes &= node.childMask();
    if (const ChildHulls* const hulls = hullsOf(node); hulls != nullptr) {
      lanes &= raiseToHulls(*hulls, node.toLocal(q_), limit_, keys);
    }
    return lanes;
  }
  CUTWATER_INLINE const ChildHulls* hullsOf(const Node& node) const {
    if (tree_.hullsOfNode == nullptr) return nullptr;
    const std::uint32_t index = tree_.hullsOfNode[&node - tree_.nodes];
    return index == kNone ? nullptr : tree_.hulls + index;
  }
  /// Whether a child may hold one of the nearest triangles, without the rounding errors of single
  /// precision.
  [[gnu::noinline]] bool reaches(const Node& node, int lane) const {
    const NodePoint p(node, q_, upper_ + slack_);
    if (!p.reachesBox(lane)) return false;
    const ChildHulls* const hulls = hullsOf(node);
    return hulls == nullptr || p.reachesHull(*hulls, lane);
  }
  CUTWATER_INLINE void note(std::uint32_t id, float lower) {
    if (count_ == kMost) {
      narrow();
      if (count_ > kMost / 2) evaluate();
    }
    ids_[count_] = id;
    lowers_[count_] = lower;
    ++count_;
  }
  /// Discards candidates whose lower bounds are now too large.
  CUTWATER_INLINE void drop() {
    const auto reach = static_cast<float>((upper_ + slack_) * (1 + 0x1p-20));
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      ids_[kept] = ids_[i];
      lowers_[kept] = lowers_[i];
      kept += lowers_[i] <= reach ? 1 : 0;
    }
    count_ = kept;
  }

  /// Discards candidates that full precision shows to be beyond the nearest, and tightens the upper
  /// bound with the rest. From then on nodes and leaves are tested in double precision before they
  /// are opened.
  [[gnu::noinline]] void narrow() {
    drop();
    int places[kMost];
    count_ = Competition<T>(surface_, *p_).narrow(ids_, count_, *best_, places);
    for (int i = 0; i < count_; ++i) {
      ids_[i] = ids_[places[i]];
      lowers_[i] = lowers_[places[i]];
    }
    const double upper = __builtin_sqrt(double{best_->tie}) * tree_.frame.scale * (1 + 0x1p-40);
    if (upper < upper_) {
      upper_ = upper;
      setLimit();
    }
    isCrowded_ = true;
  }

  static constexpr int kMost = Competition<T>::kMost;
  static constexpr int kCrowd = 12;  // more are narrowed at once where slivers abound

  const TriangleSearch& tree_;
  const KernelTriangles<T>& surface_;
  [[no_unique_address]] Observer observer_;
  const Vec3<T>* p_ = nullptr;
  typename TriangleSurface<T>::Nearest* best_ = nullptr;
  Vec3<double> q_;    // in the tree's frame, like all lengths below
  double upper_ = 0;  // upper bound on the distance to the nearest triangle
  double slack_ = 0;
  float limit_ = kFar;  // of keys
  int count_ = 0;       // number of candidates: those that may be the nearest, with lower bounds
  std::uint32_t ids_[kMost];
  float lowers_[kMost];
  bool isCrowded_ = false;  // more are near than single precision can distinguish
  bool isLeaf_ = false;     // whether the target is a leaf
  std::uint32_t target_ = 0;
  int depth_ = 0;
  Level path_[TriangleTree::kMaxDepth];
};

template <typename T, typename Observer = NoObserver>
CUTWATER_INLINE inline void nearestOne(const TriangleSearch& tree,
                                       const KernelTriangles<T>& surface, const Vec3<T>& p,
                                       typename TriangleSurface<T>::Nearest& best,
                                       double reach = TriangleSearch::kAnywhere,
                                       Observer observer = {}) {
  Search<T, Observer> search(tree, surface, observer);
  search.start(p, best, reach);
  while (search.step()) {
    if (!tree.isSmall) search.prefetchSecond();
  }
  search.evaluate();
}

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
