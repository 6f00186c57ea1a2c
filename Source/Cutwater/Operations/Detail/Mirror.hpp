#pragma once

#include <Cutwater/Core/AffineMap.hpp>
#include <Cutwater/Operations/Detail/PointMap.hpp>

namespace cutwater {

namespace detail {

/// A mirror plane.
template <std::floating_point T>
class MirrorPlane {
 public:
  /// The normal need not have unit length; `name` is that of the operator, for messages.
  /// @throws Error unless both are finite and the normal is not zero.
  MirrorPlane(const char* name, const Vec3<T>& point, const Vec3<T>& normal);

  /// The mirror image of p. Rounding moves it by at most 14 eps (|p| + |point|).
  [[nodiscard]] Vec3<T> image(const Vec3<T>& p) const;
  [[nodiscard]] Vec3<T> imageOfDirection(const Vec3<T>& v) const;
  /// Encloses the images of all points of the box, both exact and as computed.
  [[nodiscard]] OrientedBox<T> image(const OrientedBox<T>& box) const;
  [[nodiscard]] SurfacePoint<T> image(SurfacePoint<T> found, const Vec3<T>& from) const;
  [[nodiscard]] AffineMap<T> map() const;

  /// Height of p above the plane, positive on the side that the normal points to.
  [[nodiscard]] T height(const Vec3<T>& p) const;
  [[nodiscard]] const Vec3<T>& point() const { return point_; }
  [[nodiscard]] const Vec3<T>& normal() const { return normal_; }
  /// The image of p has a length of at most |p| + reach().
  [[nodiscard]] T reach() const;

  bool operator==(const MirrorPlane&) const = default;

 private:
  Vec3<T> point_;
  Vec3<T> normal_;  // unit
};

extern template class MirrorPlane<float>;
extern template class MirrorPlane<double>;

}  // namespace detail

/// The operand's mirror image.
///
///     f(p) = g(p - 2 ((p - point) . normal) normal)        keeps what the operand guarantees
///
/// The normal need not have unit length. Exact for the planes x = 0, y = 0 and z = 0.
/// @throws Error unless point and normal are finite and the normal is not zero.
template <std::floating_point T>
class Mirror final : public PointMap<T> {
 public:
  Mirror(Solid<T> solid, const Vec3<T>& point, const Vec3<T>& normal);

  using UnaryOperation<T>::operand;
  [[nodiscard]] const detail::MirrorPlane<T>& plane() const { return plane_; }

 private:
  std::string localName() const override { return "Mirror image"; }
  Vec3<T> mapped(const Vec3<T>& p) const override;
  OrientedBox<T> mapped(const OrientedBox<T>& box) const override;
  Vec3<T> pulledBack(const Vec3<T>& p, const Vec3<T>& gradient) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;
  Box<T> localClearanceBox() const override;

  detail::MirrorPlane<T> plane_;
};

extern template class Mirror<float>;
extern template class Mirror<double>;

}  // namespace cutwater
