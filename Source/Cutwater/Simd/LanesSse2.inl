#pragma once

// The operations of Lanes.inl for SSE2.

#include <emmintrin.h>

namespace cutwater::CUTWATER_SIMD {

inline constexpr int kFloats = 4;
inline constexpr int kDoubles = 2;
using Floats = float __attribute__((vector_size(16)));
using Doubles = double __attribute__((vector_size(16)));
using FloatMask = Floats;  // all bits of a lane, or none
using DoubleMask = Doubles;

CUTWATER_INLINE inline Floats broadcast(float x) {
  return _mm_set1_ps(x);
}
CUTWATER_INLINE inline Floats load(const float* from) {
  return _mm_load_ps(from);
}
CUTWATER_INLINE inline void store(float* to, Floats a) {
  _mm_store_ps(to, a);
}
CUTWATER_INLINE inline Floats least(Floats a, Floats b) {
  return _mm_min_ps(a, b);
}
CUTWATER_INLINE inline Floats most(Floats a, Floats b) {
  return _mm_max_ps(a, b);
}
CUTWATER_INLINE inline Floats magnitude(Floats a) {
  return _mm_andnot_ps(broadcast(-0.0F), a);
}
CUTWATER_INLINE inline FloatMask isPositive(Floats a) {
  return _mm_cmpgt_ps(a, _mm_setzero_ps());
}
CUTWATER_INLINE inline FloatMask isAtMost(Floats a, Floats b) {
  return _mm_cmple_ps(a, b);
}
CUTWATER_INLINE inline FloatMask both(FloatMask a, FloatMask b) {
  return _mm_and_ps(a, b);
}
CUTWATER_INLINE inline Floats where(FloatMask mask, Floats a, Floats b) {
  return _mm_or_ps(_mm_and_ps(mask, a), _mm_andnot_ps(mask, b));
}
CUTWATER_INLINE inline std::uint32_t bits(FloatMask mask) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(mask));
}
CUTWATER_INLINE inline Doubles broadcast(double x) {
  return _mm_set1_pd(x);
}
CUTWATER_INLINE inline Doubles load(const double* from) {
  return _mm_load_pd(from);
}
CUTWATER_INLINE inline void store(double* to, Doubles a) {
  _mm_store_pd(to, a);
}
CUTWATER_INLINE inline Doubles least(Doubles a, Doubles b) {
  return _mm_min_pd(a, b);
}
CUTWATER_INLINE inline Doubles most(Doubles a, Doubles b) {
  return _mm_max_pd(a, b);
}
CUTWATER_INLINE inline Doubles magnitude(Doubles a) {
  return _mm_andnot_pd(broadcast(-0.0), a);
}
CUTWATER_INLINE inline DoubleMask isPositive(Doubles a) {
  return _mm_cmpgt_pd(a, _mm_setzero_pd());
}
CUTWATER_INLINE inline DoubleMask isAtMost(Doubles a, Doubles b) {
  return _mm_cmple_pd(a, b);
}
CUTWATER_INLINE inline DoubleMask both(DoubleMask a, DoubleMask b) {
  return _mm_and_pd(a, b);
}
CUTWATER_INLINE inline Doubles where(DoubleMask mask, Doubles a, Doubles b) {
  return _mm_or_pd(_mm_and_pd(mask, a), _mm_andnot_pd(mask, b));
}
CUTWATER_INLINE inline std::uint32_t bits(DoubleMask mask) {
  return static_cast<std::uint32_t>(_mm_movemask_pd(mask));
}
CUTWATER_INLINE inline Floats squareRoot(Floats a) {
  return _mm_sqrt_ps(a);
}
CUTWATER_INLINE inline Doubles squareRoot(Doubles a) {
  return _mm_sqrt_pd(a);
}
CUTWATER_INLINE inline Floats multiplyAdd(Floats a, Floats b, Floats c) {
  return a * b + c;
}
CUTWATER_INLINE inline Floats subtractProduct(Floats c, Floats a, Floats b) {
  return c - a * b;
}
CUTWATER_INLINE inline double leastOf(Doubles a) {
  return _mm_cvtsd_f64(_mm_min_sd(a, _mm_unpackhi_pd(a, a)));
}
CUTWATER_INLINE inline float leastOf(Floats a) {
  const __m128 m = _mm_min_ps(a, _mm_movehl_ps(a, a));
  return _mm_cvtss_f32(_mm_min_ss(m, _mm_shuffle_ps(m, m, 1)));
}

}  // namespace cutwater::CUTWATER_SIMD
