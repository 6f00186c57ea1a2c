#pragma once

// The operations of Lanes.inl for AVX-512.

#include <immintrin.h>

namespace cutwater::CUTWATER_SIMD {

inline constexpr int kFloats = 16;
// Half the width: few triangles at a time need doubles, so that packets of eight are rarely full.
inline constexpr int kDoubles = 4;
#define CUTWATER_HAS_LEAST_LANE
using Floats = float __attribute__((vector_size(64)));
using Doubles = double __attribute__((vector_size(32)));
using FloatMask = __mmask16;
using DoubleMask = __mmask8;

CUTWATER_INLINE inline Floats broadcast(float x) {
  return _mm512_set1_ps(x);
}
CUTWATER_INLINE inline Floats load(const float* from) {
  return _mm512_load_ps(from);
}
CUTWATER_INLINE inline void store(float* to, Floats a) {
  _mm512_store_ps(to, a);
}
CUTWATER_INLINE inline Floats least(Floats a, Floats b) {
  return _mm512_min_ps(a, b);
}
CUTWATER_INLINE inline Floats most(Floats a, Floats b) {
  return _mm512_max_ps(a, b);
}
CUTWATER_INLINE inline Floats magnitude(Floats a) {
  return _mm512_abs_ps(a);
}
CUTWATER_INLINE inline FloatMask isPositive(Floats a) {
  return _mm512_cmp_ps_mask(a, _mm512_setzero_ps(), _CMP_GT_OQ);
}
CUTWATER_INLINE inline FloatMask isAtMost(Floats a, Floats b) {
  return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ);
}
CUTWATER_INLINE inline FloatMask both(FloatMask a, FloatMask b) {
  return static_cast<FloatMask>(a & b);
}
CUTWATER_INLINE inline Floats where(FloatMask mask, Floats a, Floats b) {
  return _mm512_mask_blend_ps(mask, b, a);
}
CUTWATER_INLINE inline std::uint32_t bits(FloatMask mask) {
  return mask;
}
CUTWATER_INLINE inline Doubles broadcast(double x) {
  return _mm256_set1_pd(x);
}
CUTWATER_INLINE inline Doubles load(const double* from) {
  return _mm256_load_pd(from);
}
CUTWATER_INLINE inline void store(double* to, Doubles a) {
  _mm256_store_pd(to, a);
}
CUTWATER_INLINE inline Doubles least(Doubles a, Doubles b) {
  return _mm256_min_pd(a, b);
}
CUTWATER_INLINE inline Doubles most(Doubles a, Doubles b) {
  return _mm256_max_pd(a, b);
}
CUTWATER_INLINE inline Doubles magnitude(Doubles a) {
  return _mm256_andnot_pd(broadcast(-0.0), a);
}
CUTWATER_INLINE inline DoubleMask isPositive(Doubles a) {
  return _mm256_cmp_pd_mask(a, _mm256_setzero_pd(), _CMP_GT_OQ);
}
CUTWATER_INLINE inline DoubleMask isAtMost(Doubles a, Doubles b) {
  return _mm256_cmp_pd_mask(a, b, _CMP_LE_OQ);
}
CUTWATER_INLINE inline DoubleMask both(DoubleMask a, DoubleMask b) {
  return static_cast<DoubleMask>(a & b);
}
CUTWATER_INLINE inline Doubles where(DoubleMask mask, Doubles a, Doubles b) {
  return _mm256_mask_blend_pd(mask, b, a);
}
CUTWATER_INLINE inline std::uint32_t bits(DoubleMask mask) {
  return mask;
}
CUTWATER_INLINE inline Floats squareRoot(Floats a) {
  return _mm512_sqrt_ps(a);
}
CUTWATER_INLINE inline Doubles squareRoot(Doubles a) {
  return _mm256_sqrt_pd(a);
}
CUTWATER_INLINE inline Floats multiplyAdd(Floats a, Floats b, Floats c) {
  return _mm512_fmadd_ps(a, b, c);
}
CUTWATER_INLINE inline Floats subtractProduct(Floats c, Floats a, Floats b) {
  return _mm512_fnmadd_ps(a, b, c);
}
CUTWATER_INLINE inline double leastOf(Doubles a) {
  const __m128d m = _mm_min_pd(_mm256_castpd256_pd128(a), _mm256_extractf128_pd(a, 1));
  return _mm_cvtsd_f64(_mm_min_sd(m, _mm_unpackhi_pd(m, m)));
}
CUTWATER_INLINE inline float leastOf(Floats a) {
  return _mm512_reduce_min_ps(a);
}
CUTWATER_INLINE inline int leastLane(const float* keys, std::uint32_t lanes) {
  // As integers, positive floats have the same order; the last bits are replaced by the lane.
  const __m512i bits = _mm512_castps_si512(_mm512_load_ps(keys));
  const __m512i names = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
  const __m512i named = _mm512_or_si512(_mm512_and_si512(bits, _mm512_set1_epi32(~15)), names);
  return _mm512_mask_reduce_min_epi32(static_cast<__mmask16>(lanes), named) & 15;
}

}  // namespace cutwater::CUTWATER_SIMD
