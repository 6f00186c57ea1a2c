#pragma once

#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/OperandPatches.hpp>

#include <array>

namespace cutwater {

/// Base of shapes with two operands, whose values at a point a subclass combines into its own.
///
/// The patch at a surface point is that of the operand whose value there is nearer to zero, or of
/// the first one if both are equally near.
template <std::floating_point T>
class BinaryOperation : public SignedDistanceFunction<T> {
 protected:
  BinaryOperation(Solid<T> first, Solid<T> second);

  /// The operands: number 0 and number 1.
  [[nodiscard]] const Solid<T>& first() const { return operands_[0]; }
  [[nodiscard]] const Solid<T>& second() const { return operands_[1]; }
  [[nodiscard]] const Solid<T>& operand(std::size_t i) const { return operands_[i]; }
  /// A box outside which both values are at least the distance to it.
  [[nodiscard]] Box<T> clearanceOfBoth() const {
    return detail::clearanceBoxOf<T>(operands_, /*least=*/true);
  }
  [[nodiscard]] SurfaceOwner counted(SurfaceOwner owner, std::size_t operand) const {
    return patches_.counted(owner, operand);
  }

  /// The value, given those of the two operands.
  [[nodiscard]] virtual T combined(T a, T b) const = 0;
  /// Encloses combined(), both exact and as computed, for all operand values in these intervals.
  [[nodiscard]] virtual Interval<T> combined(const Interval<T>& a, const Interval<T>& b) const = 0;

  T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  std::vector<std::string> localPatchNames() const override;
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
