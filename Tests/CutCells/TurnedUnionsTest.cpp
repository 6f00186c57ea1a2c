// Boxes with faces in common planes, turned: rounded, these are nearly one plane, and others cross
// at the smallest angles there are.

#include <random>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/ShellCells.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

TEST(TurnedUnionsTest, HaveTheVolumeOfTheUnionOnBothSides) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> angle(0, 180);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(40) && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const auto boxes = randomBoxesInPlanes(random, 2 + round % 5, 5);
    const double volume = covered(Box<double>{{0, 0, 0}, {1, 1, 1}}, boxes);
    auto solid = solidOf(soupOf(boxes));
    solid.rotate(angle(random), Vec3<double>{1, 2, 3});
    const auto whole = solid.boundingBox().grown(0.01);
    const int n = 1 + round % 7;
    const GridPatch<double> grid{Level<double>(whole.lower, whole.size() / n),
                                 IndexBox::ofSize(n, n, n)};
    const auto outside = CellCutter(solid).cut(grid);
    const auto inside = CellCutter(solid, FluidSide::Inside).cut(grid);
    expectClosed(outside);
    expectClosed(inside);
    EXPECT_NEAR(check(outside).bodyVolume, volume, 1e-11);
    EXPECT_NEAR(check(inside).fluidVolume, volume, 1e-11);
    EXPECT_NEAR(check(outside).wallArea, check(inside).wallArea, 1e-10);
    meeting += check(outside).meetingCells;
  }
  EXPECT_GT(meeting, 100U);
}

}  // namespace
}  // namespace cutwater::test
