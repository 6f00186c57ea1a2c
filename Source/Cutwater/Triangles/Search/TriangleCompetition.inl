#pragma once

// TriangleSurface::compete() for many triangles at once, with bitwise equal results. Compiled once
// per instruction set.

#include <Cutwater/Triangles/ExactPredicates.hpp>
#include <Cutwater/Triangles/Search/TriangleDistance.inl>
#include <Cutwater/Triangles/Search/TriangleSearch.hpp>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Triangles that compete to be the nearest to a point.
template <typename T>
class Competition {
 public:
  static constexpr int kMost = 48;
  using Nearest = typename TriangleSurface<T>::Nearest;

  CUTWATER_INLINE Competition(const KernelTriangles<T>& arrays, const Vec3<T>& p)
      : arrays_(arrays), p_(p) {}

  CUTWATER_INLINE void run(const std::uint32_t* ids, int count, Nearest& best) {
    const T tie = bound(ids, count, best);
    const auto compete = [&](int i) __attribute__((always_inline)) {
      offer(i, ids[i], best);
    };
    forNear(count, tie, best.error, compete);
  }
  /// Writes the places of the triangles that can still win or tie, and returns how many. None is
  /// evaluated with more than the precision of T. `best.tie` becomes their bound on it.
  CUTWATER_INLINE int narrow(const std::uint32_t* ids, int count, Nearest& best, int* places) {
    best.tie = bound(ids, count, best);
    int kept = 0;
    const auto keep = [&](int i) __attribute__((always_inline)) {
      places[kept++] = i;
    };
    forNear(count, best.tie, best.error, keep);
    return kept;
  }

 private:
  static constexpr int kLanes = kLanesOf<T>;

  /// Returns an upper bound on the winner: no winner is farther than the nearest so far.
  CUTWATER_INLINE T bound(const std::uint32_t* ids, int count, const Nearest& best) {
    auto nearest = broadcast(std::numeric_limits<T>::infinity());
    for (int first = 0; first < count; first += kLanes) {
      setAll(first, ids[first]);
      for (int i = first + 1; i < first + kLanes && i < count; ++i) set(i, ids[i]);
      evaluate(first);
      nearest = least(nearest, load(squared_ + first));
    }
    const T tie = best.tieAt(leastOf(nearest));
    return tie < best.tie ? tie : best.tie;
  }
  /// Calls visit(i) for triangles whose squared distance may be at most the limit.
  template <typename Visit>
  CUTWATER_INLINE void forNear(int count, T limit, T error, const Visit& visit) const {
    for (int first = 0; first < count; first += kLanes) {
      std::uint32_t near = within(first, limit, error);
      if (count - first < kLanes) near &= (1U << (count - first)) - 1U;
      for (; near != 0; near &= near - 1) visit(first + __builtin_ctz(near));
    }
  }

  CUTWATER_INLINE void set(int i, std::uint32_t id) {
    const Triangle<T> t = arrays_.triangle(id);
    const T values[9] = {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z};
    for (int row = 0; row < 9; ++row) rows_[row][i] = values[row];
    isSliver_[i] = t.sliver;
    hasSlivers_ = hasSlivers_ || t.sliver;
  }
  /// Sets all lanes of a vector to the same triangle.
  CUTWATER_INLINE void setAll(int first, std::uint32_t id) {
    const Triangle<T> t = arrays_.triangle(id);
    const T values[9] = {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z};
    for (int row = 0; row < 9; ++row) store(rows_[row] + first, broadcast(values[row]));
    for (int i = first; i < first + kLanes; ++i) isSliver_[i] = t.sliver;
    hasSlivers_ = hasSlivers_ || t.sliver;
  }
  CUTWATER_INLINE Triple<Lanes<T>> corner(int row, int first) const {
    return {load(rows_[row] + first), load(rows_[row + 1] + first), load(rows_[row + 2] + first)};
  }
  CUTWATER_INLINE Triangle<T> triangle(int i) const {
    return {{rows_[0][i], rows_[1][i], rows_[2][i]},
            {rows_[3][i], rows_[4][i], rows_[5][i]},
            {rows_[6][i], rows_[7][i], rows_[8][i]},
            isSliver_[i]};
  }

  CUTWATER_INLINE void evaluate(int first) {
    const auto zero = broadcast(T(0));
    const auto all = distances<T>({broadcast(p_.x), broadcast(p_.y), broadcast(p_.z)},
                                  corner(0, first), corner(3, first), corner(6, first));
    const auto edges = all.edges();
    store(squared_ + first, least(edges, all.plane));
    store(side_ + first, all.side);
    store(reach_ + first, zero);
    if (!hasSlivers_) return;
    // Where a sliver's plane is nearer than its edges, the projection is inside and at most the
    // inradius from an edge: 2 A / perimeter <= |n| / 2 L, with L the longest edge and |n| = 2 A as
    // computed to 32 eps L^2. Its square is at most half of (|n|^2 + (32 eps L^2)^2) / L^2.
    constexpr T kRounding = 32 * std::numeric_limits<T>::epsilon();
    const auto longest = most(all.longestSquared, broadcast(std::numeric_limits<T>::min()));
    alignas(64) T reach[kLanes];
    alignas(64) T squared[kLanes];
    store(reach, broadcast(T(0.51)) *
                     (all.normalSquared / longest + broadcast(kRounding * kRounding) * longest));
    store(squared, edges);
    for (int i = 0; i < kLanes; ++i) {
      if (!isSliver_[first + i]) continue;
      squared_[first + i] = squared[i];
      reach_[first + i] = reach[i];
    }
  }
  /// Bit mask of the lanes whose squared distance may be at most the limit.
  ///
  /// With s the distance to a sliver's edges, r that of the limit and e the error of both, the
  /// sliver is farther if (s - e)^2 - reach > (r + e)^2; and 2 s e <= (s^2 / (r + e) + (r + e)) e.
  CUTWATER_INLINE std::uint32_t within(int first, T limit, T error) const {
    if (!hasSlivers_) {
      return bits(isAtMost(load(squared_ + first), broadcast(limit)));
    }
    const T r = squareRoot(limit) + error;
    const auto lower = load(squared_ + first) * broadcast(1 - error / r) - load(reach_ + first);
    return bits(isAtMost(lower, broadcast(r * r + r * error)));
  }

  CUTWATER_INLINE void offer(int i, std::uint32_t id, Nearest& best) const {
    const T squared =
        isSliver_[i] ? triangleDistance(p_, triangle(i)).distanceSquared : squared_[i];
    if (!(squared > best.tie)) best.offer(squared, id, side(i));
  }
  CUTWATER_INLINE int side(int i) const {
    if (side_[i] != 0) return side_[i] > 0 ? 1 : -1;
    const Triangle<T> t = triangle(i);
    return orientation(Vec3<double>(t.a), Vec3<double>(t.b), Vec3<double>(t.c), Vec3<double>(p_));
  }

  const KernelTriangles<T>& arrays_;
  const Vec3<T>& p_;
  alignas(64) T rows_[9][kMost];  // a, b, c
  alignas(64) T squared_[kMost];  // to the edges, for slivers
  alignas(64) T reach_[kMost];    // how much smaller a sliver's squared distance may be
  alignas(64) T side_[kMost];     // 0: uncertain
  bool isSliver_[kMost];
  bool hasSlivers_ = false;  // so far
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
