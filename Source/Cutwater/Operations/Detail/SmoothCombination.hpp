#pragma once

#include <Cutwater/Operations/Detail/Composite.hpp>
#include <Cutwater/Operations/Detail/OperandTree.hpp>
#include <Cutwater/Operations/Smoothing.hpp>

namespace cutwater {

/// The union or intersection of any number of solids, with rounded edges where they meet.
///
/// The operands' values at the point are combined by a smooth minimum in ascending order; equal
/// ones in the order of the operands. An intersection is the complement of the union of the
/// complements. Every operand within reach counts, however many there are. Exponential sums over
/// all operands in their order.
///
/// The solid is where the value is negative. A union is larger than the plain one: with reach k,
/// its value is lower by at most k/4 (Quadratic), k/6 (Cubic) or k (1 - sqrt(1/2)) (Circular) for
/// two operands, by less than k for any number, and by at most k ln N for Exponential. The value is
/// a lower bound of the distance on both sides if the operands' Lipschitz constants are at most 1,
/// which the weights preserve.
///
/// Patches are those of the operand with the least, or greatest, value. A query costs one query of
/// each operand. If there are many, those out of reach are skipped where the rules of OperandTree
/// allow, unless the kind is Exponential.
template <std::floating_point T>
class SmoothCombination final : public Composite<T> {
 public:
  /// What the result is without the fillets.
  enum class Result : std::uint8_t { Union, Intersection };

  /// @throws Error unless there is at least one operand, and the reach is finite and more than 0.
  SmoothCombination(Result result, std::vector<Solid<T>> operands, const Smoothing<T>& smoothing);

 private:
  using Composite<T>::count;

  T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  Box<T> localBoundingBox() const override { return boundingBox_; }
  Box<T> localClearanceBox() const override { return clearanceBox_; }
  std::string localName() const override {
    return result_ == Result::Union ? "Smooth union" : "Smooth intersection";
  }

  void deriveGuarantee();
  void deriveBoxes();

  /// Factor, 1 or -1, that turns an intersection into a union of complements; exact.
  [[nodiscard]] T side() const { return result_ == Result::Union ? T(1) : T(-1); }
  [[nodiscard]] bool isExponential() const { return smoothing_.kind == SmoothKind::Exponential; }

  /// Calls ask(operand) for all operands whose value at p, times side(), may be as low as the limit
  /// that ask() returns.
  template <typename Ask>
  void forEachAt(const Vec3<T>& p, T limit, Ask&& ask) const;
  /// The same for a lower bound in the box.
  template <typename Ask>
  void forEachIn(const OrientedBox<T>& box, T limit, Ask&& ask) const;
  /// The smooth minimum of the values; NaN if none is a number. each(limit, ask) calls ask(operand,
  /// value) at least for all values up to the limit that ask() returns; visit(operand, weight) is
  /// called for the operands that count, in order.
  template <typename Each, typename Visit>
  [[nodiscard]] T folded(Each&& each, Visit&& visit) const;
  template <typename Visit>
  [[nodiscard]] T foldedAt(const Vec3<T>& p, Visit&& visit) const;

  Result result_;
  Smoothing<T> smoothing_;
  Guarantee<T> guarantee_;
  Box<T> boundingBox_;
  Box<T> clearanceBox_;
  detail::OperandTree<T> tree_;
};

extern template class SmoothCombination<float>;
extern template class SmoothCombination<double>;

}  // namespace cutwater
