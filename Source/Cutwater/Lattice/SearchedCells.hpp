#pragma once

#include <Cutwater/Lattice/Skeleton.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>
#include <Cutwater/Operations/Tiles.hpp>

namespace cutwater::detail {

/// The skeleton of an array of cells, of any kind, finite or endless: cells are tried from the
/// nearest on outwards, while the box around a cell's struts is nearer than the best so far.
/// Without memory, as the struts of one cell are those of all.
///
/// A strut is part of the array if its middle lies in the closed box of the cells, so that one on a
/// face that cells share is there once.
template <std::floating_point T>
class SearchedCells {
 public:
  /// `cells`: with positive periods.
  SearchedCells(const UnitCell& cell, const Repeats<T>& cells);

  [[nodiscard]] SkeletonPoint<T> nearest(const Vec3<T>& p) const;
  /// Around all struts; infinite where cells are endless.
  [[nodiscard]] Box<T> box() const;

 private:
  struct Strut {
    StrutAxis<T> axis;
    Vec3<T> middle;
    std::uint32_t strut;
  };
  /// Struts that as many cells have: those with middles in lower faces, which are the upper faces
  /// of the cells before, are in one more along an axis.
  struct Group {
    Tiles<T> tiles;
    std::vector<Strut> struts;
  };

  std::vector<Group> groups_;
};

extern template class SearchedCells<float>;
extern template class SearchedCells<double>;

}  // namespace cutwater::detail
