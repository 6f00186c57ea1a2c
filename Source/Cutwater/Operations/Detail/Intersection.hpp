#pragma once

#include <Cutwater/Operations/Detail/Combination.hpp>

namespace cutwater {

/// All points common to the operands. The difference a - b is the intersection of a with the
/// complement of b.
///
///     f(p) = max_i f_i(p)        exact inside if all operands are, at least a lower bound outside
/// @throws Error unless there is at least one operand.
template <std::floating_point T>
class Intersection final : public Combination<T> {
 public:
  /// `beginning`: if given, an intersection of the first of these operands; it only saves time.
  explicit Intersection(std::vector<Solid<T>> operands, const Intersection* beginning = nullptr)
      : Combination<T>("Intersection", Combination<T>::Decides::Greatest, std::move(operands),
                       beginning) {}
};

}  // namespace cutwater
