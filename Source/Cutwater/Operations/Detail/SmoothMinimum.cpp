#include <Cutwater/Operations/Detail/SmoothMinimum.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
T SmoothMinimum<T>::add(T value) {
  if (kind_ == SmoothKind::Exponential) return addExponential(value);
  const T apart = (value - least_) + sum_;
  if (!(apart < reach_)) return 0;
  const T h = (reach_ - apart) / reach_;
  switch (kind_) {
    case SmoothKind::Cubic:
      sum_ += reach_ * (h * h * h / 6);
      return h * h / 2;
    case SmoothKind::Circular: {
      const T root = std::sqrt(1 + h * (2 - h));
      sum_ += reach_ * (h * h / (1 + h + root));  // the difference documented, without cancellation
      return (1 - (1 - h) / root) / 2;
    }
    default:
      sum_ += reach_ * (h * h / 4);
      return h / 2;
  }
}

template <std::floating_point T>
T SmoothMinimum<T>::addExponential(T value) {
  if (value < least_) {
    sum_ = (1 + sum_) * std::exp((value - least_) / reach_);
    least_ = value;
    return 1 / (1 + sum_);
  }
  const T part = value > least_ ? std::exp((least_ - value) / reach_) : T(1);
  sum_ += part;
  return part / (1 + sum_);
}

template <std::floating_point T>
T SmoothMinimum<T>::mostAdded(const Smoothing<T>& smoothing, std::size_t count) {
  const T k = smoothing.reach;
  const T others = static_cast<T>(count - 1);
  switch (smoothing.kind) {
    case SmoothKind::Exponential:
      return k * std::log(others + 1);
    case SmoothKind::Cubic:
      return std::min(others * k / 6, k);
    case SmoothKind::Circular:
      return std::min(others * k * (1 - 1 / std::numbers::sqrt2_v<T>), k);
    default:
      return std::min(others * k / 4, k);
  }
}

template <std::floating_point T>
T SmoothMinimum<T>::ulps(const Smoothing<T>& smoothing, std::size_t count) {
  // Half an ulp of what is subtracted, at most k, and of `apart`; twice that for the polynomial.
  // For the exponential: argument, exp, product and sum, an ulp of the sum each, and the logarithm.
  const T steps = static_cast<T>(count - 1);
  return smoothing.kind == SmoothKind::Exponential ? 4 * steps + 8 : 3 * steps;
}

template class SmoothMinimum<float>;
template class SmoothMinimum<double>;

}  // namespace cutwater::detail
