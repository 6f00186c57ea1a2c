#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Composite.hpp>

namespace cutwater {

template <std::floating_point T, typename Operands>
Composite<T, Operands>::Composite(Operands operands) : operands_(std::move(operands)) {
  std::size_t patches = 0;
  for (const auto& operand : operands_) {
    firstPatch_.push_back(static_cast<std::uint32_t>(patches));
    patches += operand.patchNames().size();
  }
  require(patches < kNone, "Combination: too many patches", Named{"patches", patches});
}

template <std::floating_point T, typename Operands>
SurfaceOwner Composite<T, Operands>::counted(SurfaceOwner owner, std::size_t operand) const {
  owner.object = static_cast<std::uint32_t>(operand);
  owner.patch += firstPatch_[operand];
  return owner;
}

template <std::floating_point T, typename Operands>
std::vector<std::string> Composite<T, Operands>::localPatchNames() const {
  std::vector<std::string> names;
  for (const auto& operand : operands_) {
    for (auto& name : operand.patchNames()) names.push_back(std::move(name));
  }
  return names;
}

template class Composite<float>;
template class Composite<double>;
template class Composite<float, std::array<Solid<float>, 2>>;
template class Composite<double, std::array<Solid<double>, 2>>;

}  // namespace cutwater
