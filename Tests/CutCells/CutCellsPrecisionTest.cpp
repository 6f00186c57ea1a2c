// inPrecision().

#include <Cutwater/CutCells/CellCutter.hpp>

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "CutCells/ShellCells.hpp"

namespace cutwater::test {
namespace {

/// By how much a number is off, in its own size.
template <typename T>
double errorOf(T found, double exact) {
  return exact == 0 ? std::abs(double{found}) : std::abs(double{found} - exact) / std::abs(exact);
}

/// What holds in a precision: pieces close, walls are those of their parts, and all is as near as
/// the precision lets it be.
template <typename T>
void expectNumbers(const CutCells& cells, double width) {
  const double rounding = std::numeric_limits<T>::epsilon();
  const auto numbers = inPrecision<T>(cells);
  const auto& pieces = numbers.pieces;
  ASSERT_EQ(pieces.volume.size(), cells.pieces.volume.size());
  ASSERT_EQ(numbers.arcs.area.size(), cells.arcs.area.size());
  ASSERT_EQ(numbers.wallParts.area.size(), cells.wallParts.area.size());
  std::vector<Vec3<T>> sums(pieces.wallVector.begin(), pieces.wallVector.end());
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const int axis = cells.arcs.axis[a];
    EXPECT_LE(errorOf(numbers.arcs.area[a], cells.arcs.area[a]), rounding);
    const auto box = cells.boxOf(cells.arcs.cell[a]);
    auto center = box.center();
    center[axis] = box.lower[axis];
    const auto way = Vec3<double>(numbers.arcs.centroid[a]) - (cells.arcs.centroid[a] - center);
    EXPECT_LE(length(way), rounding * width);
    for (const bool isBelow : {true, false}) {
      const auto piece = isBelow ? cells.arcs.below[a] : cells.arcs.above[a];
      if (piece < sums.size()) {
        sums[piece][axis] += isBelow ? numbers.arcs.area[a] : -numbers.arcs.area[a];
      }
    }
  }
  const double face = width * width;
  auto walls = pieces.wallVector;
  for (std::size_t n = 0; n < cells.wallParts.piece.size(); ++n) {
    walls[cells.wallParts.piece[n]] = walls[cells.wallParts.piece[n]] - numbers.wallParts.vector[n];
    EXPECT_LE(errorOf(numbers.wallParts.area[n], cells.wallParts.area[n]), rounding);
    const auto off = Vec3<double>(numbers.wallParts.vector[n]) - cells.wallParts.vector[n];
    EXPECT_LE(length(off), 8 * rounding * face + 1e-13 * face);
  }
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) {
    EXPECT_LE(length(sums[p]), 4 * rounding * face);
    EXPECT_LE(length(walls[p]), 4 * rounding * face);
    EXPECT_LE(errorOf(pieces.volume[p], cells.pieces.volume[p]), rounding);
    EXPECT_LE(errorOf(pieces.wallArea[p], cells.pieces.wallArea[p]), rounding);
    const auto box = cells.boxOf(cells.cells.index[cells.pieces.cell[p]]);
    const auto centroid = Vec3<double>(pieces.centroid[p]) + box.center();
    EXPECT_LE(length(centroid - cells.pieces.centroid[p]), rounding * width * 2);
    const auto wall = Vec3<double>(pieces.wallCentroid[p]) + box.center();
    EXPECT_LE(length(wall - cells.pieces.wallCentroid[p]), rounding * width * 2);
    const auto off = Vec3<double>(pieces.wallVector[p]) - cells.pieces.wallVector[p];
    EXPECT_LE(length(off), 8 * rounding * face + 1e-13 * face);
  }
}

TEST(CutCellsPrecisionTest, AreTheSameInAnyPrecisionButForItsRounding) {
  std::mt19937 random(31);
  const double h = 1.0 / 15;
  const auto grid = [&](double lower) {
    return GridPatch<double>{Level<double>({lower, lower, lower}, {h, h, h}),
                             IndexBox::ofSize(15, 15, 15)};
  };
  for (const auto& solid :
       {turnedTorus(), Solid<double>(meshOf(randomVoxels(random))),
        solidOf(joined({ball(0.3, kMiddle, 2), ball(0.3, {0.6, 0.55, 0.4}, 2)}))}) {
    const auto cells = CellCutter(solid).cut(grid(0));
    expectNumbers<float>(cells, h);
    expectNumbers<double>(cells, h);
    expectNumbers<float>(coarsened(cells, {3, 3, 3}), 3 * h);
    expectNumbers<float>(merged(cells).cells, h);
  }
}

TEST(CutCellsPrecisionTest, PlacesKeepTheirDigitsFarAway) {
  auto solid = turnedTorus();
  solid.translate({1e6, 1e6, 1e6});
  const CellCutter cutter(solid);
  const auto cells = cutter.cut(GridPatch<double>{
      Level<double>({1e6, 1e6, 1e6}, {0.0625, 0.0625, 0.0625}), IndexBox::ofSize(16, 16, 16)});
  ASSERT_GT(cells.cellCount, 100U);
  expectNumbers<float>(cells, 0.0625);
}

}  // namespace
}  // namespace cutwater::test
