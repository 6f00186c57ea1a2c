#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Labelled.hpp>

#include <algorithm>
#include <functional>

namespace cutwater {

template <std::floating_point T>
Labelled<T>::Labelled(Solid<T> solid, std::string name)
    : Forwarding<T, Labelled<T>>(std::move(solid)), name_(std::move(name)) {
  require(!name_.empty(), "named: need a name that is not empty");
}

template <std::floating_point T>
std::vector<std::string> Labelled<T>::localPatchNames() const {
  auto names = UnaryOperation<T>::localPatchNames();
  const bool areOne = std::ranges::adjacent_find(names, std::not_equal_to()) == names.end();
  for (auto& name : names) name = areOne ? name_ : name_ + "/" + name;
  return names;
}

template class Labelled<float>;
template class Labelled<double>;

}  // namespace cutwater
