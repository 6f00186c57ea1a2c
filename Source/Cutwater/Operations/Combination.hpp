#pragma once

#include <Cutwater/Operations/OperandPatches.hpp>
#include <Cutwater/Operations/OperandTree.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <vector>

namespace cutwater {

/// What union and intersection share: the value of the operand that decides, which is the least or
/// the greatest; of equal ones the first.
///
/// Closest point, owner and gradient are those of the deciding operand: SurfaceOwner::object is its
/// index, patches are counted through the operands' tables one after the other. A closest point
/// that lies within another operand, and so not on the surface, is replaced by a projection along
/// the gradient.
///
/// A query costs one per operand if there are few. Of many, those with a finite clearanceBox() are
/// found by a tree over their boxes, and most are not asked; so are, in an intersection, the
/// complements of such, which differences take away. Answers are the same, to the bit: see
/// OperandTree.
///
/// A least value is exact outside and a lower bound inside, a greatest the other way round, as far
/// as the operands are.
template <std::floating_point T>
class Combination : public SignedDistanceFunction<T> {
 public:
  /// Which of the values it has.
  enum class Decides : std::uint8_t { Least, Greatest };

  [[nodiscard]] const std::vector<Solid<T>>& operands() const { return operands_; }
  [[nodiscard]] Decides decides() const { return decides_; }

 protected:
  /// `beginning`: a combination of the first of the operands, whose tree may serve; or null.
  /// @throws Error unless there is at least one operand.
  Combination(const char* name, Decides decides, std::vector<Solid<T>> operands,
              const Combination* beginning);

 private:
  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const final;
  [[nodiscard]] T localSignedDistanceWithin(const Vec3<T>& p,
                                            const Interval<T>& wanted) const final;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const final;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const final;
  [[nodiscard]] SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const final;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const final;
  [[nodiscard]] SurfaceOwner localOwner(const Vec3<T>& p) const final;
  [[nodiscard]] Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const final;
  [[nodiscard]] BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const final;
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const final;
  [[nodiscard]] Guarantee<T> localGuarantee() const final { return guarantee_; }
  [[nodiscard]] Box<T> localBoundingBox() const final { return boundingBox_; }
  [[nodiscard]] Box<T> localClearanceBox() const final { return clearanceBox_; }
  [[nodiscard]] std::vector<std::string> localPatchNames() const final;
  [[nodiscard]] std::string localName() const final {
    return decides_ == Decides::Least ? "Union" : "Intersection";
  }
  void forEachOperand(FunctionRef<void(const SignedDistanceFunction<T>&)> visit) const final {
    for (const auto& operand : operands_) visit(operand);
  }

  /// -1 turns a greatest into a least; exact.
  [[nodiscard]] T side() const { return decides_ == Decides::Least ? T(1) : T(-1); }
  struct Decision {
    std::size_t operand;
    T value;
  };
  [[nodiscard]] Decision decide(const Vec3<T>& p) const {
    return decide(p, Interval<T>::everything());
  }
  /// `wanted` as for localSignedDistanceWithin(), of the values times side().
  [[nodiscard]] Decision decide(const Vec3<T>& p, Interval<T> wanted) const;
  /// The operand's value times side(), if that is wanted.
  [[nodiscard]] T sidedValue(std::size_t operand, const Vec3<T>& p,
                             const Interval<T>& wanted) const {
    const auto ofOperand = decides_ == Decides::Least ? wanted : -wanted;
    return side() * operands_[operand].signedDistanceWithin(p, ofOperand);
  }
  /// The deciding value, if that of the operands that are always asked is known.
  [[nodiscard]] T decidingValue(const Vec3<T>& p, T ofAlwaysAsked) const;
  /// Whether an operand whose value is to be the least may be negative in all of the box.
  [[nodiscard]] bool mayContain(std::size_t operand, const Box<T>& box) const;
  template <typename Ask>
  void forEachNear(const OrientedBox<T>& box, double limit, Ask&& ask) const;
  /// Each point's closest point on the operand that decides there, as that operand tells it.
  void askDeciding(std::span<const Vec3<T>> points, std::span<const Decision> decisions,
                   std::span<SurfacePoint<T>> found) const;
  /// From the closest point of the operand that decides at `p`, and the value there.
  [[nodiscard]] SurfacePoint<T> checked(const Vec3<T>& p, const Decision& decision,
                                        SurfacePoint<T> found, T residual) const;

  Decides decides_;
  std::vector<Solid<T>> operands_;
  detail::OperandPatches<T> patches_;
  Guarantee<T> guarantee_;
  Box<T> boundingBox_;
  Box<T> clearanceBox_;
  detail::OperandTree<T> tree_;
};

extern template class Combination<float>;
extern template class Combination<double>;

}  // namespace cutwater
