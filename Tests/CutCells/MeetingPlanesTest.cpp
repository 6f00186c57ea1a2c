// Sections of surfaces whose shells overlap.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/ShellCells.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

CellPlanes unitSquare(int n) {
  std::vector<double> planes;
  for (int i = 0; i <= n; ++i) planes.push_back(i / static_cast<double>(n));
  return cellsBetween({planes, planes, {0, 1}});
}

/// Compares the areas of rectangles with inclusion and exclusion, and pieces and arcs with those of
/// a layer of cells: the boxes are the same at all heights.
void expectUnionInPlane(const std::vector<Box<double>>& boxes, int n, FluidSide side,
                        std::size_t& meeting) {
  const CellCutter cutter(solidOf(soupOf(boxes)), side);
  const auto flat = cutter.cutInPlane(unitSquare(n), 0.5);
  expectIdentities(flat, 1e-13);
  meeting += check(flat).meetingCells;
  auto grid = unitSquare(n);
  const auto layer =
      cutter.cut(cellsBetween({std::vector(grid.planes[0].begin() + 1, grid.planes[0].end() - 1),
                               std::vector(grid.planes[1].begin() + 1, grid.planes[1].end() - 1),
                               {0.25, 0.75}}));
  ASSERT_EQ(flat.cellCount, layer.cellCount);
  EXPECT_EQ(flat.bodyRuns, layer.bodyRuns);
  EXPECT_NEAR(check(flat).wallArea, 2 * check(layer).wallArea, 1e-12);
  const auto across = std::ranges::count_if(layer.arcs.axis, [](auto axis) { return axis < 2; });
  EXPECT_EQ(flat.arcs.area.size(), static_cast<std::size_t>(across));
  for (std::uint32_t row = 0; row < flat.cellCount; ++row) {
    ASSERT_EQ(flat.cells.index[row], layer.cells.index[row]);
    ASSERT_EQ(flat.cells.firstPiece[row + 1], layer.cells.firstPiece[row + 1]);
    EXPECT_LE(flat.cells.meets[row], layer.cells.meets[row]);
    auto box = flat.boxOf(flat.cells.index[row]);
    double fluid = 0;
    for (auto p = flat.cells.firstPiece[row]; p < flat.cells.firstPiece[row + 1]; ++p) {
      fluid += flat.pieces.volume[p];
      const auto isSame = [&](std::uint32_t q) {
        return std::abs(flat.pieces.volume[p] - 2 * layer.pieces.volume[q]) < 1e-14 &&
               std::abs(flat.pieces.wallArea[p] - 2 * layer.pieces.wallArea[q]) < 1e-13 &&
               length(flat.pieces.wallVector[p] - 2 * layer.pieces.wallVector[q]) < 1e-13 &&
               length(flat.pieces.centroid[p] - layer.pieces.centroid[q]) < 1e-12;
      };
      bool isFound = false;
      for (auto q = layer.cells.firstPiece[row]; q < layer.cells.firstPiece[row + 1]; ++q) {
        isFound = isFound || isSame(q);
      }
      EXPECT_TRUE(isFound);
    }
    box.lower.z = box.upper.z = 0.5;
    const double body = covered(box, boxes, 2);
    const double all = covered(box, {box}, 2);
    ASSERT_NEAR(fluid, side == FluidSide::Outside ? all - body : body, 1e-14);
  }
}

TEST(MeetingPlanesTest, UnionsOfBoxes) {
  std::mt19937 random(61);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(60) && !HasFailure(); ++round) {
    const auto boxes = asPrisms(randomBoxes(random, 2 + round % 3), -1, 2);
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      expectUnionInPlane(boxes, std::array{1, 3, 4, 19}[static_cast<std::size_t>(round) % 4], side,
                         meeting);
    }
  }
  EXPECT_GT(meeting, 100U);
}

TEST(MeetingPlanesTest, UnionsOfBoxesInLinesOfTheGrid) {
  std::mt19937 random(62);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(100) && !HasFailure(); ++round) {
    const auto boxes = asPrisms(randomBoxesInPlanes(random, 2 + round % 3, 8), -1, 2);
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      expectUnionInPlane(boxes, std::array{1, 2, 8, 16}[static_cast<std::size_t>(round) % 4], side,
                         meeting);
    }
  }
  EXPECT_GT(meeting, 100U);
}

/// Both sides fill the plane, and coarser rectangles are those of finer ones.
TEST(MeetingPlanesTest, SectionsOfBallsThatOverlap) {
  const auto both = joined({ball(0.3, {0.35, 0.4, 0.51}, 2), ball(0.27, {0.6, 0.62, 0.48}, 2)});
  const CellCutter outside(solidOf(both));
  const CellCutter inside(solidOf(both), FluidSide::Inside);
  for (const double z : {0.3, 0.5, 0.51}) {
    const auto fine = outside.cutInPlane(unitSquare(32), z);
    expectIdentities(fine, 1e-12);
    EXPECT_NEAR(check(fine).bodyVolume, check(inside.cutInPlane(unitSquare(32), z)).fluidVolume,
                1e-13);
    const auto coarse = outside.cutInPlane(unitSquare(8), z);
    const auto expected = coarsened(fine, {4, 4, 1});
    EXPECT_EQ(coarse.cells.index, expected.cells.index);
    EXPECT_EQ(coarse.cells.firstPiece, expected.cells.firstPiece);
    EXPECT_NEAR(check(coarse).wallArea, check(expected).wallArea, 1e-13);
    EXPECT_GT(check(coarse).meetingCells, 0U);
  }
}

}  // namespace
}  // namespace cutwater::test
