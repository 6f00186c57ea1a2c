#pragma once

#include <Cutwater/Operations/Smoothing.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace cutwater::detail {

/// A smooth minimum: takes one number after the other, in ascending order unless Exponential.
///
/// With h = max(k - |a - b|, 0) / k, the smaller of a and b minus
///
///     Quadratic  k h^2 / 4
///     Cubic      k h^3 / 6
///     Circular   k/2 (1 + h - sqrt(1 - h (h - 2)))
///
/// (Quilez, "Smooth minimum"). Adding a constant to all numbers adds it to the minimum. The
/// weights, i.e. the derivatives with respect to the numbers, are not negative and sum to 1. The
/// amount subtracted is at most k/4, k/6 and k (1 - sqrt(1/2)) for two numbers, reached if they are
/// equal, and less than k for any number of them.
template <std::floating_point T>
class SmoothMinimum {
 public:
  explicit SmoothMinimum(const Smoothing<T>& smoothing, T first)
      : reach_(smoothing.reach), kind_(smoothing.kind), least_(first) {}

  /// Takes in another number and returns its weight w; earlier weights are multiplied by 1 - w.
  /// Unless Exponential, if w is 0, so is the weight of every number that is not less.
  T add(T value);

  [[nodiscard]] T value() const {
    return least_ - (kind_ == SmoothKind::Exponential ? reach_ * std::log1p(sum_) : sum_);
  }

  /// The most by which the value of `count` numbers may be below the least of them.
  [[nodiscard]] static T mostAdded(const Smoothing<T>& smoothing, std::size_t count);
  /// Bound on the rounding of the value of `count` numbers, in units of eps reach, in addition to
  /// 2 eps |value|.
  [[nodiscard]] static T ulps(const Smoothing<T>& smoothing, std::size_t count);

 private:
  T addExponential(T value);

  T reach_;
  SmoothKind kind_;
  T least_;
  T sum_ = 0;  // what is subtracted; Exponential: the sum of exp((least - value) / k), minus 1
};

extern template class SmoothMinimum<float>;
extern template class SmoothMinimum<double>;

}  // namespace cutwater::detail
