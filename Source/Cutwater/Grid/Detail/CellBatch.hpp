#pragma once

#include <Cutwater/Core/OrientedBox.hpp>
#include <Cutwater/Grid/Detail/FillTask.hpp>

namespace cutwater::detail {

/// What the value in the middle of a cell says about the class that classify() gives it, for a
/// solid with a Lipschitz constant.
///
/// SignedDistanceFunction::localClassify() must decide every box that its default decides: one that
/// the value and the constant prove to be clear, and one that holds a ball which reaches the
/// surface of an exact distance. These are the same conditions with more room, so that the rounding
/// of one way to compute them or another does not matter.
template <std::floating_point T>
class CellTest {
 public:
  /// In units of lengths of the cell.
  static constexpr T kRoom = T(0x1p-10);

  /// For cells that are no farther from the origin than `reach`.
  CellTest(const Guarantee<T>& promise, T reach) : promise_(promise) {
    constexpr T kRoundings = 16;  // those of the placement and of the boxes' coordinates, too
    margin_ = kRoundings * (promise.error(reach) +
                            *promise.lipschitz * 4 * std::numeric_limits<T>::epsilon() * reach);
  }

  /// Values beyond this prove that a cell of this radius is clear.
  [[nodiscard]] T clearance(T radius) const {
    return *promise_.lipschitz * (1 + kRoom) * radius + margin_;
  }
  /// The class of a cell with this value in the middle; Unknown if that does not tell.
  [[nodiscard]] BoxClass classOf(const OrientedBox<T>& cell, T atCenter) const {
    const T distance = std::abs(atCenter);
    if (distance > clearance(cell.radius())) {
      return atCenter < 0 ? BoxClass::Inside : BoxClass::Outside;
    }
    const bool isExact = promise_.quality(atCenter) == Quality::Exact &&
                         (distance > margin_ || promise_.inside == promise_.outside);
    const bool isReached = distance + margin_ < (1 - kRoom) * cell.innerRadius();
    return isExact && isReached ? BoxClass::Cut : BoxClass::Unknown;
  }

 private:
  const Guarantee<T>& promise_;
  T margin_;
};

/// Classifies cells of a grid patch together and stores their classes in the target. The class of a
/// cell is that of SignedDistanceFunction::classify(), which is asked only if CellTest leaves it
/// open.
template <std::floating_point T>
class CellBatch {
 public:
  explicit CellBatch(const FillTask<T>& task) : task_(task) {}

  /// `hint`: of a box around the cell.
  void add(const Offset& offset, const BoxHint& hint) {
    offsets_[count_] = offset;
    hints_[count_] = hint;
    if (++count_ == kMost) flush();
  }
  /// Classifies the cells added so far.
  void flush();

 private:
  static constexpr std::size_t kMost = 256;

  /// Stores the classes that values tell, and moves the other cells to the front.
  void storeTold();

  const FillTask<T>& task_;
  Scratch<Offset, kMost> offsets_;
  Scratch<BoxHint, kMost> hints_;
  Scratch<Box<T>, kMost> cells_;
  std::size_t count_ = 0;
};

extern template class CellBatch<float>;
extern template class CellBatch<double>;

}  // namespace cutwater::detail
