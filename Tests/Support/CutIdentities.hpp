#pragma once

#include <Cutwater/CutCells/CutCells.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {

/// What holds for cut cells or leaves of any surface; pieces close within `closure` of a face.
template <typename Cut>
void expectIdentities(const Cut& cut, double closure) {
  const auto report = check(cut);
  EXPECT_EQ(report.outOfRange, 0U);
  EXPECT_EQ(report.lostPieces, 0U);
  EXPECT_LT(report.worstClosure, closure);
}

/// The volume of the fluid in a cell of the box.
inline double fluidIn(const CutCells& cells, const Index3& cell) {
  const auto row = cells.rowOf(cell);
  if (row == CutCells::kNoRow) {
    return cells.classOf(cell) == FluidClass::Fluid ? cells.cellVolume(cell) : 0;
  }
  double sum = 0;
  for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
    sum += cells.pieces.volume[p];
  }
  return sum;
}

}  // namespace cutwater::test
