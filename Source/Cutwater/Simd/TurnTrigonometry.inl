#pragma once

// sin and cos of angles in turns, lane by lane, with + - * and selection only: the same bits on
// every instruction set.

#include <Cutwater/Simd/Lanes.inl>

namespace cutwater::CUTWATER_SIMD {

template <typename Real>
struct SineCosine {
  Real sine, cosine;
};

/// first + w (second + w (...))
template <typename T, typename... Others>
CUTWATER_INLINE inline Lanes<T> horner(Lanes<T> w, T first, Others... others) {
  if constexpr (sizeof...(others) == 0) {
    return broadcast(first);
  } else {
    return broadcast(first) + w * horner<T>(w, others...);
  }
}

/// For r up to an eighth of a turn on either side: sin(2 pi r) = r (2 pi + tail(r^2)) and
/// cos(2 pi r) = 1 + r^2 tail(r^2), as polynomials by the Remez algorithm. The tail includes the
/// rounding error of 2 pi. They are off by 3.5e-18 and 6e-21 for double, 3.5e-9 and 1e-11 for
/// float.
template <typename T>
struct EighthOfTurn;

template <>
struct EighthOfTurn<double> {
  static constexpr double kFarOff = 0x1.8p52;  // adding it rounds to whole numbers
  CUTWATER_INLINE static Doubles sine(Doubles r) {
    const Doubles w = r * r;
    const Doubles tail = horner<double>(
        w, 0x1.039cae0ae190bp-52, -0x1.4abbce625be41p+5, 0x1.466bc677587fdp+6,
        -0x1.32d2cce2e60e5p+6, 0x1.50782fda6c376p+5, -0x1.e30071ff2f4d1p+3, 0x1.e3f39e113747fp+1);
    return r * broadcast(0x1.921fb54442d18p+2) + r * tail;
  }
  CUTWATER_INLINE static Doubles cosine(Doubles r) {
    const Doubles w = r * r;
    return broadcast(1.0) + w * horner<double>(w, -0x1.3bd3cc9be45dep+4, 0x1.03c1f081b5ac0p+6,
                                               -0x1.55d3c7e3cb243p+6, 0x1.e1f5068689167p+5,
                                               -0x1.a6d1eef4b8302p+4, 0x1.f9ce24942b951p+2,
                                               -0x1.b2f3fd838e710p+0);
  }
};

template <>
struct EighthOfTurn<float> {
  static constexpr float kFarOff = 0x1.8p23F;
  CUTWATER_INLINE static Floats sine(Floats r) {
    const Floats w = r * r;
    const Floats tail =
        horner<float>(w, -0x1.a0f36ep-23F, -0x1.4abbbap+5F, 0x1.465ec6p+6F, -0x1.2d9bb8p+6F);
    return r * broadcast(0x1.921fb6p+2F) + r * tail;
  }
  CUTWATER_INLINE static Floats cosine(Floats r) {
    const Floats w = r * r;
    return broadcast(1.0F) +
           w * horner<float>(w, -0x1.3bd3ccp+4F, 0x1.03c1eap+6F, -0x1.55cb98p+6F, 0x1.db650ep+5F);
  }
};

/// sin(2 pi t) and cos(2 pi t), for |t| < 2^51, or 2^22 in single precision; see SineCosine.hpp.
template <typename T>
CUTWATER_INLINE inline SineCosine<Lanes<T>> sineCosineOfTurns(Lanes<T> t) {
  const Lanes<T> farOff = broadcast(EighthOfTurn<T>::kFarOff);
  const Lanes<T> one = broadcast(T(1));
  const Lanes<T> fraction = t - ((t + farOff) - farOff);  // exact, as is all of the reduction
  const Lanes<T> quarter = (fraction * broadcast(T(4)) + farOff) - farOff;  // -2 .. 2
  const Lanes<T> rest = fraction - quarter * broadcast(T(0.25));
  const Lanes<T> sine = EighthOfTurn<T>::sine(rest);
  const Lanes<T> cosine = EighthOfTurn<T>::cosine(rest);
  const auto isOdd = isAtMost(magnitude(magnitude(quarter) - one), broadcast(T(0.5)));
  const Lanes<T> alongY = where(isOdd, cosine, sine);
  const Lanes<T> alongX = where(isOdd, sine, cosine);
  const Lanes<T> bias = broadcast(T(0.25));
  return {where(isPositive(magnitude(quarter - bias) - one), -alongY, alongY),
          where(isPositive(magnitude(quarter + bias) - one), -alongX, alongX)};
}

}  // namespace cutwater::CUTWATER_SIMD
