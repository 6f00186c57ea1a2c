#pragma once

#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// The operand under a name. If all its patches share one name, they take the new one; otherwise
/// each name is prefixed with it, as in "mast/shroud". Nothing else changes.
///
/// @throws Error if the name is empty.
template <std::floating_point T>
class Labelled final : public UnaryOperation<T> {
 public:
  Labelled(Solid<T> operand, std::string name);

 private:
  std::string localName() const override { return "Named \"" + name_ + "\""; }
  T localSignedDistance(const Vec3<T>& p) const override;
  T localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override { return this->operand().guarantee(); }
  Box<T> localBoundingBox() const override { return this->operand().boundingBox(); }
  Box<T> localClearanceBox() const override { return this->operand().clearanceBox(); }
  std::vector<std::string> localPatchNames() const override;

  std::string name_;
};

extern template class Labelled<float>;
extern template class Labelled<double>;

}  // namespace cutwater
