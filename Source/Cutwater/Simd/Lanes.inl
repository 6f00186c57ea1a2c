// Vector arithmetic for the hot loops, in a namespace of its own for each instruction set, so that
// no code compiled for one of them is ever linked into another. Included once by a file that is
// compiled once per set, with CUTWATER_SIMD naming the namespace: see cutwater_vector_sources().
//
// A loop over the lanes of a packet goes in steps of kLanes; it reads like scalar arithmetic.
// Functions of the standard library stay out: what is not inlined would be compiled for this set
// and shared with everybody.

#include <Cutwater/Core/Inline.hpp>

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace cutwater::CUTWATER_SIMD {

#if !defined(CUTWATER_SIMD_PORTABLE) && defined(__AVX512F__)

inline constexpr int kLanes = 16;
#define CUTWATER_HAS_LEAST_LANE
using Floats = float __attribute__((vector_size(64)));

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
CUTWATER_INLINE inline Floats multiplyAdd(Floats a, Floats b, Floats c) {
  return _mm512_fmadd_ps(a, b, c);
}
CUTWATER_INLINE inline Floats subtractProduct(Floats c, Floats a, Floats b) {
  return _mm512_fnmadd_ps(a, b, c);
}
/// `a` where the condition is positive, else `b`.
CUTWATER_INLINE inline Floats wherePositive(Floats condition, Floats a, Floats b) {
  const __mmask16 mask = _mm512_cmp_ps_mask(condition, _mm512_setzero_ps(), _CMP_GT_OQ);
  return _mm512_mask_blend_ps(mask, b, a);
}
/// A bit for every lane with a <= b.
CUTWATER_INLINE inline std::uint32_t notAbove(Floats a, Floats b) {
  return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ);
}
CUTWATER_INLINE inline float leastOf(Floats a) {
  return _mm512_reduce_min_ps(a);
}

/// Which of 16 numbers >= 0 is the least, but for its last 4 bits, of those in `lanes`, which are
/// some.
CUTWATER_INLINE inline int leastLane(const float* keys, std::uint32_t lanes) {
  // As integers positive floats have the same order; the last bits make room for the lane.
  const __m512i bits = _mm512_castps_si512(_mm512_load_ps(keys));
  const __m512i names = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
  const __m512i named = _mm512_or_si512(_mm512_and_si512(bits, _mm512_set1_epi32(~15)), names);
  return _mm512_mask_reduce_min_epi32(static_cast<__mmask16>(lanes), named) & 15;
}

#elif !defined(CUTWATER_SIMD_PORTABLE) && defined(__AVX2__)

inline constexpr int kLanes = 8;
#define CUTWATER_HAS_LEAST_LANE
using Floats = float __attribute__((vector_size(32)));

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
  return _mm256_andnot_ps(_mm256_set1_ps(-0.0F), a);
}
CUTWATER_INLINE inline Floats multiplyAdd(Floats a, Floats b, Floats c) {
  return _mm256_fmadd_ps(a, b, c);
}
CUTWATER_INLINE inline Floats subtractProduct(Floats c, Floats a, Floats b) {
  return _mm256_fnmadd_ps(a, b, c);
}
CUTWATER_INLINE inline Floats wherePositive(Floats condition, Floats a, Floats b) {
  return _mm256_blendv_ps(b, a, _mm256_cmp_ps(condition, _mm256_setzero_ps(), _CMP_GT_OQ));
}
CUTWATER_INLINE inline std::uint32_t notAbove(Floats a, Floats b) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ)));
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

#elif !defined(CUTWATER_SIMD_PORTABLE) && defined(__SSE2__)

inline constexpr int kLanes = 4;
using Floats = float __attribute__((vector_size(16)));

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
  return _mm_andnot_ps(_mm_set1_ps(-0.0F), a);
}
CUTWATER_INLINE inline Floats multiplyAdd(Floats a, Floats b, Floats c) {
  return a * b + c;
}
CUTWATER_INLINE inline Floats subtractProduct(Floats c, Floats a, Floats b) {
  return c - a * b;
}
CUTWATER_INLINE inline Floats wherePositive(Floats condition, Floats a, Floats b) {
  const __m128 mask = _mm_cmpgt_ps(condition, _mm_setzero_ps());
  return _mm_or_ps(_mm_and_ps(mask, a), _mm_andnot_ps(mask, b));
}
CUTWATER_INLINE inline std::uint32_t notAbove(Floats a, Floats b) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a, b)));
}
CUTWATER_INLINE inline float leastOf(Floats a) {
  const __m128 m = _mm_min_ps(a, _mm_movehl_ps(a, a));
  return _mm_cvtss_f32(_mm_min_ss(m, _mm_shuffle_ps(m, m, 1)));
}

#else

inline constexpr int kLanes = 1;
using Floats = float;

CUTWATER_INLINE inline Floats broadcast(float x) {
  return x;
}
CUTWATER_INLINE inline Floats load(const float* from) {
  return *from;
}
CUTWATER_INLINE inline void store(float* to, Floats a) {
  *to = a;
}
CUTWATER_INLINE inline Floats least(Floats a, Floats b) {
  return a < b ? a : b;
}
CUTWATER_INLINE inline Floats most(Floats a, Floats b) {
  return a > b ? a : b;
}
CUTWATER_INLINE inline Floats magnitude(Floats a) {
  return a < 0 ? -a : a;
}
CUTWATER_INLINE inline Floats multiplyAdd(Floats a, Floats b, Floats c) {
  return a * b + c;
}
CUTWATER_INLINE inline Floats subtractProduct(Floats c, Floats a, Floats b) {
  return c - a * b;
}
CUTWATER_INLINE inline Floats wherePositive(Floats condition, Floats a, Floats b) {
  return condition > 0 ? a : b;
}
CUTWATER_INLINE inline std::uint32_t notAbove(Floats a, Floats b) {
  return a <= b ? 1 : 0;
}
CUTWATER_INLINE inline float leastOf(Floats a) {
  return a;
}

#endif

#ifndef CUTWATER_HAS_LEAST_LANE
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

/// Three components, lane by lane.
struct Floats3 {
  Floats x, y, z;

  CUTWATER_INLINE friend Floats3 operator-(const Floats3& a, const Floats3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  CUTWATER_INLINE friend Floats dot(const Floats3& a, const Floats3& b) {
    return multiplyAdd(a.x, b.x, multiplyAdd(a.y, b.y, a.z * b.z));
  }
  CUTWATER_INLINE friend Floats3 cross(const Floats3& a, const Floats3& b) {
    return {subtractProduct(a.y * b.z, a.z, b.y), subtractProduct(a.z * b.x, a.x, b.z),
            subtractProduct(a.x * b.y, a.y, b.x)};
  }
  /// a - s b
  CUTWATER_INLINE friend Floats3 subtractMultiple(const Floats3& a, Floats s, const Floats3& b) {
    return {subtractProduct(a.x, s, b.x), subtractProduct(a.y, s, b.y),
            subtractProduct(a.z, s, b.z)};
  }
};

}  // namespace cutwater::CUTWATER_SIMD
