#pragma once

// TriangleSurface::compete() for several triangles at a time: the same bits. Compiled once per
// instruction set.

#include <Cutwater/Mesh/ExactPredicates.hpp>
#include <Cutwater/Mesh/TriangleDistance.inl>
#include <Cutwater/Mesh/TriangleSearch.hpp>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// As many triangles as a vector has lanes, and for each a point.
template <typename T>
class TriangleLanes {
 public:
  static constexpr int kCount = kLanesOf<T>;
  using Nearest = typename TriangleSurface<T>::Nearest;

  CUTWATER_INLINE explicit TriangleLanes(const TriangleArrays<T>& arrays) : arrays_(arrays) {}

  /// All lanes alike.
  CUTWATER_INLINE void setAll(std::uint32_t id, const Vec3<T>& p) {
    const std::uint32_t* const corners = arrays_.corners + 3 * std::size_t{id};
    setAllRows(0, p);
    for (int i = 0; i < 3; ++i) setAllRows(3 + 3 * i, arrays_.positions[corners[i]]);
    for (int lane = 0; lane < kCount; ++lane) ids_[lane] = id;
    slivers_ = isSliver(id) ? (1U << kCount) - 1U : 0U;
  }
  CUTWATER_INLINE void set(int lane, std::uint32_t id, const Vec3<T>& p) {
    const std::uint32_t* const corners = arrays_.corners + 3 * std::size_t{id};
    ids_[lane] = id;
    setRows(0, lane, p);
    for (int i = 0; i < 3; ++i) setRows(3 + 3 * i, lane, arrays_.positions[corners[i]]);
    slivers_ = (slivers_ & ~(1U << lane)) | (isSliver(id) ? 1U << lane : 0U);
  }
  /// Computes squared distances, and on which sides of the triangles the points lie.
  CUTWATER_INLINE void evaluate() {
    const auto all = distances<T>(rows(0), rows(3), rows(6), rows(9));
    const auto edges = least(least(all.ab.squared, all.bc.squared), all.ca.squared);
    store(squared_, least(edges, all.plane));
    if (slivers_ != 0) {
      store(edges_, edges);
      store(normalSquared_, all.normalSquared);
    }
    store(side_, all.side);
  }
  /// The least squared distance of all lanes, but for the planes of slivers: not less than that of
  /// the nearest.
  CUTWATER_INLINE T leastSquared() const {
    return slivers_ == 0 ? leastOf(load(squared_)) : leastOf(load(edges_));
  }
  /// A bit for every lane that may have a squared distance up to the limit; slivers always.
  CUTWATER_INLINE std::uint32_t within(T limit) const {
    return bits(isAtMost(load(squared_), broadcast(limit))) | slivers_;
  }
  CUTWATER_INLINE void offer(int lane, Nearest& best) const {
    T squared = squared_[lane];
    if ((slivers_ >> lane & 1U) != 0) {
      if (isBeyond(lane, best)) return;
      squared = triangleDistance(point(0, lane), triangle(lane)).distanceSquared;
    }
    if (squared > best.tie) return;
    best.offer(squared, ids_[lane], side(lane));
  }

 private:
  CUTWATER_INLINE bool isSliver(std::uint32_t id) const {
    return (arrays_.slivers[id / 32] >> id % 32 & 1U) != 0;
  }
  CUTWATER_INLINE void setRows(int row, int lane, const Vec3<T>& v) {
    rows_[row][lane] = v.x;
    rows_[row + 1][lane] = v.y;
    rows_[row + 2][lane] = v.z;
  }
  CUTWATER_INLINE void setAllRows(int row, const Vec3<T>& v) {
    store(rows_[row], broadcast(v.x));
    store(rows_[row + 1], broadcast(v.y));
    store(rows_[row + 2], broadcast(v.z));
  }
  CUTWATER_INLINE Triple<Lanes<T>> rows(int row) const {
    return {load(rows_[row]), load(rows_[row + 1]), load(rows_[row + 2])};
  }
  CUTWATER_INLINE Vec3<T> point(int row, int lane) const {
    return {rows_[row][lane], rows_[row + 1][lane], rows_[row + 2][lane]};
  }
  CUTWATER_INLINE Triangle<T> triangle(int lane) const {
    return {point(3, lane), point(6, lane), point(9, lane), true};
  }
  /// Whether a sliver is certainly farther than `best.tie`.
  ///
  /// Where its plane is nearer than its edges, the projection is inside and at most the inradius
  /// from an edge: 2 A / perimeter <= |n| / 2 L, with L the longest edge and |n| = 2 A, computed to
  /// 32 eps L^2.
  CUTWATER_INLINE bool isBeyond(int lane, const Nearest& best) const {
    constexpr T kRounding = 32 * std::numeric_limits<T>::epsilon();
    const auto t = triangle(lane);
    const T longest =
        largest(lengthSquared(t.b - t.a), lengthSquared(t.c - t.b), lengthSquared(t.a - t.c));
    const T height = squareRoot(normalSquared_[lane]) + kRounding * longest;
    const T edges = squareRoot(edges_[lane]) - best.error;
    const T reach = squareRoot(best.tie) + best.error;
    // Of a point without extent nothing but the edges counts; then this says no.
    return edges > 0 && (edges * edges - reach * reach) * longest * 4 > height * height * T(1.001);
  }
  CUTWATER_INLINE static T largest(T a, T b, T c) {
    return a > b ? (a > c ? a : c) : b > c ? b : c;
  }
  CUTWATER_INLINE int side(int lane) const {
    if (side_[lane] != 0) return side_[lane] > 0 ? 1 : -1;
    return orientation(Vec3<double>(point(3, lane)), Vec3<double>(point(6, lane)),
                       Vec3<double>(point(9, lane)), Vec3<double>(point(0, lane)));
  }

  const TriangleArrays<T>& arrays_;
  alignas(64) T rows_[12][kCount];  // p, a, b, c
  alignas(64) T squared_[kCount];
  alignas(64) T edges_[kCount];  // these two for slivers
  alignas(64) T normalSquared_[kCount];
  alignas(64) T side_[kCount];  // 0: not certain
  std::uint32_t ids_[kCount];
  std::uint32_t slivers_ = 0;
};

/// Lets triangles compete for one point.
template <typename T>
CUTWATER_INLINE inline void compete(const TriangleArrays<T>& arrays, const Vec3<T>& p,
                                    const std::uint32_t* ids, int count,
                                    typename TriangleSurface<T>::Nearest& best) {
  constexpr int kCount = TriangleLanes<T>::kCount;
  TriangleLanes<T> lanes(arrays);
  for (int begin = 0; begin < count; begin += kCount) {
    const int used = count - begin < kCount ? count - begin : kCount;
    lanes.setAll(ids[begin], p);
    for (int lane = 1; lane < used; ++lane) lanes.set(lane, ids[begin + lane], p);
    lanes.evaluate();
    const T tie = best.tieAt(lanes.leastSquared());
    std::uint32_t near = lanes.within(tie < best.tie ? tie : best.tie);
    for (near &= (1U << used) - 1U; near != 0; near &= near - 1) {
      lanes.offer(__builtin_ctz(near), best);
    }
  }
}

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
