#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "Support/Grid.hpp"
#include "Support/PolygonMoments.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

TEST(TileMomentsTest, AreThoseOfThePolygonsByQuadrature) {
  auto plates = tessellation::box({-1, -1, 0.43}, {2, 2, 0.43 + 1e-6});
  plates = together(plates, tessellation::box({0.2, 0.3, 0.5}, {0.4, 0.7, 0.9}));
  std::mt19937 random(4);
  for (const auto& soup : {placedTorus(), plates, meshOf(randomVoxels(random)).soup()}) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      for (const int n : {1, 5}) expectMomentsOfPolygons(cellsOf(soup, unitGrid(n), side));
    }
  }
}

TEST(TileMomentsTest, OfLowDegreesAreThoseOfTheRows) {
  const auto cells = cellsOf(placedTorus(), unitGrid(7), FluidSide::Outside);
  const double h = 1.0 / 7;
  for (std::size_t p = 0; p < cells.pieces.volume.size(); ++p) {
    const auto volume = cells.moments.ofVolume(p);
    const auto wall = cells.moments.ofWall(p);
    EXPECT_NEAR(volume[0], cells.pieces.volume[p], 1e-15 * h * h * h);
    EXPECT_NEAR(wall[0], cells.pieces.wallArea[p], 1e-15 * h * h);
    EXPECT_LT(length(cells.moments.ofWallVector(p)[0] - cells.pieces.wallVector[p]), 1e-15 * h * h);
    for (std::size_t i = 1; i < 4; ++i) {  // about centroids
      EXPECT_NEAR(volume[i], 0, 1e-15 * volume[0]);
      EXPECT_NEAR(wall[i], 0, 1e-15 * wall[0]);
    }
  }
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto arc = cells.moments.ofArc(a);
    EXPECT_NEAR(arc[0], cells.arcs.area[a], 1e-15 * h * h);
    for (std::size_t i = 1; i < 3; ++i) EXPECT_NEAR(arc[i], 0, 1e-15 * arc[0]);
  }
}

TEST(TileMomentsTest, HigherDegreesChangeNoLowerOnes) {
  const auto all = cellsOf(placedTorus(), unitGrid(7));
  for (int degree = 0; degree < 4; ++degree) {
    const auto some = cellsOf(placedTorus(), unitGrid(7), FluidSide::Inside, degree);
    for (std::size_t p = 0; p < all.pieceCount; ++p) {
      for (std::size_t i = 0; i < some.moments.perPiece(); ++i) {
        ASSERT_EQ(some.moments.ofVolume(p)[i], all.moments.ofVolume(p)[i]);
        ASSERT_EQ(some.moments.ofWall(p)[i], all.moments.ofWall(p)[i]);
        ASSERT_EQ(some.moments.ofWallVector(p)[i], all.moments.ofWallVector(p)[i]);
      }
    }
    for (std::size_t a = 0; a < all.arcs.area.size(); ++a) {
      for (std::size_t i = 0; i < some.moments.perArc(); ++i) {
        ASSERT_EQ(some.moments.ofArc(a)[i], all.moments.ofArc(a)[i]);
      }
    }
  }
}

/// A million cells from the origin.
TEST(TileMomentsTest, FarAwayAreAsGoodAsHere) {
  auto soup = placedTorus();
  for (auto& p : soup.points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * 0x1p20) * 0x1p-20;
  }
  const auto here = cellsOf(soup, unitGrid(16), FluidSide::Outside);
  const Vec3<double> far{0x1p18, -0x1p19, 0x1p17};
  for (auto& p : soup.points) p += far;
  const auto there = cellsOf(
      soup, {Level<double>(far, {1.0 / 16, 1.0 / 16, 1.0 / 16}), IndexBox::ofSize(16, 16, 16)},
      FluidSide::Outside);
  EXPECT_LT(check(there).worstMoments, 1e-14);
  ASSERT_EQ(here.pieceCount, there.pieceCount);
  for (std::size_t p = 0; p < here.pieceCount; ++p) {
    const auto corner = here.boxOf(here.cells.index[here.pieces.cell[p]]).lower;
    const auto expected = volumeAbout(here, p, corner);
    const auto found = volumeAbout(there, p, corner + far);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double unit = std::pow(1.0 / 16, degreeOf(kOrder[i]) + 3);
      EXPECT_NEAR(found[i], expected[i], 1e-14 * unit);
    }
  }
}

using Row = std::vector<double>;

/// The moments of each cell's pieces and of the arcs above and below each cell.
std::map<std::tuple<int, int, int, int>, std::vector<Row>> rowsByPlace(const CutCells& cells) {
  std::map<std::tuple<int, int, int, int>, std::vector<Row>> rows;
  const auto box = cells.grid.indices();
  for (std::size_t p = 0; p < cells.pieceCount; ++p) {
    const auto& index = cells.cells.index[cells.pieces.cell[p]];
    Row row(cells.moments.ofVolume(p).begin(), cells.moments.ofVolume(p).end());
    row.insert(row.end(), cells.moments.ofWall(p).begin(), cells.moments.ofWall(p).end());
    for (const auto& v : cells.moments.ofWallVector(p)) row.insert(row.end(), {v.x, v.y, v.z});
    rows[{index.i, index.j, index.k, -1}].push_back(row);
  }
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto& index = cells.arcs.cell[a];
    if (!box.contains(index) || !box.contains(cells.arcs.cellBelow(a))) continue;
    rows[{index.i, index.j, index.k, cells.arcs.axis[a]}].emplace_back(
        cells.moments.ofArc(a).begin(), cells.moments.ofArc(a).end());
  }
  return rows;
}

TEST(TileMomentsTest, AreTheSameInEveryBoxAndWithAnyNumberOfThreads) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(placedTorus()))};
  const auto patch = unitGrid(29);
  const auto whole = rowsByPlace(cutter.cut(patch, {.moments = 4, .threads = 1}));
  EXPECT_EQ(whole, rowsByPlace(cutter.cut(patch, {.moments = 4, .threads = 4})));
  std::mt19937 random(1);
  std::size_t compared = 0;
  for (int n = 0; n < scaled(20); ++n) {
    const auto box = randomBox(29, random);
    for (const auto& [place, rows] :
         rowsByPlace(cutter.cut(GridPatch<double>{patch.level, box}, {.moments = 4}))) {
      ASSERT_EQ(rows, whole.at(place));
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000U);
}

}  // namespace
}  // namespace cutwater::test
