// Bounds of beams' values in single precision: BeamPackets.hpp. Compiled once per instruction set.

#include <Cutwater/Lattice/Detail/BeamPackets.hpp>
#include <Cutwater/Simd/Lanes.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

constexpr int kWidth = BeamPacket::kWidth;

// Accessed as plain arrays, which keeps the standard library's functions out.
static_assert(sizeof(BeamPacket) == 10 * 64 + 64);

// Let a be the distance from the point of the axis at h, and r(h) the radius there. Then a - r(h)
// is not less than the value v, which is its least over all h; and if h is that of the nearest
// point,
//
//     cosine a - r(h) <= v        a - the larger radius <= v
//
// Beside the cone, the first one is v. Beside the balls it holds because v is the projection onto a
// unit vector there, and the cone's normal is another such vector.
//
// The error of computed bounds is given in units of u R, with u = 2^-24 and R the sum of the
// packet's reach and the distance to its centre. The start, the point and their difference are
// rounded: 3; the direction: 1; a dot product: 3. That is 7 for h, and 1 more at the end of the
// axis. From the point at that h: 3 for the difference, 1 for the direction, 2 for product and
// difference, 3 for the length: 9 for a. The radius has 4: 15 for a - r(h), with the ends. For the
// lower bounds, h has to be that of the nearest point: 8 more for a and 8 for r, and 2 for the
// cosine and the difference: 33.
constexpr float kUpperError = 16;
constexpr float kLowerError = 36;

/// Larger than all sums of distances.
constexpr float kFar = 0x1p100F;

/// Rounded up, by more than an ulp.
CUTWATER_INLINE inline float roundedUp(double x) {
  const double size = x < 0 ? -x : x;
  return static_cast<float>(x + 0x1p-22 * size + 0x1p-100);
}

}  // namespace

std::uint32_t boundBeams(const BeamPacket& packet, const Vec3<double>& q, double slack,
                         BeamBounds& bounds) {
  const float* const rows = reinterpret_cast<const float*>(&packet);
  const auto row = [&](int i, int lane) __attribute__((always_inline)) {
    return load(rows + kWidth * i + lane);
  };
  const Vec3<float> p(q - Vec3<double>(packet.center));
  const float unit = 0x1p-24F * (oneNorm(p) + packet.reach);
  const Floats3 at{broadcast(p.x), broadcast(p.y), broadcast(p.z)};
  const Floats zero = broadcast(0.0F);
  float* const lower = reinterpret_cast<float*>(&bounds);
  Floats leastUpper = broadcast(kFar);
  for (int lane = 0; lane < kWidth; lane += kFloats) {
    const Floats3 direction{row(3, lane), row(4, lane), row(5, lane)};
    const Floats3 d = at - Floats3{row(0, lane), row(1, lane), row(2, lane)};
    const Floats place = least(most(fusedDot(d, direction), zero), row(6, lane));
    const Floats3 off = subtractMultiple(d, place, direction);
    const Floats distance = squareRoot(fusedDot(off, off));
    const Floats radius = subtractProduct(row(7, lane), row(8, lane), place);
    const Floats atEnd = subtractProduct(row(7, lane), row(8, lane), row(6, lane));
    leastUpper = least(leastUpper, distance - radius);
    store(lower + lane,
          most(row(9, lane) * distance - radius, distance - most(row(7, lane), atEnd)) -
              broadcast(kLowerError * unit));
  }
  const double upper = double{leastOf(leastUpper)} + double{kUpperError * unit};
  if (upper < bounds.least) bounds.least = upper;
  const Floats limit = broadcast(roundedUp(bounds.least + slack));
  std::uint32_t lanes = 0;
  for (int lane = 0; lane < kWidth; lane += kFloats) {
    lanes |= bits(isAtMost(load(lower + lane), limit)) << lane;
  }
  return lanes;
}

}  // namespace cutwater::CUTWATER_SIMD
