#pragma once

#include <Cutwater/Lattice/CellSkeleton.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// All points within a radius of the struts of repeated unit cells: the union of a capsule about
/// each strut. What PeriodicLattice and CellArray share.
///
///     f(p) = |p - nearest point of the skeleton| - radius
///
/// Exact outside, and a lower bound inside, where struts overlap. Nothing is stored but the struts
/// of one cell. Cells begin at the origin of the lattice's own frame.
template <std::floating_point T>
class StrutLattice : public SignedDistanceFunction<T> {
 public:
  /// The nearest point of the struts' axes, about the solid where it stands now. Unless `p` is
  /// finite, none.
  [[nodiscard]] SkeletonPoint<T> skeletonPoint(const Vec3<T>& p) const;

  [[nodiscard]] const UnitCell& cell() const { return cell_; }
  [[nodiscard]] const Repeats<T>& cells() const { return skeleton_.cells(); }
  [[nodiscard]] T radius() const { return radius_; }

 protected:
  /// @throws Error, as from the lattice `name`, unless sizes are positive and ordinary, and
  /// 0 < radius < infinity; of kind Limit beyond 2^20 cells along an axis.
  StrutLattice(const char* name, UnitCell cell, const Repeats<T>& cells, T radius);

 private:
  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const final;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const final;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const final;
  [[nodiscard]] SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const final;
  [[nodiscard]] Guarantee<T> localGuarantee() const final { return guarantee_; }
  [[nodiscard]] Box<T> localBoundingBox() const final;
  [[nodiscard]] std::string localName() const final;

  /// The value where the skeleton is so far away.
  [[nodiscard]] T value(T distance) const { return distance - radius_; }

  UnitCell cell_;
  detail::CellSkeleton<T> skeleton_;
  T radius_;
  Guarantee<T> guarantee_;
};

extern template class StrutLattice<float>;
extern template class StrutLattice<double>;

}  // namespace cutwater
