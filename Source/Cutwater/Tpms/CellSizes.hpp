#pragma once

#include <Cutwater/Core/Interval.hpp>

#include <cmath>
#include <vector>

namespace cutwater {

/// The size of cells at a place along an axis.
template <std::floating_point T>
struct CellSizeAt {
  T place;
  T size;
};

/// Sizes of cells along an axis, depending on the place. A value type.
///
/// Between the places given, 1/size is linear; beyond them it is constant. The number of cells up
/// to x is then the integral of 1/size, in closed form. (It is not x / size(x), whose error grows
/// with x.)
template <std::floating_point T>
class CellSizes {
 public:
  /// @throws Error unless 0 < size < infinity and 1/size is finite.
  CellSizes(T size);  // NOLINT(google-explicit-constructor): conversion is intended
  /// Places in ascending order.
  /// @throws Error unless there is at least one, places ascend and are finite, and sizes are as
  /// above.
  explicit CellSizes(const std::vector<CellSizeAt<T>>& sizes);

  /// The number of cells from 0, or from the first place, to x.
  [[nodiscard]] T cellsUpTo(T x) const;
  /// The most cells per length anywhere in the interval; rounded up.
  [[nodiscard]] T mostPerLength(const Interval<T>& places) const;

  /// Whether all cells have the same size.
  [[nodiscard]] bool isConstant() const { return knots_.size() == 1; }
  /// Cells per length: the least and the most anywhere.
  [[nodiscard]] const Interval<T>& perLength() const { return perLength_; }
  /// The place farthest from 0.
  [[nodiscard]] T reach() const;

 private:
  struct Knot {
    T place;
    T perLength;
    T cells;  // from the first knot
    T slope;  // of perLength, up to the next knot
  };

  [[nodiscard]] const Knot& knotBefore(T x) const;
  [[nodiscard]] T perLengthAt(T x) const;

  std::vector<Knot> knots_;
  Interval<T> perLength_;
};

extern template class CellSizes<float>;
extern template class CellSizes<double>;

}  // namespace cutwater
