#pragma once

#include <Cutwater/Operations/Detail/Mirror.hpp>

namespace cutwater {

/// The part of the operand on the side of a plane that the normal points to, together with its
/// mirror image: symmetric about the plane, at the cost of one query.
///
///     f(p) = g(p),            (p - point) . normal >= 0
///     f(p) = g(mirrored p)    otherwise
///
/// A lower bound if the operand's value is one. Exact outside if the operand is and its bounding
/// box lies on the kept side; exact inside as well if the box does not touch the plane.
/// @throws Error unless point and normal are finite and the normal is not zero.
template <std::floating_point T>
class Fold final : public PointMap<T> {
 public:
  Fold(Solid<T> operand, const Vec3<T>& point, const Vec3<T>& normal);

 private:
  std::string localName() const override { return "Fold"; }
  Vec3<T> mapped(const Vec3<T>& p) const override;
  OrientedBox<T> mapped(const OrientedBox<T>& box) const override;
  Vec3<T> pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override;

  /// The side on which the whole box lies, allowing for rounding: 1 for the kept one, -1 for the
  /// other, 0 if unknown.
  [[nodiscard]] int sideOf(const OrientedBox<T>& box) const;
  /// The least height of the box's corners above the plane, positive on the kept side.
  [[nodiscard]] T leastHeight(const Box<T>& box) const;

  detail::MirrorPlane<T> plane_;
};

extern template class Fold<float>;
extern template class Fold<double>;

}  // namespace cutwater
