#pragma once

#include <Cutwater/Operations/Detail/Composite.hpp>
#include <Cutwater/Operations/Detail/OperandTree.hpp>

namespace cutwater {

/// The union or the intersection of any number of solids. The value is that of the deciding
/// operand, which is the one with the least or the greatest value; the first such one if values are
/// equal.
///
///     f(p) = min_i f_i(p)        all points of any of the operands
///     f(p) = max_i f_i(p)        all points common to the operands
///
/// The difference a - b is the intersection of a with the complement of b. Where two solids touch
/// face to face, the shared face stays as a surface of value 0.
///
/// Closest point, owner and gradient are those of the deciding operand. SurfaceOwner::object is its
/// index; patches are numbered through the operands' tables one after the other. A closest point
/// that lies inside another operand, and so not on the surface, is replaced by a projection along
/// the gradient.
///
/// With few operands, a query costs one query of each. With many, a tree over their boxes finds
/// those with a finite clearanceBox(), and most of them are skipped. In an intersection this
/// includes complements of such operands, which differences subtract. Results are the same, to the
/// bit: see OperandTree.
///
/// The least value is exact outside and a lower bound inside, the greatest the other way round,
/// provided that the operands' values are.
template <std::floating_point T>
class Combination final : public Composite<T> {
 public:
  /// Which of the operands' values decides.
  enum class Decides : std::uint8_t { Least, Greatest };

  /// `beginning`: a combination of the same kind of the first of these operands, whose tree may be
  /// reused, which saves time; or null.
  /// @throws Error unless there is at least one operand.
  Combination(Decides decides, std::vector<Solid<T>> operands,
              const Combination* beginning = nullptr);

  [[nodiscard]] Decides decides() const { return decides_; }

 private:
  using Composite<T>::operand;
  using Composite<T>::count;

  T localSignedDistance(const Vec3<T>& p) const override;
  T localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  void localCrossingsOfEach(std::span<const Segment<T>> segments, std::span<CrossingCount> counts,
                            CrossingsVisitor<T> visit) const override {
    this->crossingsByValues(segments, counts, visit);
  }
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  Box<T> localBoundingBox() const override { return boundingBox_; }
  Box<T> localClearanceBox() const override { return clearanceBox_; }
  std::string localName() const override { return nameOf(decides_); }

  [[nodiscard]] static std::string nameOf(Decides decides) {
    return decides == Decides::Least ? "Union" : "Intersection";
  }
  /// Factor, 1 or -1, that turns a greatest value into a least one; exact.
  [[nodiscard]] T side() const { return decides_ == Decides::Least ? T(1) : T(-1); }
  struct Decision {
    std::size_t operand;
    T value;
  };
  [[nodiscard]] Decision decide(const Vec3<T>& p) const {
    return decide(p, Interval<T>::everything());
  }
  /// `wanted`: as for localSignedDistanceWithin(), but for values times side().
  [[nodiscard]] Decision decide(const Vec3<T>& p, Interval<T> wanted) const;
  /// The operand's value times side(), if it is within `wanted`.
  [[nodiscard]] T sidedValue(std::size_t i, const Vec3<T>& p, const Interval<T>& wanted) const {
    const auto ofOperand = decides_ == Decides::Least ? wanted : -wanted;
    return side() * operand(i).signedDistanceWithin(p, ofOperand);
  }
  /// The deciding value, given that of the operands that are always evaluated.
  [[nodiscard]] T decidingValue(const Vec3<T>& p, T ofAlwaysAsked) const;
  /// Whether an operand of a union may be negative in the whole box; always true for intersections.
  [[nodiscard]] bool mayContain(std::size_t i, const Box<T>& box) const;
  template <typename Ask>
  void forEachNear(const OrientedBox<T>& box, double limit, Ask&& ask) const;
  /// Finds each point's closest point on the operand that decides there, as that operand returns
  /// it.
  void askDeciding(std::span<const Vec3<T>> points, std::span<const Decision> decisions,
                   std::span<SurfacePoint<T>> found) const;
  /// The closest point to `p`, given the one found on the deciding operand and the value there,
  /// `residual`.
  [[nodiscard]] SurfacePoint<T> checked(const Vec3<T>& p, const Decision& decision,
                                        SurfacePoint<T> found, T residual) const;

  Decides decides_;
  Guarantee<T> guarantee_;
  Box<T> boundingBox_;
  Box<T> clearanceBox_;
  detail::OperandTree<T> tree_;
};

extern template class Combination<float>;
extern template class Combination<double>;

}  // namespace cutwater
