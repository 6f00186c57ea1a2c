#pragma once

#include <Cutwater/Sdf/Solid.hpp>

#include <array>
#include <vector>

namespace cutwater {

/// Base of operators on several operands: holds them, and numbers their patches one after the
/// other. `Operands`: a vector; or an array, of two, which saves each query a step.
template <std::floating_point T, typename Operands = std::vector<Solid<T>>>
class Composite : public SignedDistanceFunction<T> {
 public:
  [[nodiscard]] const Operands& operands() const { return operands_; }

 protected:
  /// @throws Error if there are more patches than 32-bit ids can count.
  explicit Composite(Operands operands);

  [[nodiscard]] const Solid<T>& operand(std::size_t i) const { return operands_[i]; }
  [[nodiscard]] std::size_t count() const { return operands_.size(); }
  /// Converts an owner that an operand returned to this solid's numbering.
  [[nodiscard]] SurfaceOwner counted(SurfaceOwner owner, std::size_t operand) const;

  std::vector<std::string> localPatchNames() const override;
  void forEachOperand(FunctionRef<void(const SignedDistanceFunction<T>&)> visit) const override {
    for (const auto& operand : operands_) visit(operand);
  }

 private:
  Operands operands_;
  std::vector<std::uint32_t> firstPatch_;
};

extern template class Composite<float>;
extern template class Composite<double>;
extern template class Composite<float, std::array<Solid<float>, 2>>;
extern template class Composite<double, std::array<Solid<double>, 2>>;

}  // namespace cutwater
