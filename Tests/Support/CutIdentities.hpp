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

}  // namespace cutwater::test
