#pragma once

// The first step of orientation(), for scalars and for the lanes of vectors from one source.
// Compiled once per instruction set, and for scalars by ExactPredicates.cpp.

#include <Cutwater/Simd/Lanes.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Below this the filters leave the decision to exact arithmetic: far above what coarse() drops
/// from a product of three numbers up to 2^60, and far below any determinant of consequence.
constexpr double kTiny = 0x1p-200;

/// The sign of `value` is that of the orientation where its size exceeds the bound.
struct OrientationFilter {
  Doubles value;
  Doubles sizes;  ///< of what was added up

  /// Shewchuk's bound is (7 + 56 u) u times the sum of sizes, u = 2^-53.
  [[nodiscard]] CUTWATER_INLINE Doubles bound() const {
    return broadcast(8 * 0x1p-53) * sizes + broadcast(kTiny);
  }
};

CUTWATER_INLINE inline OrientationFilter filterOrientation(const Triple<Doubles>& a,
                                                           const Triple<Doubles>& b,
                                                           const Triple<Doubles>& c,
                                                           const Triple<Doubles>& p) {
  const auto u = b - a;
  const auto v = c - a;
  const auto w = p - a;
  const auto xy = u.x * v.y;
  const auto yx = u.y * v.x;
  const auto yz = u.y * v.z;
  const auto zy = u.z * v.y;
  const auto zx = u.z * v.x;
  const auto xz = u.x * v.z;
  return {(yz - zy) * w.x + (zx - xz) * w.y + (xy - yx) * w.z,
          (magnitude(yz) + magnitude(zy)) * magnitude(w.x) +
              (magnitude(zx) + magnitude(xz)) * magnitude(w.y) +
              (magnitude(xy) + magnitude(yx)) * magnitude(w.z)};
}

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
