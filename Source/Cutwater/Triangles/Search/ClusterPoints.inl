#pragma once

// Neighbouring points whose nearest triangles are searched together. Compiled once per instruction
// set.

#include <Cutwater/Triangles/Search/LeafList.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Some points, relative to their middle; all lengths are in the tree's frame. Consecutive points
/// form groups, which are divided into bricks.
template <typename T>
class ClusterPoints {
 public:
  static constexpr int kMost = 256;
  static constexpr int kGroup = 64;
  static constexpr int kBrick = 16;
  using Nearest = typename TriangleSurface<T>::Nearest;

  CUTWATER_INLINE ClusterPoints(const TriangleSearch& tree, const KernelTriangles<T>& arrays)
      : tree_(tree), arrays_(arrays) {}

  /// Returns false if the points are too far away for single precision.
  CUTWATER_INLINE bool place(const Vec3<T>* points, Nearest* bests, int count) {
    points_ = points;
    bests_ = bests;
    count_ = count;
    Vec3<double> lower = tree_.frame.toFrame(Vec3<double>(points_[0]));
    Vec3<double> upper = lower;
    error_ = 0;
    for (int i = 0; i < count_; ++i) {
      const Vec3<double> q = tree_.frame.toFrame(Vec3<double>(points_[i]));
      lower = min(lower, q);
      upper = max(upper, q);
      error_ = bests_[i].error > error_ ? bests_[i].error : error_;
    }
    const double size = maxComponent(max(abs(lower), abs(upper)));
    if (size > kFarAway) return false;
    origin_ = 0.5 * (lower + upper);
    slack_ =
        static_cast<float>((slackOf(double{error_}, size, tree_.frame) + 0x1p-60) * (1 + 0x1p-20));
    const int padded = (count_ + kBrick - 1) / kBrick * kBrick;
    for (int i = 0; i < padded; ++i) {
      const Vec3<T>& p = points_[i < count_ ? i : count_ - 1];
      const Vec3<float> q(tree_.frame.toFrame(Vec3<double>(p)) - origin_);
      x_[i] = q.x;
      y_[i] = q.y;
      z_[i] = q.z;
    }
    reach_ = static_cast<float>(1.5 * maxComponent(upper - lower)) * (1 + 0x1p-20F);
    limit_ = kFar;
    return true;
  }
  /// From now on, only triangles within this distance of a point matter to it, in the surface's
  /// units.
  CUTWATER_INLINE void limit(double distance) {
    const double most = distance * tree_.frame.scale * (1 + 0x1p-20);
    limit_ = most < kFar ? static_cast<float>(most) + slack_ : kFar;
  }

  /// The box around points [begin, end); `begin` must be a multiple of kBrick.
  CUTWATER_INLINE ClusterBox boxAround(int begin, int end) const {
    ClusterBox box;
    const float* const coordinates[3] = {x_, y_, z_};
    for (int axis = 0; axis < 3; ++axis) {
      Floats lower = load(coordinates[axis] + begin);
      Floats upper = lower;
      for (int i = begin; i < end; i += kFloats) {
        lower = least(lower, load(coordinates[axis] + i));
        upper = most(upper, load(coordinates[axis] + i));
      }
      const float first = leastOf(lower);
      const float last = -leastOf(broadcast(0.0F) - upper);
      box.middle[axis] = 0.5F * (first + last);
      // The middle and the extent are rounded.
      const float size = (first < 0 ? -first : first) + (last < 0 ? -last : last);
      box.half[axis] = 0.5F * (last - first) + 0x1p-22F * size;
    }
    return box;
  }

  CUTWATER_INLINE const Vec3<T>& point(int i) const { return points_[i]; }
  CUTWATER_INLINE Nearest& best(int i) const { return bests_[i]; }
  CUTWATER_INLINE Vec3<float> position(int i) const { return {x_[i], y_[i], z_[i]}; }
  CUTWATER_INLINE Floats3 positions(int first) const {
    return {load(x_ + first), load(y_ + first), load(z_ + first)};
  }
  CUTWATER_INLINE const Vec3<double>& origin() const { return origin_; }
  CUTWATER_INLINE Vec3<double> middle(const ClusterBox& box) const {
    return origin_ + Vec3<double>(box.middle);
  }
  /// All points are within this distance of the origin, in the sum of absolute components.
  CUTWATER_INLINE float reach() const { return reach_; }
  /// The largest of slackOf() for the points.
  CUTWATER_INLINE float slack() const { return slack_; }
  /// No triangle farther than this from a point matters to it.
  CUTWATER_INLINE float limit() const { return limit_; }
  /// The largest Nearest::error of the points, and so of any point among them.
  CUTWATER_INLINE T error() const { return error_; }

  /// Bounds for triangles and boxes with a nearest point for the box, if `near` is a point of the
  /// surface.
  CUTWATER_INLINE ClusterBounds boundsFor(const ClusterBox& box, const Vec3<double>& near) const {
    return boundsBy(box, Vec3<float>(middle(box) - near), 0);
  }
  /// The same if `off` is the box's middle less a point that is within `error` of the surface.
  CUTWATER_INLINE ClusterBounds boundsBy(const ClusterBox& box, const Vec3<float>& off,
                                         float error) const {
    ClusterBounds bounds(box.half, off, slack_ + error + roundingIn(box));
    bounds.limit(limit_ + roundingIn(box));
    return bounds;
  }
  /// Bounds for triangles and boxes that matter to the box.
  CUTWATER_INLINE ClusterBounds boundsFor(const ClusterBox& box) const {
    ClusterBounds bounds(box.half);
    bounds.limit(limit_ + roundingIn(box));
    return bounds;
  }
  /// The point of a triangle that is nearest to `p`.
  CUTWATER_INLINE Vec3<double> closestTo(const Vec3<T>& p, std::uint32_t triangle) const {
    const std::uint32_t id = triangle == kNone ? 0 : triangle;
    return tree_.frame.toFrame(Vec3<double>(arrays_.closestPoint(id, p)));
  }

 private:
  // Beyond this the rounding is too coarse, so points are searched one by one.
  static constexpr double kFarAway = 0x1p20;

  /// The points, the box's middle and its difference from other points are rounded to float.
  CUTWATER_INLINE float roundingIn(const ClusterBox& box) const {
    return 0x1p-22F * (box.half.x + box.half.y + box.half.z + reach_);
  }

  const TriangleSearch& tree_;
  const KernelTriangles<T>& arrays_;
  const Vec3<T>* points_ = nullptr;
  Nearest* bests_ = nullptr;
  int count_ = 0;
  Vec3<double> origin_;
  T error_ = 0;
  float slack_ = 0;
  float reach_ = 0;
  float limit_ = kFar;
  alignas(64) float x_[kMost];
  alignas(64) float y_[kMost];
  alignas(64) float z_[kMost];
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
