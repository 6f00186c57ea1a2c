#pragma once

#include <Cutwater/Operations/Detail/BinaryOperation.hpp>

namespace cutwater {

/// All points of one of the operands, but not of both (xor).
///
///     f(p) = max(min(a, b), -max(a, b))        |f| = min(|a|, |b|): exact if both operands are
///
/// The surface is that of both operands together, except where the two coincide: there a value of 0
/// remains although both sides are outside, as between two solids that touch in a union, and nearby
/// values are only lower bounds. A box is never classified as cut because of such a place.
template <std::floating_point T>
class SymmetricDifference final : public BinaryOperation<T> {
 public:
  SymmetricDifference(Solid<T> a, Solid<T> b) : BinaryOperation<T>(std::move(a), std::move(b)) {}

 private:
  std::string localName() const override { return "Symmetric difference"; }
  T combined(T a, T b) const override;
  Interval<T> combined(const Interval<T>& a, const Interval<T>& b) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override {
    for (const auto& operand : this->operands()) this->surfacesOf(operand, box, visit);
    return true;
  }
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override { return this->clearanceOfBoth(); }

  /// The operand whose value is nearer to zero, and whose surface is therefore the nearest.
  struct Nearest {
    std::size_t operand;
    T value;     ///< of the symmetric difference
    bool turns;  ///< inside the other operand, where normals are reversed
  };
  [[nodiscard]] Nearest nearest(const Vec3<T>& p) const;
};

extern template class SymmetricDifference<float>;
extern template class SymmetricDifference<double>;

}  // namespace cutwater
