#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace cutwater {

/// How the edge is rounded where two solids meet smoothly.
enum class SmoothKind : std::uint8_t {
  Quadratic,    ///< continuous normals
  Cubic,        ///< continuous curvature
  Circular,     ///< an arc of a circle, for surfaces at a right angle; continuous normals
  Exponential,  ///< log-sum-exp: smooth everywhere, and independent of the operands' order; costs
                ///< an exp per operand, and reaches everywhere
};

/// Of a smooth union, intersection or difference.
template <std::floating_point T>
struct Smoothing {
  /// Operands whose values differ by this much or more do not affect each other; for Exponential
  /// the k of -k log(sum exp(-f / k)), which fades but has no such end.
  T reach{};
  SmoothKind kind = SmoothKind::Quadratic;
};

namespace detail {

/// A smooth least value: one number after the other, in ascending order unless Exponential.
///
/// With h = max(k - |a - b|, 0) / k, the least of a and b less
///
///     Quadratic  k h^2 / 4
///     Cubic      k h^3 / 6
///     Circular   k/2 (1 + h - sqrt(1 - h (h - 2)))
///
/// (Quilez, "Smooth minimum"). All are invariant under adding a constant, and have weights, the
/// derivatives by the numbers, that are not negative and sum to 1. Of equal numbers, two add at
/// most k/4, k/6 and k (1 - sqrt(1/2)), and any number of them less than k.
template <std::floating_point T>
class SmoothMinimum {
 public:
  explicit SmoothMinimum(const Smoothing<T>& smoothing, T first)
      : reach_(smoothing.reach), kind_(smoothing.kind), least_(first) {}

  /// Takes in one more and returns its weight; the weights so far shrink by 1 less that. A weight
  /// of 0, unless Exponential, is also that of all that are no less.
  T add(T value);

  [[nodiscard]] T value() const {
    return least_ - (kind_ == SmoothKind::Exponential ? reach_ * std::log1p(sum_) : sum_);
  }

  /// By how much the value of `count` numbers may be below the least of them.
  [[nodiscard]] static T mostAdded(const Smoothing<T>& smoothing, std::size_t count);
  /// Bound on what rounding in here moves the value of `count` numbers by, in units of eps reach;
  /// besides 2 eps |value|.
  [[nodiscard]] static T ulps(const Smoothing<T>& smoothing, std::size_t count);

 private:
  T addExponential(T value);

  T reach_;
  SmoothKind kind_;
  T least_;
  T sum_ = 0;  // what is added; Exponential: the sum of exp((least - value) / k), less 1
};

extern template class SmoothMinimum<float>;
extern template class SmoothMinimum<double>;

}  // namespace detail

}  // namespace cutwater
