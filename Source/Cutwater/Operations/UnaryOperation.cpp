#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

template <std::floating_point T>
std::vector<std::string> UnaryOperation<T>::localPatchNames() const {
  return operand_.patchNames();
}

template class UnaryOperation<float>;
template class UnaryOperation<double>;

}  // namespace cutwater
