#pragma once

#include <Cutwater/Lattice/Detail/CellSkeleton.hpp>
#include <Cutwater/Lattice/Thickness.hpp>

namespace cutwater {

/// All points within a radius of the struts of repeated unit cells. Base of PeriodicLattice and
/// CellArray.
///
///     f(p) = |p - nearest point of the skeleton| - radius
///
/// The union of a capsule about each strut: exact outside, and a lower bound inside, where struts
/// overlap. If the lattice is graded, i.e. its radius depends on position, the solid is all points
/// that are nearer to the skeleton than the radius at these points, and
///
///     f(p) = (|p - nearest point of the skeleton| - radius(p)) / (1 + L)
///
/// where L is the Lipschitz constant of the radius: a lower bound on both sides.
///
/// Only the struts of one cell are stored. Cells begin at the origin of the lattice's own frame.
template <std::floating_point T>
class StrutLattice : public SignedDistanceFunction<T> {
 public:
  /// The nearest point of the struts' axes, with the solid in its current placement; none unless
  /// `p` is finite.
  [[nodiscard]] SkeletonPoint<T> skeletonPoint(const Vec3<T>& p) const;

  [[nodiscard]] const UnitCell& cell() const { return cell_; }
  [[nodiscard]] const Repeats<T>& cells() const { return skeleton_.cells(); }
  [[nodiscard]] const Thickness<T>& thickness() const { return thickness_; }

 protected:
  /// @throws Error unless sizes are positive and of ordinary magnitude; of kind Limit beyond 2^20
  /// cells along an axis.
  StrutLattice(UnitCell cell, const Repeats<T>& cells, Thickness<T> thickness);

 private:
  T localSignedDistance(const Vec3<T>& p) const final;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const final;
  Vec3<T> localGradient(const Vec3<T>& p) const final;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const final;
  Guarantee<T> localGuarantee() const final { return guarantee_; }
  Box<T> localBoundingBox() const final;
  std::string localName() const final;

  /// The value at p, given the distance to the skeleton.
  [[nodiscard]] T value(const Vec3<T>& p, T distance) const {
    return thickness_.isConstant() ? distance - thickness_.most() : gradedValue(p, distance);
  }
  [[nodiscard]] T gradedValue(const Vec3<T>& p, T distance) const;

  UnitCell cell_;
  detail::CellSkeleton<T> skeleton_;
  Thickness<T> thickness_;
  T slope_ = 1;  // 1 + L
  Guarantee<T> guarantee_;
};

extern template class StrutLattice<float>;
extern template class StrutLattice<double>;

}  // namespace cutwater
