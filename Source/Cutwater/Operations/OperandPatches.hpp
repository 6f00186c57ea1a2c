#pragma once

#include <Cutwater/Sdf/Solid.hpp>

#include <span>

namespace cutwater::detail {

/// The patches of several operands: counted through their tables one after the other.
template <std::floating_point T>
class OperandPatches {
 public:
  /// @throws Error if there are more than 32-bit ids can count.
  explicit OperandPatches(std::span<const Solid<T>> operands);

  /// What an operand's answer is in the composite.
  [[nodiscard]] SurfaceOwner counted(SurfaceOwner owner, std::size_t operand) const;
  /// The names of all; of the same operands.
  [[nodiscard]] static std::vector<std::string> names(std::span<const Solid<T>> operands);

 private:
  std::vector<std::uint32_t> firstPatch_;
};

extern template class OperandPatches<float>;
extern template class OperandPatches<double>;

}  // namespace cutwater::detail
