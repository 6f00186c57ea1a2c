#pragma once

#include <Cutwater/Lattice/Detail/Skeleton.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>

namespace cutwater::detail {

/// The skeleton of an endless lattice that has mirrors: points are folded into a chamber between
/// them, where only a few struts have to be tried. A query takes tens of nanoseconds; only the
/// struts in the chamber are stored.
template <std::floating_point T>
class FoldedCells {
 public:
  /// `fold`: as returned by cell.foldAt(period), and not CellFold::None.
  FoldedCells(const UnitCell& cell, CellFold fold, const Vec3<T>& period);

  [[nodiscard]] T distance(const Vec3<T>& p) const;
  void distances(std::span<const Vec3<T>> points, std::span<T> distances) const;
  [[nodiscard]] SkeletonPoint<T> nearest(const Vec3<T>& p) const;

 private:
  struct Strut {
    StrutAxis<T> axis;
    std::uint32_t strut;
    Vec3<T> middle;
  };
  struct Found {
    T squared;
    const Strut* strut;
  };
  /// Calls answer(fold) with the fold as a type.
  template <typename Answer>
  auto withFold(Answer&& answer) const;
  [[nodiscard]] CUTWATER_INLINE Found leastInChamber(const Vec3<T>& p) const;

  CellFold fold_;
  Vec3<T> period_;
  Vec3<T> perPeriod_;
  std::vector<Strut> struts_;
};

extern template class FoldedCells<float>;
extern template class FoldedCells<double>;

}  // namespace cutwater::detail
