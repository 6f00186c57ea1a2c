#pragma once

#include <Cutwater/Sdf/Solid.hpp>

#include <span>

namespace cutwater::detail {

/// The patches of several operands, numbered through their tables one after the other.
template <std::floating_point T>
class OperandPatches {
 public:
  /// @throws Error if there are more patches than 32-bit ids can count.
  explicit OperandPatches(std::span<const Solid<T>> operands);

  /// Converts an owner that an operand returned to the composite's numbering.
  [[nodiscard]] SurfaceOwner counted(SurfaceOwner owner, std::size_t operand) const;
  /// The names of all patches, given the same operands.
  [[nodiscard]] static std::vector<std::string> names(std::span<const Solid<T>> operands);

 private:
  std::vector<std::uint32_t> firstPatch_;
};

extern template class OperandPatches<float>;
extern template class OperandPatches<double>;

}  // namespace cutwater::detail
