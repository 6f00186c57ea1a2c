#pragma once

// Vector arithmetic for the hot loops, in a separate namespace for each instruction set, so that no
// code compiled for one set is ever linked into another. Included once by a file that is compiled
// once per set, with CUTWATER_SIMD as the namespace: see cutwater_vector_sources().
//
// A loop over the lanes of a packet advances by kFloats or kDoubles and reads like scalar
// arithmetic. Operations on both Floats and Doubles, one file per set:
//
//     broadcast load store                        arrays are aligned to the size of a vector
//     + - * /, least most magnitude               lane by lane, rounded like scalars
//     isPositive isAtMost both -> mask            a > 0; a <= b; not for NaN
//     where(mask, a, b)  bits(mask)               a where it is set, else b; one bit per lane
//     squareRoot leastOf                          rounded like scalars; the least of all lanes
//
// and on Floats, for bounds: multiplyAdd(a, b, c) = a b + c and subtractProduct(c, a, b) = c - a b,
// rounded once or twice depending on the set.
//
// Functions of the standard library are not used: what is not inlined would be compiled for this
// set and shared with all other code.

#include <Cutwater/Core/Detail/Inline.hpp>

#include <cstdint>

#if defined(CUTWATER_SIMD_PORTABLE)
#include <Cutwater/Simd/LanesPortable.inl>
#elif defined(__AVX512F__)
#include <Cutwater/Simd/LanesAvx512.inl>
#elif defined(__AVX2__)
#include <Cutwater/Simd/LanesAvx2.inl>
#elif defined(__SSE2__)
#include <Cutwater/Simd/LanesSse2.inl>
#else
#include <Cutwater/Simd/LanesPortable.inl>
#endif

namespace cutwater::CUTWATER_SIMD {

#ifndef CUTWATER_HAS_LEAST_LANE
/// The lane with the least of 16 numbers >= 0, up to their last 4 bits, among those in `lanes`,
/// which is not 0.
CUTWATER_INLINE inline int leastLane(const float* keys, std::uint32_t lanes) {
  int best = __builtin_ctz(lanes);
  for (lanes &= lanes - 1; lanes != 0; lanes &= lanes - 1) {
    const int lane = __builtin_ctz(lanes);
    best = keys[lane] < keys[best] ? lane : best;
  }
  return best;
}
#endif

CUTWATER_INLINE inline float squareRoot(float x) {
  return __builtin_sqrtf(x);
}
CUTWATER_INLINE inline double squareRoot(double x) {
  return __builtin_sqrt(x);
}

// The lane types of a scalar type.
template <typename T>
struct LanesFor;
template <>
struct LanesFor<float> {
  using Type = Floats;
  using Mask = FloatMask;
  static constexpr int kCount = kFloats;
};
template <>
struct LanesFor<double> {
  using Type = Doubles;
  using Mask = DoubleMask;
  static constexpr int kCount = kDoubles;
};
template <typename T>
using Lanes = typename LanesFor<T>::Type;
template <typename T>
using MaskOf = typename LanesFor<T>::Mask;
template <typename T>
inline constexpr int kLanesOf = LanesFor<T>::kCount;

/// Three components, lane by lane.
template <typename Real>
struct Triple {
  Real x, y, z;

  CUTWATER_INLINE friend Triple operator-(const Triple& a, const Triple& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  CUTWATER_INLINE friend Triple operator+(const Triple& a, const Triple& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  CUTWATER_INLINE friend Triple operator*(Real s, const Triple& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  CUTWATER_INLINE friend Real dot(const Triple& a, const Triple& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  CUTWATER_INLINE friend Triple cross(const Triple& a, const Triple& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

template <typename Mask, typename Real>
CUTWATER_INLINE inline Triple<Real> where(Mask mask, const Triple<Real>& a, const Triple<Real>& b) {
  return {where(mask, a.x, b.x), where(mask, a.y, b.y), where(mask, a.z, b.z)};
}

/// The sum of the components' absolute values.
template <typename Real>
CUTWATER_INLINE inline Real sizeOf(const Triple<Real>& v) {
  return magnitude(v.x) + magnitude(v.y) + magnitude(v.z);
}

// The same for bounds: rounding depends on the instruction set.

using Floats3 = Triple<Floats>;

CUTWATER_INLINE inline Floats fusedDot(const Floats3& a, const Floats3& b) {
  return multiplyAdd(a.x, b.x, multiplyAdd(a.y, b.y, a.z * b.z));
}
CUTWATER_INLINE inline Floats3 fusedCross(const Floats3& a, const Floats3& b) {
  return {subtractProduct(a.y * b.z, a.z, b.y), subtractProduct(a.z * b.x, a.x, b.z),
          subtractProduct(a.x * b.y, a.y, b.x)};
}
/// a - s b
CUTWATER_INLINE inline Floats3 subtractMultiple(const Floats3& a, Floats s, const Floats3& b) {
  return {subtractProduct(a.x, s, b.x), subtractProduct(a.y, s, b.y), subtractProduct(a.z, s, b.z)};
}

}  // namespace cutwater::CUTWATER_SIMD
