#pragma once

#include <Cutwater/Core/AffineMap.hpp>
#include <Cutwater/Operations/Detail/PointMap.hpp>

namespace cutwater {

/// The operand stretched, sheared or mirrored by any invertible affine map x = A y + offset.
///
///     f(p) = g(A^-1 (p - offset)) s        a lower bound if the operand's value is one
///
/// where s is the smallest singular value of A: no distance shrinks by more. (Without it, values
/// would not be bounds where A makes the solid smaller.) For rigid motions, uniform scaling and
/// mirroring there are operators that keep values exact.
///
/// @throws Error unless the map is finite and invertible in T: its condition number must be less
/// than 1 / (64 eps).
template <std::floating_point T>
class Affine final : public PointMap<T> {
 public:
  Affine(Solid<T> operand, const AffineMap<T>& map);

 private:
  std::string localName() const override { return "Affine image"; }
  Vec3<T> mapped(const Vec3<T>& p) const override;
  OrientedBox<T> mapped(const OrientedBox<T>& box) const override;
  Vec3<T> pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const override;
  T factor() const override { return leastStretch_; }
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  /// The image of the box under the matrix of the inverse; a parallelepiped in general.
  [[nodiscard]] OrientedBox<T> image(const OrientedBox<T>& box) const;
  [[nodiscard]] static bool isRectangular(const OrientedBox<T>& box);

  AffineMap<T> map_;
  AffineMap<T> inverse_;  // its matrix only; the offset is subtracted first
  T leastStretch_;
  T condition_;
};

extern template class Affine<float>;
extern template class Affine<double>;

}  // namespace cutwater
