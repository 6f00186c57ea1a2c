#pragma once

// The operations of Lanes.inl for AVX2 and FMA.

#include <immintrin.h>

namespace cutwater::CUTWATER_SIMD {

inline constexpr int kFloats = 8;
inline constexpr int kDoubles = 4;
#define CUTWATER_HAS_LEAST_LANE
using Floats = float __attribute__((vector_size(32)));
using Doubles = double __attribute__((vector_size(32)));
using FloatMask = Floats;  // all bits of a lane, or none
using DoubleMask = Doubles;

CUTWATER_INLINE inline Floats broadcast(float x) {
  return _mm256_set1_ps(x);
}
CUTWATER_INLINE inline Floats load(const float* from) {
  return _mm256_load_ps(from);
}
CUTWATER_INLINE inline void store(float* to, Floats a) {
  _mm256_store_ps(to, a);
}
CUTWATER_INLINE inline Floats least(Floats a, Floats b) {
  return _mm256_min_ps(a, b);
}
CUTWATER_INLINE inline Floats most(Floats a, Floats b) {
  return _mm256_max_ps(a, b);
}
CUTWATER_INLINE inline Floats magnitude(Floats a) {
  return _mm256_andnot_ps(broadcast(-0.0F), a);
}
CUTWATER_INLINE inline FloatMask isPositive(Floats a) {
  return _mm256_cmp_ps(a, _mm256_setzero_ps(), _CMP_GT_OQ);
}
CUTWATER_INLINE inline FloatMask isAtMost(Floats a, Floats b) {
  return _mm256_cmp_ps(a, b, _CMP_LE_OQ);
}
CUTWATER_INLINE inline FloatMask both(FloatMask a, FloatMask b) {
  return _mm256_and_ps(a, b);
}
CUTWATER_INLINE inline Floats where(FloatMask mask, Floats a, Floats b) {
  return _mm256_blendv_ps(b, a, mask);
}
CUTWATER_INLINE inline std::uint32_t bits(FloatMask mask) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(mask));
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
  return _mm256_cmp_pd(a, _mm256_setzero_pd(), _CMP_GT_OQ);
}
CUTWATER_INLINE inline DoubleMask isAtMost(Doubles a, Doubles b) {
  return _mm256_cmp_pd(a, b, _CMP_LE_OQ);
}
CUTWATER_INLINE inline DoubleMask both(DoubleMask a, DoubleMask b) {
  return _mm256_and_pd(a, b);
}
CUTWATER_INLINE inline Doubles where(DoubleMask mask, Doubles a, Doubles b) {
  return _mm256_blendv_pd(b, a, mask);
}
CUTWATER_INLINE inline std::uint32_t bits(DoubleMask mask) {
  return static_cast<std::uint32_t>(_mm256_movemask_pd(mask));
}
CUTWATER_INLINE inline Floats squareRoot(Floats a) {
  return _mm256_sqrt_ps(a);
}
CUTWATER_INLINE inline Doubles squareRoot(Doubles a) {
  return _mm256_sqrt_pd(a);
}
CUTWATER_INLINE inline Floats multiplyAdd(Floats a, Floats b, Floats c) {
  return _mm256_fmadd_ps(a, b, c);
}
CUTWATER_INLINE inline Floats subtractProduct(Floats c, Floats a, Floats b) {
  return _mm256_fnmadd_ps(a, b, c);
}
CUTWATER_INLINE inline double leastOf(Doubles a) {
  const __m128d m = _mm_min_pd(_mm256_castpd256_pd128(a), _mm256_extractf128_pd(a, 1));
  return _mm_cvtsd_f64(_mm_min_sd(m, _mm_unpackhi_pd(m, m)));
}
CUTWATER_INLINE inline float leastOf(Floats a) {
  __m128 m = _mm_min_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1));
  m = _mm_min_ps(m, _mm_movehl_ps(m, m));
  return _mm_cvtss_f32(_mm_min_ss(m, _mm_shuffle_ps(m, m, 1)));
}

CUTWATER_INLINE inline int leastLane(const float* keys, std::uint32_t lanes) {
  const auto named = [&](int first) __attribute__((always_inline)) {
    const __m256i names =
        _mm256_add_epi32(_mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0), _mm256_set1_epi32(first));
    const __m256i bits = _mm256_castps_si256(_mm256_load_ps(keys + first));
    const __m256i key = _mm256_or_si256(_mm256_and_si256(bits, _mm256_set1_epi32(~15)), names);
    const __m256i flags = _mm256_sllv_epi32(_mm256_set1_epi32(1), names);
    const __m256i wanted = _mm256_cmpeq_epi32(
        _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(lanes)), flags), flags);
    return _mm256_blendv_epi8(_mm256_set1_epi32(0x7fffffff), key, wanted);
  };
  const __m256i both = _mm256_min_epi32(named(0), named(8));
  __m128i m = _mm_min_epi32(_mm256_castsi256_si128(both), _mm256_extracti128_si256(both, 1));
  m = _mm_min_epi32(m, _mm_shuffle_epi32(m, 0x4e));
  m = _mm_min_epi32(m, _mm_shuffle_epi32(m, 0xb1));
  return _mm_cvtsi128_si32(m) & 15;
}

}  // namespace cutwater::CUTWATER_SIMD
