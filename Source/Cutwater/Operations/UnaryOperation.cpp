#include <Cutwater/Operations/UnaryOperation.hpp>

#include <cmath>

namespace cutwater {

template <std::floating_point T>
Interval<T> UnaryOperation<T>::wantedOverFactor(const Interval<T>& wanted, T factor) {
  // The quotient and the product are rounded; the product may underflow.
  const auto outward = [](T end) {
    return 4 * std::numeric_limits<T>::epsilon() * std::abs(end) + std::numeric_limits<T>::min();
  };
  const T lower = wanted.lower / factor;
  const T upper = wanted.upper / factor;
  return {lower - outward(lower), upper + outward(upper)};
}

template <std::floating_point T>
std::vector<std::string> UnaryOperation<T>::localPatchNames() const {
  return operand_.patchNames();
}

template class UnaryOperation<float>;
template class UnaryOperation<double>;

}  // namespace cutwater
