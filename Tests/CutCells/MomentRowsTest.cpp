#include <Cutwater/Surface/Tessellation.hpp>

#include <random>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "CutCells/RandomVoxels.hpp"

namespace cutwater::test {
namespace {

TEST(MomentRowsTest, OfCoarserCellsAreTheirOwn) {
  std::mt19937 random(8);
  for (const auto& soup : {placedTorus(), meshOf(randomVoxels(random)).soup()}) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      const auto coarse = coarsened(cellsOf(soup, unitGrid(12), side), {2, 3, 4});
      EXPECT_EQ(coarse.moments.degree, 4);
      EXPECT_EQ(coarse.moments.volume.size(), 35 * coarse.pieceCount);
      EXPECT_EQ(coarse.moments.arc.size(), 15 * coarse.arcs.area.size());
      EXPECT_LT(check(coarse).worstMoments, 1e-14);
      // All moments of a cell's fluid are those of cutting it.
      const Level<double> level({0, 0, 0}, {1.0 / 6, 1.0 / 4, 1.0 / 3});
      const auto direct = cellsOf(soup, {level, IndexBox::ofSize(6, 4, 3)}, side);
      ASSERT_EQ(coarse.cellCount, direct.cellCount);
      for (std::size_t row = 0; row < coarse.cellCount; ++row) {
        const auto center = coarse.boxOf(coarse.cells.index[row]).center();
        const auto sum = [&](const CutCells& cells) {
          std::vector<double> result(2 * kOrder.size());
          for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
            const auto volume = volumeAbout(cells, p, center);
            const auto wall = wallAbout(cells, p, center);
            for (std::size_t i = 0; i < kOrder.size(); ++i) {
              result[i] += volume[i];
              result[kOrder.size() + i] += wall[i];
            }
          }
          return result;
        };
        const auto found = sum(coarse);
        const auto expected = sum(direct);
        for (std::size_t i = 0; i < kOrder.size(); ++i) {
          EXPECT_NEAR(found[i], expected[i], 1e-16);
          EXPECT_NEAR(found[kOrder.size() + i], expected[kOrder.size() + i], 1e-14);
        }
      }
    }
  }
}

TEST(MomentRowsTest, OfMergedCellsCountWhatWasClosed) {
  const auto plate = tessellation::box({-1, -1, 0.43}, {2, 2, 0.43 + 1e-6});
  std::mt19937 random(8);
  for (const auto& soup : {plate, placedTorus(), meshOf(randomVoxels(random)).soup()}) {
    const auto cells = cellsOf(soup, unitGrid(8), FluidSide::Outside);
    for (const double smallest : {0.0, 0.3}) {
      const auto result = merged(cells, {.smallest = smallest});
      EXPECT_GT(result.lost.size(), 0U);
      EXPECT_EQ(result.cells.moments.volume.size(), 35 * result.cells.pieceCount);
      EXPECT_EQ(result.cells.moments.arc.size(), 15 * result.cells.arcs.area.size());
      EXPECT_LT(check(result.cells).worstMoments, 1e-14);
    }
  }
}

}  // namespace
}  // namespace cutwater::test
