#pragma once

#include <Cutwater/Operations/Detail/Composite.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>

namespace cutwater {

/// Base of operators on two operands, whose values at a point a subclass combines into its own.
///
/// The patch at a surface point is that of the operand whose value there is nearer to zero, or of
/// the first one if both are equally near.
template <std::floating_point T>
class BinaryOperation : public Composite<T, std::array<Solid<T>, 2>> {
 protected:
  BinaryOperation(Solid<T> first, Solid<T> second)
      : Composite<T, std::array<Solid<T>, 2>>({std::move(first), std::move(second)}) {}

  /// The operands: number 0 and number 1.
  [[nodiscard]] const Solid<T>& first() const { return this->operand(0); }
  [[nodiscard]] const Solid<T>& second() const { return this->operand(1); }
  /// A box outside which both values are at least the distance to it.
  [[nodiscard]] Box<T> clearanceOfBoth() const {
    return detail::clearanceBoxOf<T>(this->operands(), /*least=*/true);
  }

  /// The value, given those of the two operands.
  [[nodiscard]] virtual T combined(T a, T b) const = 0;
  /// Encloses combined(), both exact and as computed, for all operand values in these intervals.
  [[nodiscard]] virtual Interval<T> combined(const Interval<T>& a, const Interval<T>& b) const = 0;

  T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
};

extern template class BinaryOperation<float>;
extern template class BinaryOperation<double>;

}  // namespace cutwater
