#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cmath>

namespace cutwater {

/// An unevaluated sum high + low of two doubles, |low| <= ulp(high) / 2: about 106 significant
/// bits, computed by + - * / sqrt only, with the same bits on every machine.
///
/// For the few places where rounding in double decides the result: slivers, sums with cancellation.
/// Relative error at most 2^-102 per operation, provided that nothing over- or underflows (|values|
/// below 2^996, products above 2^-968): scale by a power of two first. Meant for .cpp files of the
/// library; compiled with -ffast-math it loses the extra precision.
///
/// Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18
/// (1971); Knuth, TAOCP vol. 2, 4.2.2; operations after Joldes, Muller & Popescu, "Tight and
/// rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44 (2017).
struct DoubleDouble {
  double high = 0;
  double low = 0;

  CUTWATER_INLINE constexpr DoubleDouble() = default;
  CUTWATER_INLINE constexpr DoubleDouble(double value) : high(value) {}  // NOLINT: exact
  CUTWATER_INLINE constexpr DoubleDouble(double highIn, double lowIn) : high(highIn), low(lowIn) {}

  /// The nearest double.
  CUTWATER_INLINE constexpr explicit operator double() const { return high; }

  /// a + b without error (Knuth's TwoSum).
  CUTWATER_INLINE static constexpr DoubleDouble sum(double a, double b) {
    const double s = a + b;
    const double bPart = s - a;
    const double aPart = s - bPart;
    return {s, (a - aPart) + (b - bPart)};
  }
  /// a - b without error.
  CUTWATER_INLINE static constexpr DoubleDouble difference(double a, double b) {
    return sum(a, -b);
  }
  /// a * b without error (Dekker's product with Veltkamp's splitting).
  CUTWATER_INLINE static constexpr DoubleDouble product(double a, double b) {
    const double p = a * b;
    const double aHigh = upperHalf(a);
    const double aLow = a - aHigh;
    const double bHigh = upperHalf(b);
    const double bLow = b - bHigh;
    return {p, ((aHigh * bHigh - p) + aHigh * bLow + aLow * bHigh) + aLow * bLow};
  }

  CUTWATER_INLINE friend constexpr DoubleDouble operator-(DoubleDouble a) {
    return {-a.high, -a.low};
  }
  CUTWATER_INLINE friend constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble s = sum(a.high, b.high);
    const DoubleDouble t = sum(a.low, b.low);
    const DoubleDouble v = normalizedSum(s.high, s.low + t.high);
    return normalizedSum(v.high, t.low + v.low);
  }
  CUTWATER_INLINE friend constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
    return a + (-b);
  }
  CUTWATER_INLINE friend constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble p = product(a.high, b.high);
    return normalizedSum(p.high, p.low + (a.high * b.low + a.low * b.high));
  }
  /// The quotient of the high parts, corrected by the quotient of the remainder.
  CUTWATER_INLINE friend constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double quotient = a.high / b.high;
    const DoubleDouble rest = a - b * DoubleDouble(quotient);
    return normalizedSum(quotient, rest.high / b.high);
  }
  CUTWATER_INLINE DoubleDouble& operator+=(DoubleDouble b) { return *this = *this + b; }
  CUTWATER_INLINE DoubleDouble& operator-=(DoubleDouble b) { return *this = *this - b; }
  CUTWATER_INLINE DoubleDouble& operator*=(DoubleDouble b) { return *this = *this * b; }

  /// Returns 0 for 0 and NaN for negative numbers.
  CUTWATER_INLINE friend DoubleDouble sqrt(DoubleDouble a) {
    const double root = std::sqrt(a.high);
    if (!(root > 0)) return {root, 0};
    return normalizedSum(root, (a - product(root, root)).high / (2 * root));
  }
  CUTWATER_INLINE friend constexpr DoubleDouble abs(DoubleDouble a) { return a < 0.0 ? -a : a; }

  // Normalised numbers compare part by part.
  CUTWATER_INLINE friend constexpr bool operator==(DoubleDouble a, DoubleDouble b) {
    return a.high == b.high && a.low == b.low;
  }
  CUTWATER_INLINE friend constexpr bool operator<(DoubleDouble a, DoubleDouble b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  CUTWATER_INLINE friend constexpr bool operator>(DoubleDouble a, DoubleDouble b) { return b < a; }
  CUTWATER_INLINE friend constexpr bool operator<=(DoubleDouble a, DoubleDouble b) {
    return a < b || a == b;
  }
  CUTWATER_INLINE friend constexpr bool operator>=(DoubleDouble a, DoubleDouble b) {
    return b <= a;
  }

 private:
  /// a + b without error where |a| >= |b| or a = 0 (Dekker's FastTwoSum).
  CUTWATER_INLINE static constexpr DoubleDouble normalizedSum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  /// The upper 26 bits.
  CUTWATER_INLINE static constexpr double upperHalf(double a) {
    constexpr double kSplitter = 134217729;  // 2^27 + 1
    const double c = kSplitter * a;
    return c - (c - a);
  }
};

/// A vector of double-doubles, with the few operations that plane distances and normals need.
struct DoubleDouble3 {
  DoubleDouble x, y, z;

  /// a - b without error.
  CUTWATER_INLINE static constexpr DoubleDouble3 difference(const Vec3<double>& a,
                                                            const Vec3<double>& b) {
    return {DoubleDouble::difference(a.x, b.x), DoubleDouble::difference(a.y, b.y),
            DoubleDouble::difference(a.z, b.z)};
  }
  CUTWATER_INLINE constexpr explicit operator Vec3<double>() const {
    return {x.high, y.high, z.high};
  }

  CUTWATER_INLINE friend constexpr DoubleDouble3 operator+(const DoubleDouble3& a,
                                                           const DoubleDouble3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  CUTWATER_INLINE friend constexpr DoubleDouble3 operator-(const DoubleDouble3& a,
                                                           const DoubleDouble3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  CUTWATER_INLINE friend constexpr DoubleDouble dot(const DoubleDouble3& a,
                                                    const DoubleDouble3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  CUTWATER_INLINE friend constexpr DoubleDouble3 cross(const DoubleDouble3& a,
                                                       const DoubleDouble3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

}  // namespace cutwater
