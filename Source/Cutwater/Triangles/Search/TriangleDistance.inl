#pragma once

// The squared distance to a triangle. One source serves scalars and vector lanes, with bitwise
// equal results. Compiled once per instruction set, and for scalars by TriangleDistance.cpp.

#include <Cutwater/Simd/Lanes.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

template <typename T>
struct EdgeDistance {
  Lanes<T> squared;
  Lanes<T> inner;     ///< positive if the closest point is not an end
  MaskOf<T> isFirst;  ///< whether the first end is nearer
};

/// The squared distance to an edge, from the point relative to its two ends.
///
/// Symmetric in the ends, except for exact ties, so that both triangles at an edge compute the same
/// bits.
template <typename T>
CUTWATER_INLINE inline EdgeDistance<T> edgeDistance(const Triple<Lanes<T>>& fromFirst,
                                                    const Triple<Lanes<T>>& fromSecond,
                                                    const Triple<Lanes<T>>& edge) {
  const auto zero = broadcast(T(0));
  const auto along = dot(edge, fromFirst);
  const auto back = zero - dot(edge, fromSecond);
  const auto inner = least(along, back);
  const auto isFirst = isAtMost(along, back);
  const auto isInner = isPositive(inner);
  const auto place = where(isInner, inner, zero) / where(isInner, dot(edge, edge), broadcast(T(1)));
  // From the nearer end: the part along the edge is removed from the shorter vector.
  const auto weight = where(isFirst, zero - place, place);
  const auto rejected = where(isFirst, fromFirst, fromSecond) + weight * edge;
  return {dot(rejected, rejected), inner, isFirst};
}

/// A point and a triangle, given by their differences, in any arithmetic.
template <typename Vector>
struct SeenTriangle {
  Vector pa, pb, pc;  ///< p - a, ...
  Vector ab, bc, ca;  ///< b - a, ...
};

/// The terms that determine the distance to a triangle's plane. It is |height| / |normal|, and
/// counts if the projection lies strictly inside, where all three sides are positive.
template <typename Scalar>
struct PlaneTerms {
  Scalar sideAB, sideBC, sideCA;
  Scalar normalSquared;  ///< square of twice the area
  Scalar height;
};

/// `from` is the point relative to the corner nearest to it, so that the height loses the fewest
/// digits.
template <typename Vector>
CUTWATER_INLINE inline auto planeTerms(const SeenTriangle<Vector>& t, const Vector& from) {
  const Vector normal = cross(t.ca, t.ab);
  // The directions from the edges into the triangle do not depend on the point.
  return PlaneTerms<decltype(dot(normal, normal))>{
      dot(cross(normal, t.ab), t.pa), dot(cross(normal, t.bc), t.pb),
      dot(cross(normal, t.ca), t.pc), dot(normal, normal), dot(normal, from)};
}

/// Below this, squares of areas underflow; the triangle's edges are then as near as its plane.
template <typename T>
constexpr T kLeastNormalSquared = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();

/// Infinite where the projection is not inside.
template <typename T>
CUTWATER_INLINE inline Lanes<T> planeDistance(const PlaneTerms<Lanes<T>>& terms) {
  const auto side = least(least(terms.sideAB, terms.sideBC), terms.sideCA);
  const auto counts =
      both(isPositive(side), isPositive(terms.normalSquared - broadcast(kLeastNormalSquared<T>)));
  // Not the squared height over the divisor, which would underflow before the quotient does.
  const auto divisor = where(counts, terms.normalSquared, broadcast(T(1)));
  return where(counts, terms.height / divisor * terms.height,
               broadcast(std::numeric_limits<T>::infinity()));
}

template <typename T>
struct TriangleDistances {
  EdgeDistance<T> ab, bc, ca;
  Lanes<T> plane;  ///< infinite where it does not count; unused for slivers
  Lanes<T> normalSquared;
  Lanes<T> longestSquared;  ///< edge
  Lanes<T> side;            ///< has the sign of orientation(), or is 0 where that is uncertain

  [[nodiscard]] CUTWATER_INLINE Lanes<T> edges() const {
    return least(least(ab.squared, bc.squared), ca.squared);
  }
};

template <typename T>
CUTWATER_INLINE inline TriangleDistances<T> distances(const Triple<Lanes<T>>& p,
                                                      const Triple<Lanes<T>>& a,
                                                      const Triple<Lanes<T>>& b,
                                                      const Triple<Lanes<T>>& c) {
  const SeenTriangle<Triple<Lanes<T>>> t{p - a, p - b, p - c, b - a, c - b, a - c};
  const auto toA = dot(t.pa, t.pa);
  const auto toB = dot(t.pb, t.pb);
  const auto toC = dot(t.pc, t.pc);
  const auto nearest = where(both(isAtMost(toA, toB), isAtMost(toA, toC)), t.pa,
                             where(isAtMost(toB, toC), t.pb, t.pc));
  const auto terms = planeTerms(t, nearest);
  // With u half the epsilon: the normal's components are within 4 u of the products of the absolute
  // edge components, which the differences, products and sums of the height increase to at most 9
  // u. Underflow, and what orientation() drops from exact products, are far below the rest.
  constexpr T kRounding = 8 * std::numeric_limits<T>::epsilon();
  constexpr T kTiny = sizeof(T) == sizeof(float) ? T(0x1p-100) : T(0x1p-200);
  const auto bound =
      (broadcast(kRounding) * (sizeOf(t.ca) * sizeOf(t.ab)) + broadcast(kTiny)) * sizeOf(nearest) +
      broadcast(kTiny);
  const auto isCertain = isPositive(magnitude(terms.height) - bound);
  return {edgeDistance<T>(t.pa, t.pb, t.ab),
          edgeDistance<T>(t.pb, t.pc, t.bc),
          edgeDistance<T>(t.pc, t.pa, t.ca),
          planeDistance<T>(terms),
          terms.normalSquared,
          most(most(dot(t.ab, t.ab), dot(t.bc, t.bc)), dot(t.ca, t.ca)),
          where(isCertain, terms.height, broadcast(T(0)))};
}

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
