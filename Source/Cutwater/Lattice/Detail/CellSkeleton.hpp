#pragma once

#include <Cutwater/Lattice/Detail/FoldedCells.hpp>
#include <Cutwater/Lattice/Detail/SearchedCells.hpp>

#include <optional>

namespace cutwater::detail {

/// The skeleton of cells, endless or finite in number along each axis: found by folding where the
/// cell has mirrors, and otherwise by a search of neighbouring cells. The search also takes over
/// where folding finds a strut beyond the ends of a finite array.
template <std::floating_point T>
class CellSkeleton {
 public:
  /// @throws Error unless periods are from 1e-100 to 1e100 (float: from 1e-15 to 1e15).
  CellSkeleton(const UnitCell& cell, const Repeats<T>& cells);

  [[nodiscard]] T distance(const Vec3<T>& p) const;
  void distances(std::span<const Vec3<T>> points, std::span<T> distances) const;
  [[nodiscard]] SkeletonPoint<T> nearest(const Vec3<T>& p) const;

  [[nodiscard]] Box<T> box() const { return searched_.box(); }
  [[nodiscard]] const Repeats<T>& cells() const { return cells_; }
  [[nodiscard]] bool isEndless() const { return isEndless_; }

 private:
  /// Whether a strut of the endless lattice is certainly part of the array.
  [[nodiscard]] bool contains(const Vec3<T>& middle) const;
  /// Error of a strut's midpoint, in cells, up to which it still determines the cell.
  [[nodiscard]] static T clearance(const UnitCell& cell);

  Repeats<T> cells_;
  bool isEndless_;
  SearchedCells<T> searched_;
  std::optional<FoldedCells<T>> folded_;
  T clearance_ = 0;
};

extern template class CellSkeleton<float>;
extern template class CellSkeleton<double>;

}  // namespace cutwater::detail
