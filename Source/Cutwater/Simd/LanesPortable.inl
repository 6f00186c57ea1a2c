#pragma once

// The operations of Lanes.inl for any processor: one lane.

namespace cutwater::CUTWATER_SIMD {

inline constexpr int kFloats = 1;
inline constexpr int kDoubles = 1;
using Floats = float;
using Doubles = double;
using FloatMask = bool;
using DoubleMask = bool;

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
CUTWATER_INLINE inline bool isPositive(Floats a) {
  return a > 0;
}
CUTWATER_INLINE inline bool isAtMost(Floats a, Floats b) {
  return a <= b;
}
CUTWATER_INLINE inline Floats where(bool mask, Floats a, Floats b) {
  return mask ? a : b;
}
CUTWATER_INLINE inline Doubles broadcast(double x) {
  return x;
}
CUTWATER_INLINE inline Doubles load(const double* from) {
  return *from;
}
CUTWATER_INLINE inline void store(double* to, Doubles a) {
  *to = a;
}
CUTWATER_INLINE inline Doubles least(Doubles a, Doubles b) {
  return a < b ? a : b;
}
CUTWATER_INLINE inline Doubles most(Doubles a, Doubles b) {
  return a > b ? a : b;
}
CUTWATER_INLINE inline Doubles magnitude(Doubles a) {
  return a < 0 ? -a : a;
}
CUTWATER_INLINE inline bool isPositive(Doubles a) {
  return a > 0;
}
CUTWATER_INLINE inline bool isAtMost(Doubles a, Doubles b) {
  return a <= b;
}
CUTWATER_INLINE inline Doubles where(bool mask, Doubles a, Doubles b) {
  return mask ? a : b;
}
CUTWATER_INLINE inline bool both(bool a, bool b) {
  return a && b;
}
CUTWATER_INLINE inline std::uint32_t bits(bool mask) {
  return mask ? 1 : 0;
}
CUTWATER_INLINE inline Floats multiplyAdd(Floats a, Floats b, Floats c) {
  return a * b + c;
}
CUTWATER_INLINE inline Floats subtractProduct(Floats c, Floats a, Floats b) {
  return c - a * b;
}
CUTWATER_INLINE inline double leastOf(Doubles a) {
  return a;
}
CUTWATER_INLINE inline float leastOf(Floats a) {
  return a;
}

}  // namespace cutwater::CUTWATER_SIMD
