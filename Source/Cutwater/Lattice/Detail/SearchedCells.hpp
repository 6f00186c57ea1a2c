#pragma once

#include <Cutwater/Core/Detail/Copies.hpp>
#include <Cutwater/Lattice/Detail/Skeleton.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>

namespace cutwater::detail {

/// The skeleton of an array of cells of any kind, finite or endless: cells are tried from the
/// nearest outwards, while the box around a cell's struts is nearer than the best so far. No memory
/// is needed for the cells, as the struts of one are those of all.
///
/// A strut is part of the array if its midpoint lies in the closed box of the cells, so that one on
/// a face shared by cells occurs once.
template <std::floating_point T>
class SearchedCells {
 public:
  /// `cells`: must have positive periods.
  SearchedCells(const UnitCell& cell, const Repeats<T>& cells);

  [[nodiscard]] SkeletonPoint<T> nearest(const Vec3<T>& p) const;
  /// Box around all struts; infinite where cells are endless.
  [[nodiscard]] Box<T> box() const;

 private:
  struct Strut {
    StrutAxis<T> axis;
    Vec3<T> middle;
    std::uint32_t strut;
  };
  /// Struts that occur in equally many cells: those with midpoints in lower faces, which are the
  /// upper faces of the previous cells, occur in one more along an axis.
  struct Group {
    Copies<T> copies;
    std::vector<Strut> struts;
  };

  std::vector<Group> groups_;
};

extern template class SearchedCells<float>;
extern template class SearchedCells<double>;

}  // namespace cutwater::detail
