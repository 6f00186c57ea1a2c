// Moments of cells around surfaces whose shells overlap.

#include <random>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/MomentCells.hpp"
#include "CutCells/ShellCells.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// The integral of a monomial over what some boxes leave of the walls of one, within a cell.
double ofWalls(const Powers& powers, const Box<double>& cell, const std::vector<Box<double>>& boxes,
               std::size_t of) {
  auto others = boxes;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(of));
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool isHigh : {false, true}) {
      const double plane = isHigh ? boxes[of].upper[axis] : boxes[of].lower[axis];
      auto wall = boxes[of];
      wall.lower[axis] = wall.upper[axis] = plane;
      wall = wall.intersection(cell);
      if (wall.empty()) continue;
      const auto sizeOf = [&](const Box<double>& b) { return ofBox(powers, b, axis, plane); };
      sum += sizeOf(wall) - covered(wall, others, sizeOf);
    }
  }
  return sum;
}

TEST(MeetingMomentsTest, OfUnionsOfBoxesAreThoseOfInclusionAndExclusion) {
  std::mt19937 random(41);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(20) && !HasFailure(); ++round) {
    const auto boxes = randomBoxes(random, 2 + round % 3);
    const auto cells =
        cellsOf(soupOf(boxes), unitGrid(1 + round % 4), FluidSide::Outside, 4, false);
    EXPECT_LT(check(cells).worstMoments, 1e-13);
    meeting += check(cells).meetingCells;
    for (std::size_t row = 0; row < cells.cellCount; ++row) {
      const auto box = cells.boxOf(cells.cells.index[row]);
      for (std::size_t i = 0; i < kOrder.size(); ++i) {
        double volume = 0;
        double wall = 0;
        for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
          volume += volumeAbout(cells, p, {})[i];
          wall += wallAbout(cells, p, {})[i];
        }
        const auto sizeOf = [&](const Box<double>& b) { return ofBox(kOrder[i], b); };
        ASSERT_NEAR(volume, sizeOf(box) - covered(box, boxes, sizeOf), 1e-14);
        double walls = 0;
        for (std::size_t n = 0; n < boxes.size(); ++n) walls += ofWalls(kOrder[i], box, boxes, n);
        ASSERT_NEAR(wall, walls, 1e-13);
      }
    }
  }
  EXPECT_GT(meeting, 50U);
}

/// In planes of the grid as well, and where the pieces of both sides fill the cells.
TEST(MeetingMomentsTest, KeepTheDivergenceTheorem) {
  std::mt19937 random(42);
  std::vector<PolygonSoup> soups{
      joined({ball(0.3, {0.35, 0.4, 0.51}, 2), ball(0.27, {0.6, 0.62, 0.48}, 2)}),
      joined({ball(0.4, kMiddle, 1), ball(0.4, kMiddle, 1)})};
  for (int n = 0; n < scaled(10); ++n) {
    soups.push_back(soupOf(randomBoxesInPlanes(random, 2 + n % 3, 8)));
  }
  std::size_t meeting = 0;
  for (const auto& soup : soups) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      for (const int n : {1, 3, 8}) {
        const auto cells = cellsOf(soup, unitGrid(n), side, 4, false);
        meeting += check(cells).meetingCells;
        EXPECT_LT(check(cells).worstMoments, 1e-12);
      }
    }
  }
  EXPECT_GT(meeting, 500U);
}

}  // namespace
}  // namespace cutwater::test
