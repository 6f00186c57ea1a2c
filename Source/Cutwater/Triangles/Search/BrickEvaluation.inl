#pragma once

// The full evaluation of the candidates of a few neighbouring points, which share most of them.
// Compiled once per instruction set.

#include <Cutwater/Triangles/Search/ClusterPoints.inl>
#include <Cutwater/Triangles/Search/TriangleCompetition.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Computes the same as TriangleSurface::compete(), bit for bit, for the points of a brick.
template <typename T>
class BrickEvaluation {
 public:
  using Points = ClusterPoints<T>;
  using Nearest = typename Points::Nearest;
  static constexpr int kBrick = Points::kBrick;
  static constexpr int kMost = 160;  ///< most candidates

  CUTWATER_INLINE BrickEvaluation(const KernelTriangles<T>& arrays, const Points& points)
      : arrays_(arrays), points_(points) {}

  /// Starts with points [first, first + used); the rest of the brick repeats the last.
  CUTWATER_INLINE void begin(int first, int used) {
    first_ = first;
    used_ = used;
    count_ = 0;
    for (int i = 0; i < kBrick; ++i) {
      const Vec3<T>& p = points_.point(first + (i < used ? i : used - 1));
      x_[i] = p.x;
      y_[i] = p.y;
      z_[i] = p.z;
    }
  }
  /// Adds a candidate of the points whose bits are set.
  CUTWATER_INLINE void add(std::uint32_t id, std::uint32_t points) {
    int at = count_++;
    // Sorted by id: of equal distances, the first wins.
    for (; at > 0 && ids_[at - 1] > id; --at) {
      ids_[at] = ids_[at - 1];
      wanted_[at] = wanted_[at - 1];
    }
    ids_[at] = id;
    wanted_[at] = points;
  }
  CUTWATER_INLINE void finish() {
    for (int i = 0; i < kBrick; i += kLanes) {
      store(nearest_ + i, broadcast(kNone));
      store(winner_ + i, broadcast(T(0)));
    }
    for (int n = 0; n < count_; ++n) evaluate(n);
    for (int i = 0; i < kBrick; ++i) tie_[i] = 0;
    for (int i = 0; i < used_; ++i) {
      tie_[i] = -1;
      if (!(nearest_[i] < kNone)) continue;
      Nearest& best = points_.best(first_ + i);
      best.distanceSquared = nearest_[i];
      best.triangle = ids_[static_cast<int>(winner_[i])];
      tie_[i] = best.tie = best.tieAt(nearest_[i]);
    }
    findSides();
  }

 private:
  static constexpr int kLanes = kLanesOf<T>;
  static constexpr T kNone = std::numeric_limits<T>::max();  // instead of a distance

  CUTWATER_INLINE Triple<Lanes<T>> positions(int i) const {
    return {load(x_ + i), load(y_ + i), load(z_ + i)};
  }
  CUTWATER_INLINE static Triple<Lanes<T>> broadcastOf(const Vec3<T>& v) {
    return {broadcast(v.x), broadcast(v.y), broadcast(v.z)};
  }
  CUTWATER_INLINE void evaluate(int n) {
    const Triangle<T> t = arrays_.triangle(ids_[n]);
    const auto a = broadcastOf(t.a);
    const auto b = broadcastOf(t.b);
    const auto c = broadcastOf(t.c);
    behind_[n] = 0;
    before_[n] = 0;
    for (int i = 0; i < kBrick; i += kLanes) {
      const std::uint32_t wanted = wanted_[n] >> i & ((1U << kLanes) - 1U);
      auto squared = broadcast(kNone);
      if (wanted != 0) {
        const auto all = distances<T>(positions(i), a, b, c);
        squared = least(all.edges(), all.plane);
        before_[n] |= bits(isPositive(all.side)) << i;
        behind_[n] |= bits(isPositive(broadcast(T(0)) - all.side)) << i;
      }
      store(squared_[n] + i, squared);
      if (wanted == 0) continue;
      if (t.sliver) squared = sliverDistances(n, i, wanted, t);
      const auto nearest = load(nearest_ + i);
      const auto isNearer = isPositive(nearest - squared);
      store(nearest_ + i, least(squared, nearest));
      store(winner_ + i, where(isNearer, broadcast(static_cast<T>(n)), load(winner_ + i)));
    }
  }
  CUTWATER_INLINE Lanes<T> sliverDistances(int n, int first, std::uint32_t wanted,
                                           const Triangle<T>& t) {
    for (int i = first; i < first + kLanes; ++i, wanted >>= 1U) {
      squared_[n][i] = (wanted & 1U) != 0
                           ? triangleDistance(Vec3<T>{x_[i], y_[i], z_[i]}, t).distanceSquared
                           : kNone;
    }
    return load(squared_[n] + first);
  }

  /// Determines on which sides of the triangles that tie with the nearest ones the points lie.
  CUTWATER_INLINE void findSides() {
    std::uint32_t behind = 0;
    std::uint32_t before = 0;
    std::uint32_t uncertain = 0;
    for (int n = 0; n < count_; ++n) {
      std::uint32_t ties = 0;
      for (int i = 0; i < kBrick; i += kLanes) {
        ties |= bits(isAtMost(load(squared_[n] + i), load(tie_ + i))) << i;
      }
      behind |= ties & behind_[n];
      before |= ties & before_[n];
      uncertain |= ties & ~(behind_[n] | before_[n]);
    }
    for (int i = 0; i < used_; ++i) {
      Nearest& best = points_.best(first_ + i);
      if ((behind >> i & 1U) != 0) best.behind = best.distanceSquared;
      if ((before >> i & 1U) != 0) best.before = best.distanceSquared;
      if ((uncertain >> i & 1U) != 0) findSidesOf(i);
    }
  }
  CUTWATER_INLINE void findSidesOf(int i) {
    Nearest& best = points_.best(first_ + i);
    for (int n = 0; n < count_; ++n) {
      if (squared_[n][i] > best.tie) continue;
      const Triangle<T> t = arrays_.triangle(ids_[n]);
      best.noteSide(squared_[n][i],
                    orientation(Vec3<double>(t.a), Vec3<double>(t.b), Vec3<double>(t.c),
                                Vec3<double>(Vec3<T>{x_[i], y_[i], z_[i]})));
    }
  }

  const KernelTriangles<T>& arrays_;
  const Points& points_;
  int first_ = 0;
  int used_ = 0;
  int count_ = 0;
  std::uint32_t ids_[kMost];
  std::uint32_t wanted_[kMost];  // bit mask of points
  std::uint32_t behind_[kMost];  // points certainly behind; the rest is in front or uncertain
  std::uint32_t before_[kMost];
  alignas(64) T x_[kBrick];
  alignas(64) T y_[kBrick];
  alignas(64) T z_[kBrick];
  alignas(64) T nearest_[kBrick];
  alignas(64) T tie_[kBrick];
  alignas(64) T winner_[kBrick];  // an index into ids_
  alignas(64) T squared_[kMost][kBrick];
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
