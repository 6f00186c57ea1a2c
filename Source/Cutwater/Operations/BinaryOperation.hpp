#pragma once

#include <Cutwater/Operations/DerivedGuarantee.hpp>
#include <Cutwater/Operations/OperandPatches.hpp>

#include <array>

namespace cutwater {

/// Two operands, whose values at the point a subclass combines into its own.
///
/// The patch at a surface point is that of the operand whose value there is nearest to zero; of
/// equal ones the first.
template <std::floating_point T>
class BinaryOperation : public SignedDistanceFunction<T> {
 protected:
  BinaryOperation(Solid<T> first, Solid<T> second);

  /// The operands: number 0 and number 1.
  [[nodiscard]] const Solid<T>& first() const { return operands_[0]; }
  [[nodiscard]] const Solid<T>& second() const { return operands_[1]; }
  [[nodiscard]] const Solid<T>& operand(std::size_t i) const { return operands_[i]; }
  /// Beyond it both values are at least the distance to it.
  [[nodiscard]] Box<T> clearanceOfBoth() const {
    return detail::clearanceBoxOf<T>(operands_, /*least=*/true);
  }
  [[nodiscard]] SurfaceOwner counted(SurfaceOwner owner, std::size_t operand) const {
    return patches_.counted(owner, operand);
  }

  /// The value, from those of the two.
  [[nodiscard]] virtual T combined(T a, T b) const = 0;
  /// Encloses combined(), exact and as computed, for all values of the two in these intervals.
  [[nodiscard]] virtual Interval<T> combined(const Interval<T>& a, const Interval<T>& b) const = 0;

  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  [[nodiscard]] SurfaceOwner localOwner(const Vec3<T>& p) const override;
  [[nodiscard]] Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  [[nodiscard]] std::vector<std::string> localPatchNames() const override;
  void forEachOperand(FunctionRef<void(const SignedDistanceFunction<T>&)> visit) const override {
    for (const auto& operand : operands_) visit(operand);
  }

 private:
  std::array<Solid<T>, 2> operands_;
  detail::OperandPatches<T> patches_;
};

extern template class BinaryOperation<float>;
extern template class BinaryOperation<double>;

}  // namespace cutwater
