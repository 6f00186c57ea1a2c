#pragma once

#include <Cutwater/Core/Repeats.hpp>
#include <Cutwater/Lattice/Thickness.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>

#include <memory>

namespace cutwater {

namespace detail {
template <std::floating_point T>
class CellSkeleton;
}  // namespace detail

/// The point of a lattice's skeleton, the axes of its struts, that is nearest to a query point.
template <std::floating_point T>
struct SkeletonPoint {
  T distance = std::numeric_limits<T>::infinity();  ///< of the query point from it
  Vec3<T> away;                                     ///< from it to the query point
  std::uint32_t strut = kNone;  ///< index into UnitCell::struts(), of the strut or its mirror image
  Vec3<T> middle;               ///< of that strut
};

/// All points within a radius of the struts of repeated unit cells: an endless lattice, or an array
/// of cells in a box from the origin.
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
/// An array has all struts whose midpoints lie in its closed box: it is the same solid as explicit
/// beams for each strut (see beamsOf()), whose ends are round, not cut off.
///
/// Only the struts of one cell are stored. Distances are found by folding, in tens of nanoseconds,
/// if the cell has mirrors (see CellFold) and equal sizes along axes that its mirrors swap;
/// otherwise, and at the ends of an array, by a search of neighbouring cells. Copies share what is
/// stored.
template <std::floating_point T>
class PeriodicLattice final : public SignedDistanceFunction<T> {
 public:
  /// Endless: cells of this size at all multiples of it.
  /// @throws Error unless sizes are from 1e-100 to 1e100 (float: from 1e-15 to 1e15).
  PeriodicLattice(UnitCell cell, const Vec3<T>& size, Thickness<T> thickness);
  /// As many cells along each axis as counted, from the origin; endless along axes whose count is
  /// 0.
  /// @throws Error as above; of kind Limit beyond 2^20 cells along an axis.
  PeriodicLattice(UnitCell cell, const Repeats<T>& cells, Thickness<T> thickness);

  /// The nearest point of the struts' axes, with the solid in its current placement; none unless
  /// `p` is finite.
  [[nodiscard]] SkeletonPoint<T> skeletonPoint(const Vec3<T>& p) const;

  /// What the lattice was made from; counts are 0 along endless axes.
  [[nodiscard]] const UnitCell& cell() const { return cell_; }
  [[nodiscard]] const Repeats<T>& cells() const { return cells_; }
  [[nodiscard]] const Thickness<T>& thickness() const { return thickness_; }

 private:
  T localSignedDistance(const Vec3<T>& p) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  Box<T> localBoundingBox() const override;
  std::string localName() const override;

  /// The value at p, given the distance to the skeleton.
  [[nodiscard]] T value(const Vec3<T>& p, T distance) const {
    return thickness_.isConstant() ? distance - thickness_.most() : gradedValue(p, distance);
  }
  [[nodiscard]] T gradedValue(const Vec3<T>& p, T distance) const;

  UnitCell cell_;
  Repeats<T> cells_;
  std::shared_ptr<const detail::CellSkeleton<T>> skeleton_;
  Thickness<T> thickness_;
  T slope_ = 1;  // 1 + L
  Guarantee<T> guarantee_;
};

extern template class PeriodicLattice<float>;
extern template class PeriodicLattice<double>;

}  // namespace cutwater
