#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/OperandPatches.hpp>

namespace cutwater::detail {

template <std::floating_point T>
OperandPatches<T>::OperandPatches(std::span<const Solid<T>> operands) {
  std::size_t patches = 0;
  for (const auto& operand : operands) {
    firstPatch_.push_back(static_cast<std::uint32_t>(patches));
    patches += operand.patchNames().size();
  }
  require(patches < kNone, "Combination: too many patches", Named{"patches", patches});
}

template <std::floating_point T>
SurfaceOwner OperandPatches<T>::counted(SurfaceOwner owner, std::size_t operand) const {
  owner.object = static_cast<std::uint32_t>(operand);
  owner.patch += firstPatch_[operand];
  return owner;
}

template <std::floating_point T>
std::vector<std::string> OperandPatches<T>::names(std::span<const Solid<T>> operands) {
  std::vector<std::string> names;
  for (const auto& operand : operands) {
    for (auto& name : operand.patchNames()) names.push_back(std::move(name));
  }
  return names;
}

template class OperandPatches<float>;
template class OperandPatches<double>;

}  // namespace cutwater::detail
