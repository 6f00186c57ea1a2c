#pragma once

#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// All points that are not in the operand.
///
///     f(p) = -g(p)        as good inside as the operand is outside, and vice versa
///
/// Points of value 0 are outside both, as for any solid.
template <std::floating_point T>
class Complement final : public UnaryOperation<T> {
 public:
  explicit Complement(Solid<T> solid) : UnaryOperation<T>(std::move(solid)) {}

  using UnaryOperation<T>::operand;

 private:
  std::string localName() const override { return "Complement"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  T localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override { return this->operand().owner(p); }
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override { return Box<T>::everywhere(); }

  [[nodiscard]] static SurfacePoint<T> turned(SurfacePoint<T> found);
};

extern template class Complement<float>;
extern template class Complement<double>;

}  // namespace cutwater
