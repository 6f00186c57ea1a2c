#pragma once

#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// One operand, to which everything is passed on that a subclass does not change.
template <std::floating_point T>
class UnaryOperation : public SignedDistanceFunction<T> {
 protected:
  explicit UnaryOperation(Solid<T> operand) : operand_(std::move(operand)) {}

  [[nodiscard]] const Solid<T>& operand() const { return operand_; }

  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const override;
  [[nodiscard]] SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const override;
  [[nodiscard]] SurfaceOwner localOwner(const Vec3<T>& p) const override;
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override;
  [[nodiscard]] Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  [[nodiscard]] BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  [[nodiscard]] Guarantee<T> localGuarantee() const override { return operand_.guarantee(); }
  [[nodiscard]] Box<T> localBoundingBox() const override { return operand_.boundingBox(); }
  [[nodiscard]] std::vector<std::string> localPatchNames() const override;
  void forEachOperand(FunctionRef<void(const SignedDistanceFunction<T>&)> visit) const override {
    visit(operand_);
  }

 private:
  Solid<T> operand_;
};

extern template class UnaryOperation<float>;
extern template class UnaryOperation<double>;

}  // namespace cutwater
