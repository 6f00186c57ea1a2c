#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Labelled.hpp>

namespace cutwater {

template <std::floating_point T>
Labelled<T>::Labelled(Solid<T> operand, std::string name)
    : UnaryOperation<T>(std::move(operand)), name_(std::move(name)) {
  require(!name_.empty(), "named: need a name that is not empty");
}

template <std::floating_point T>
std::vector<std::string> Labelled<T>::localPatchNames() const {
  auto names = UnaryOperation<T>::localPatchNames();
  for (auto& name : names) name = names.size() == 1 ? name_ : name_ + "/" + name;
  return names;
}

template class Labelled<float>;
template class Labelled<double>;

}  // namespace cutwater
