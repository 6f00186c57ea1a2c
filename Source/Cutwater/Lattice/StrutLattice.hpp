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

/// A lattice without end: unit cells of this size at all multiples of it.
///
/// The library chooses how: by folding, in a few nanoseconds, where the cell has mirrors (see
/// CellFold), and equal sizes along the axes that they exchange; otherwise by a search of
/// neighbouring cells.
///
/// @throws Error unless sizes are positive and ordinary, and 0 < radius < infinity.
template <std::floating_point T>
class PeriodicLattice final : public StrutLattice<T> {
 public:
  PeriodicLattice(UnitCell cell, const Vec3<T>& size, T radius)
      : StrutLattice<T>("PeriodicLattice", std::move(cell), {.period = size}, radius) {}
};

/// An array of unit cells, in a box from the origin: all struts whose middles lie in the closed
/// box.
///
/// The same solid as explicit beams for each strut (see BeamGraph), whatever the number of cells:
/// at its ends struts are round, not cut off. Endless along axes where the count is 0.
///
/// @throws Error unless sizes are positive and ordinary, and 0 < radius < infinity; of kind Limit
/// beyond 2^20 cells along an axis.
template <std::floating_point T>
class CellArray final : public StrutLattice<T> {
 public:
  CellArray(UnitCell cell, const Repeats<T>& cells, T radius)
      : StrutLattice<T>("CellArray", std::move(cell), cells, radius) {}
};

extern template class StrutLattice<float>;
extern template class StrutLattice<double>;

}  // namespace cutwater
