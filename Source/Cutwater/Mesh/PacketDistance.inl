#pragma once

// Distances to the triangles of a packet in single precision, and how far they may be off. Compiled
// once per instruction set.

#include <Cutwater/Mesh/TrianglePackets.hpp>
#include <Cutwater/Simd/Lanes.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

constexpr int kWidth = TrianglePacket::kWidth;

// As plain arrays: the standard library's functions stay out.
static_assert(sizeof(TrianglePacket) == 832);

/// Where a component of packets begins.
enum Row : std::uint8_t { A = 0, AB = 3, AC = 6, Normal = 9 };
CUTWATER_INLINE inline Floats3 rows(const TrianglePacket& packet, Row row, int lane) {
  const float* const from = reinterpret_cast<const float*>(&packet) + kWidth * row + lane;
  return {load(from), load(from + kWidth), load(from + 2 * kWidth)};
}

/// A point relative to the centre of a packet, in single precision.
struct PacketPoint {
  Floats3 position;
  /// u (|p| + radius), with u = 2^-24: what all rounding is measured in.
  float unit;
};

CUTWATER_INLINE inline PacketPoint relativeTo(const TrianglePacket& packet, const Vec3<double>& p) {
  const Vec3<float> d(p - Vec3<double>(packet.center));
  const Vec3<float> size = abs(d);
  return {{broadcast(d.x), broadcast(d.y), broadcast(d.z)},
          0x1p-24F * (size.x + size.y + size.z + packet.radius)};
}

/// The point's squared distance from the edge's start `v`, less its part along the edge.
CUTWATER_INLINE inline Floats packedEdgeDistance(const Floats3& v, const Floats3& edge) {
  // A quotient that is not a number, as of an edge without length, counts as 0.
  const Floats place = fusedDot(edge, v) / fusedDot(edge, edge);
  const Floats t = least(most(place, broadcast(0.0F)), broadcast(1.0F));
  const Floats3 rest = subtractMultiple(v, t, edge);
  return fusedDot(rest, rest);
}

/// Positive if `v`, from the edge's start, lies on the inner side of the edge by more than
/// rounding.
CUTWATER_INLINE inline Floats inward(const Floats3& v, const Floats3& edge, const Floats3& normal,
                                     Floats margin) {
  const Floats size = magnitude(edge.x) + magnitude(edge.y) + magnitude(edge.z);
  return fusedDot(fusedCross(edge, v), normal) - margin * size;
}

// How far computed distances may be off, in units of u R, R = |p| + radius. The triangle that the
// rounded numbers stand for has corners within 7 of the true ones, its plane's tilt included, and
// the point is within 1. Against that triangle, by first order: the difference to a corner 1; the
// rest beside an edge 6, its square and root 2, the third edge 1 more; the height 4. In all 17 at
// most.
//
// To that come errors along the triangle. An edge's parameter is off by up to 11, which moves the
// foot along the edge; a side is computed to 12 u R times the edge's length, and as the point has
// to be inside by that (the margin; the edge's size is up to sqrt(3) lengths) it is never inside
// falsely, but may be 42 within an edge and count as outside. Both add in quadrature: where the
// distance d is not small, (53 u R)^2 / 2 d, less than u R from d = 2^-12 R on.
constexpr float kSideError = 12;
constexpr float kError = 18;
constexpr float kErrorNearby = 72;
constexpr float kNearby = 0x1p-12F / 0x1p-24F;

/// Squared distances, in single precision, to a packet's triangles from `lane` on.
CUTWATER_INLINE inline Floats packedDistances(const TrianglePacket& packet, int lane,
                                              const PacketPoint& p) {
  const Floats3 v = p.position - rows(packet, A, lane);
  const Floats3 ab = rows(packet, AB, lane);
  const Floats3 ac = rows(packet, AC, lane);
  const Floats3 normal = rows(packet, Normal, lane);
  const Floats3 bc = ac - ab;
  const Floats3 vb = v - ab;
  const Floats edges = least(least(packedEdgeDistance(v, ab), packedEdgeDistance(v, ac)),
                             packedEdgeDistance(vb, bc));

  const Floats margin = broadcast(kSideError * p.unit);
  const Floats3 ca{-ac.x, -ac.y, -ac.z};
  const Floats inside = least(least(inward(v, ab, normal, margin), inward(vb, bc, normal, margin)),
                              inward(v, ca, normal, margin));
  const Floats height = fusedDot(v, normal);
  return where(isPositive(inside), least(height * height, edges), edges);
}

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
