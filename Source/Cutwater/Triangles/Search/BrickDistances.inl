#pragma once

// Distances from a few neighbouring points to the triangles they share. Compiled once per
// instruction set.

#include <Cutwater/Triangles/Search/CandidateList.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Triangles with precomputed terms that their distances from many points need.
template <int kMost>
class PreparedTriangles {
 public:
  CUTWATER_INLINE void prepare(const CandidateList<kMost>& list) {
    for (int i = 0; i < list.count(); i += kFloats) {
      const auto t = list.triangles(i);
      const Floats3 bc = t.ac - t.ab;
      const Floats3 ca{-t.ac.x, -t.ac.y, -t.ac.z};
      put(0, i, t.a);
      put(3, i, t.ab);
      put(6, i, t.ac);
      put(9, i, t.normal);
      put(12, i, fusedCross(t.normal, t.ab));
      put(15, i, fusedCross(t.normal, bc));
      put(18, i, fusedCross(t.normal, ca));
      put(21, i, {inverse(t.ab), inverse(bc), inverse(t.ac)});
      put(24, i, {sizeOf(t.ab), sizeOf(bc), sizeOf(ca)});
    }
  }
  /// Squared distances to triangle `i`, as by packedOffset() and with the same error. `margin` is
  /// kSideError units of each point.
  CUTWATER_INLINE Floats squaredDistances(int i, const Floats3& p, Floats margin) const {
    const Floats3 v = p - three(0, i);
    const Floats3 ab = three(3, i);
    const Floats3 ac = three(6, i);
    const Floats3 vb = v - ab;
    const Floats edges = least(least(toEdge(v, ab, one(21, i)), toEdge(v, ac, one(23, i))),
                               toEdge(vb, ac - ab, one(22, i)));
    const Floats inside = least(least(fusedDot(three(12, i), v) - margin * one(24, i),
                                      fusedDot(three(15, i), vb) - margin * one(25, i)),
                                fusedDot(three(18, i), v) - margin * one(26, i));
    const Floats height = fusedDot(v, three(9, i));
    return where(isPositive(inside), least(height * height, edges), edges);
  }

 private:
  CUTWATER_INLINE void put(int row, int i, const Floats3& v) {
    store(rows_[row] + i, v.x);
    store(rows_[row + 1] + i, v.y);
    store(rows_[row + 2] + i, v.z);
  }
  CUTWATER_INLINE Floats one(int row, int i) const { return broadcast(rows_[row][i]); }
  CUTWATER_INLINE Floats3 three(int row, int i) const {
    return {one(row, i), one(row + 1, i), one(row + 2, i)};
  }
  /// Inverse of the squared length; 0 without length.
  CUTWATER_INLINE static Floats inverse(const Floats3& edge) {
    const Floats squared = fusedDot(edge, edge);
    const auto hasLength = isPositive(squared - broadcast(0x1p-100F));
    return where(hasLength, broadcast(1.0F), broadcast(0.0F)) /
           where(hasLength, squared, broadcast(1.0F));
  }
  /// The squared distance to an edge.
  CUTWATER_INLINE static Floats toEdge(const Floats3& v, const Floats3& edge, Floats inverse) {
    const Floats3 rest = offEdge(v, edge, fusedDot(edge, v) * inverse);
    return fusedDot(rest, rest);
  }

  alignas(64) float rows_[27][kMost];
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
