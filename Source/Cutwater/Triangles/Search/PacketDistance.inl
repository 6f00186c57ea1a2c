#pragma once

// Distances to the triangles of a packet in single precision, with error bounds. Compiled once per
// instruction set.

#include <Cutwater/Simd/Lanes.inl>
#include <Cutwater/Triangles/Search/TrianglePacket.hpp>

namespace cutwater::CUTWATER_SIMD {

namespace {

constexpr int kWidth = TrianglePacket::kWidth;

/// Larger than every squared distance.
constexpr float kFar = 0x1p126F;

// Accessed as plain arrays, to keep out functions of the standard library.
static_assert(sizeof(TrianglePacket) == 832);

/// Triangles, lane by lane, in the order of their rows in a packet.
struct PackedTriangle {
  static constexpr int kRows = 12;

  Floats3 a, ab, ac;
  Floats3 normal;  ///< of unit length; 0 without area
};

/// Rows of `stride` numbers each, from `lane` on.
CUTWATER_INLINE inline PackedTriangle packedTriangle(const float* rows, int stride, int lane) {
  const float* const from = rows + lane;
  const auto three = [&](int row) __attribute__((always_inline)) {
    const float* const first = from + std::ptrdiff_t{stride} * row;
    return Floats3{load(first), load(first + stride), load(first + 2 * std::ptrdiff_t{stride})};
  };
  return {three(0), three(3), three(6), three(9)};
}
CUTWATER_INLINE inline const float* rowsOf(const TrianglePacket& packet) {
  return reinterpret_cast<const float*>(&packet);
}

/// The directions of a packet's box, one after the other, then its half extents.
CUTWATER_INLINE inline const float* boxOf(const TrianglePacket& packet) {
  return &packet.radius + 1;
}

/// A point relative to the centre of a packet, in single precision.
struct PacketPoint {
  Floats3 position;
  /// u (|p| + radius), with u = 2^-24: the unit of all rounding errors.
  float unit;
};

CUTWATER_INLINE inline PacketPoint relativeTo(const TrianglePacket& packet, const Vec3<double>& p) {
  const Vec3<float> d(p - Vec3<double>(packet.center));
  const Vec3<float> size = abs(d);
  return {{broadcast(d.x), broadcast(d.y), broadcast(d.z)},
          0x1p-24F * (size.x + size.y + size.z + packet.radius)};
}

/// The vector to the point from the nearest point of an edge. Takes the vector from the edge's
/// start and the parameter along the edge, 0 at the start and 1 at the end.
CUTWATER_INLINE inline Floats3 offEdge(const Floats3& v, const Floats3& edge, Floats place) {
  return subtractMultiple(v, least(most(place, broadcast(0.0F)), broadcast(1.0F)), edge);
}
CUTWATER_INLINE inline Floats3 offEdge(const Floats3& v, const Floats3& edge) {
  // A quotient that is NaN, as for an edge without length, counts as 0.
  return offEdge(v, edge, fusedDot(edge, v) / fusedDot(edge, edge));
}

/// Positive if `v`, the point relative to the edge's start, lies on the inner side of the edge by
/// more than rounding.
CUTWATER_INLINE inline Floats inward(const Floats3& v, const Floats3& edge, const Floats3& normal,
                                     Floats margin) {
  return fusedDot(fusedCross(edge, v), normal) - margin * sizeOf(edge);
}

// Error bounds of computed distances, in units of u R with R = |p| + radius. The triangle given by
// the rounded numbers has corners within 7 of the true ones, including the tilt of its plane, and
// the point is within 1. Relative to that triangle, to first order: the difference from a corner
// adds 1; the rest beside an edge 6, its square and root 2, the third edge 1 more; the height 4. In
// all at most 18.
//
// Errors along the triangle come on top. An edge's parameter is off by up to 11, which moves the
// foot along the edge. A side is computed to 12 u R times the edge's length. As the point has to be
// inside by that much (the margin; the edge's size is up to sqrt(3) lengths), it never counts as
// inside falsely, but may be 42 within an edge and count as outside. Both add in quadrature: where
// the distance d is not small they make (53 u R)^2 / 2 d, less than u R from d = 2^-12 R on.
constexpr float kSideError = 12;
constexpr float kError = 19;
constexpr float kErrorNearby = 72;
constexpr float kNearby = 0x1p-12F / 0x1p-24F;

/// The vector to a point from the nearest point of a triangle, in single precision.
struct PackedOffset {
  Floats squared;  ///< of its length
  Floats3 offset;
};

/// `unit` is that of the point: see PacketPoint.
CUTWATER_INLINE inline PackedOffset packedOffset(const PackedTriangle& t, const Floats3& p,
                                                 float unit) {
  const Floats3 v = p - t.a;
  const Floats3 vb = v - t.ab;
  const Floats3 bc = t.ac - t.ab;
  PackedOffset best{broadcast(kFar), p};
  const auto offer = [&](const Floats3& offset, Floats squared) __attribute__((always_inline)) {
    const auto isNearer = isAtMost(squared, best.squared);
    best.squared = where(isNearer, squared, best.squared);
    best.offset = where(isNearer, offset, best.offset);
  };
  const auto offerEdge = [&](const Floats3& offset) __attribute__((always_inline)) {
    offer(offset, fusedDot(offset, offset));
  };
  offerEdge(offEdge(v, t.ab));
  offerEdge(offEdge(v, t.ac));
  offerEdge(offEdge(vb, bc));

  const Floats margin = broadcast(kSideError * unit);
  const Floats3 ca{-t.ac.x, -t.ac.y, -t.ac.z};
  const Floats inside =
      least(least(inward(v, t.ab, t.normal, margin), inward(vb, bc, t.normal, margin)),
            inward(v, ca, t.normal, margin));
  const Floats height = fusedDot(v, t.normal);
  offer(height * t.normal, where(isPositive(inside), height * height, broadcast(kFar)));
  return best;
}

// The computed closest point is within this many units of the triangle: the error of a distance
// that is not small, plus the shift of a candidate's corners.
constexpr float kOffsetError = 24;

/// Lower bound on w . (p - x) over the triangle's points x, where w is the offset: for
/// ClusterBounds. Corners are within 9 u R of the true ones, the point within 1; the rest is the
/// rounding of the products.
CUTWATER_INLINE inline Floats packedSeparation(const PackedTriangle& t, const Floats3& p,
                                               const PackedOffset& off, float unit) {
  const Floats toA = fusedDot(off.offset, p - t.a);
  const Floats farther = most(fusedDot(off.offset, t.ab), fusedDot(off.offset, t.ac));
  return toA - most(farther, broadcast(0.0F)) -
         broadcast(kOffsetError * unit) * squareRoot(off.squared);
}

/// Squared distances to the triangles of a packet, from `lane` on.
CUTWATER_INLINE inline Floats packedDistances(const TrianglePacket& packet, int lane,
                                              const PacketPoint& p) {
  return packedOffset(packedTriangle(rowsOf(packet), kWidth, lane), p.position, p.unit).squared;
}

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
