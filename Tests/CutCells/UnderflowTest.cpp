// Coordinates so small that products of them underflow, or that sums with others lose them, beside
// planes of the grid at 0.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/ShellCells.hpp"
#include "CutCells/Tetrahedra.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// Multiples of `tiny`, or of 1 / 4, or anything up to 1.
double coordinate(std::mt19937& random, double tiny) {
  switch (random() % 4) {
    case 0:
      return 0.25 * (static_cast<int>(random() % 9) - 4);
    case 1:
      return std::uniform_real_distribution<double>(-1, 1)(random);
    default:
      return tiny * (static_cast<int>(random() % 7) - 3);
  }
}

const std::vector<double> kPlanes{-1.5, -0.5, 0, 0.5, 1.5};

void expectCut(const PolygonSoup& soup) {
  const auto cells = CellCutter(solidOf(soup)).cut(cellsBetween({kPlanes, kPlanes, kPlanes}));
  expectClosed(cells);
  EXPECT_NEAR(check(cells).bodyVolume, volumeOf(soup), 1e-14);
  EXPECT_NEAR(check(cells).wallArea, test::areaOf(soup), 1e-13);
}

/// As far as doubles can tell, such a tetrahedron is one with corners in these planes.
TEST(UnderflowTest, TinyCoordinatesAreCutAsZeros) {
  std::mt19937 random(71);
  for (const double tiny : {0x1p-1074, 0x1p-1022, 1e-200, 0x1p-341, 0x1p-340, 1e-17, 1e-15}) {
    int cut = 0;
    for (int n = 0; n < scaled(200) && !HasFailure(); ++n) {
      const auto soup = tetrahedraOf(1, [&] {
        return Vec3<double>{coordinate(random, tiny), coordinate(random, tiny),
                            coordinate(random, tiny)};
      });
      if (!(volumeOf(soup) > 1e-6)) continue;
      expectCut(soup);
      ++cut;
    }
    EXPECT_GT(cut, 30);
  }
}

/// What they leave open of a face is nothing, and not less because of rounding.
TEST(UnderflowTest, FilmsInFacesHaveNoNegativeArea) {
  expectCut(tetrahedronOf({{{-2e-17, 3e-17, 0},
                            {-2e-17, -0.5, -0.60048447523752868},
                            {-2e-17, -1, -3e-17},
                            {-0.25, 1e-17, 0}}}));
}

/// Moved, their edges reach across a plane: holes in a face without area, but for rounding.
TEST(UnderflowTest, EdgesInPlanesLeaveTheFluidAroundThem) {
  expectCut(tetrahedronOf(
      {{{0, -0.25, -2e-15}, {-2e-15, -1e-15, -1e-15}, {-0.25, 0, -1e-15}, {0, -1e-15, -0.25}}}));
  expectCut(tetrahedronOf(
      {{{-0.25, -2e-15, 0}, {-2e-15, -0.5, -2e-15}, {-1e-15, -2e-15, 0}, {0, -2e-15, -0.25}}}));
}

}  // namespace
}  // namespace cutwater::test
