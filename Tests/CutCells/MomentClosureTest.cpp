#include <cmath>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"

namespace cutwater::test {
namespace {

TEST(MomentClosureTest, KeepTheIdentitiesOfTheDivergenceTheorem) {
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    for (const int n : {1, 2, 7, 16}) {
      for (const int degree : {0, 1, 2, 3, 4}) {
        EXPECT_LT(check(cellsOf(placedTorus(), unitGrid(n), side, degree)).worstMoments, 1e-14);
      }
    }
  }
}

TEST(MomentClosureTest, ChecksFindWhatIsWrong) {
  const auto cells = cellsOf(placedTorus(), unitGrid(7));
  const auto worstWith = [&](auto change) {
    auto changed = cells;
    change(changed);
    return check(changed).worstMoments;
  };
  const std::size_t xx = CutCells::Moments::indexOf(2, 0, 0);
  const double unit = std::pow(1.0 / 7, 4);
  EXPECT_LT(worstWith([](CutCells&) {}), 1e-15);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.volume[35 + xx] += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.volume[35] += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.wallVector[35 + xx].x += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.wall[35] += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.arc[15 + 3] += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([](CutCells& c) { c.moments.arc[15] = std::nan(""); }), 1e-11);
}

}  // namespace
}  // namespace cutwater::test
