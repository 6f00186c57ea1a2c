#pragma once

#include <Cutwater/Operations/Detail/Combination.hpp>

namespace cutwater {

/// All points of any of the operands.
///
///     f(p) = min_i f_i(p)        exact outside if all operands are, at least a lower bound inside
///
/// Where two solids touch face to face, the shared face stays as a surface of value 0.
/// @throws Error unless there is at least one operand.
template <std::floating_point T>
class Union final : public Combination<T> {
 public:
  /// `beginning`: if given, a union of the first of these operands; it only saves time.
  explicit Union(std::vector<Solid<T>> operands, const Union* beginning = nullptr)
      : Combination<T>("Union", Combination<T>::Decides::Least, std::move(operands), beginning) {}
};

}  // namespace cutwater
