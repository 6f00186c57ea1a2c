#pragma once

#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// Base of shapes with one operand, whose patches are theirs, too.
template <std::floating_point T>
class UnaryOperation : public SignedDistanceFunction<T> {
 protected:
  explicit UnaryOperation(Solid<T> operand) : operand_(std::move(operand)) {}

  [[nodiscard]] const Solid<T>& operand() const { return operand_; }

  /// For localSignedDistanceWithin() of a function factor g(q), with a positive factor: encloses
  /// the operand's values for which it may be within `wanted`, despite rounding.
  [[nodiscard]] static Interval<T> wantedOverFactor(const Interval<T>& wanted, T factor);
  /// The operand's results at many points of its own frame, from within a parallel region.
  void operandValues(std::span<const Vec3<T>> points, std::span<T> distances) const {
    operand_.signedDistances(points, distances, {.threads = 1});
  }
  void operandPoints(std::span<const Vec3<T>> points, std::span<SurfacePoint<T>> results) const {
    operand_.closestPoints(points, results, {.threads = 1});
  }

  std::vector<std::string> localPatchNames() const override;
  void forEachOperand(FunctionRef<void(const SignedDistanceFunction<T>&)> visit) const override {
    visit(operand_);
  }

 private:
  Solid<T> operand_;
};

extern template class UnaryOperation<float>;
extern template class UnaryOperation<double>;

}  // namespace cutwater
