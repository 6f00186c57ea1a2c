// Cells of the fluid outside a surface and of that within it: together they are all there is.
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <map>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// What all pieces of a cell have, and the open parts of its lower faces.
struct CellContent {
  double volume = 0;
  Vec3<double> wall;
  std::array<double, 3> open{};
};

/// Of all cells of a box, cut or not.
std::vector<CellContent> contentsOf(const CutCells& cells) {
  std::vector<CellContent> result;
  std::map<std::tuple<int, int, int>, std::array<double, 3>> arcs;
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto& at = cells.arcs.cell[a];
    arcs[{at.i, at.j, at.k}][cells.arcs.axis[a]] += cells.arcs.area[a];
  }
  const auto box = cells.grid.indices();
  for (std::size_t k = 0; k < box.length(2); ++k) {
    for (std::size_t j = 0; j < box.length(1); ++j) {
      for (std::size_t i = 0; i < box.length(0); ++i) {
        const auto at = box.at(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                               static_cast<std::uint32_t>(k));
        auto& content = result.emplace_back();
        content.open = arcs[{at.i, at.j, at.k}];
        const auto row = cells.rowOf(at);
        if (row == CutCells::kNoRow) {
          if (cells.classOf(at) == FluidClass::Fluid) content.volume = cells.cellVolume(at);
          continue;
        }
        for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
          content.volume += cells.pieces.volume[p];
          content.wall += cells.pieces.wallVector[p];
        }
      }
    }
  }
  return result;
}

/// `isAligned`: walls lie in planes of the grid, so those of both sides are in different cells.
void expectAllOfEachCell(const PolygonSoup& soup, int n, bool isAligned) {
  const auto grid = unitGrid(n);
  const Solid<double> solid{MeshSDF<double>(soup)};
  const auto outside = CellCutter(solid, FluidSide::Outside).cut(grid);
  const auto inside = CellCutter(solid, FluidSide::Inside).cut(grid);
  const auto fluid = contentsOf(outside);
  const auto body = contentsOf(inside);
  const double face = 1.0 / n / n;
  Vec3<double> ofAll;
  for (std::size_t cell = 0; cell < fluid.size(); ++cell) {
    EXPECT_NEAR(fluid[cell].volume + body[cell].volume, face / n, 1e-14 * face / n);
    ofAll += fluid[cell].wall + body[cell].wall;
    if (isAligned) continue;
    EXPECT_LT(length(fluid[cell].wall + body[cell].wall), 1e-14 * face);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Only faces between cells that are not cut have no arc at all.
      const double open = fluid[cell].open[axis] + body[cell].open[axis];
      if (open > 0) {
        EXPECT_NEAR(open, face, 1e-14 * face);
      }
    }
  }
  EXPECT_LT(length(ofAll), 1e-13);
}

TEST(BothSidesTest, FillCellsAndFaces) {
  auto plates = tessellation::box({-1, -1, 0.43}, {2, 2, 0.43 + 1e-6});
  plates = together(plates, tessellation::box({0.21, 0.33, 0.51}, {0.41, 0.72, 0.91}));
  for (const auto& soup : {placedTorus(), plates}) {
    for (const int n : {1, 3, 8, 20}) expectAllOfEachCell(soup, n, false);
  }
}

TEST(BothSidesTest, FillCellsThatWallsLieBetween) {
  std::mt19937 random(5);
  const auto voxels = meshOf(randomVoxels(random)).soup();
  const auto box = tessellation::box({0.25, 0.25, 0.25}, {0.5, 0.75, 0.625});
  for (const int n : {8, 16}) {
    expectAllOfEachCell(box, n, true);
    expectAllOfEachCell(voxels, n, true);
  }
}

}  // namespace
}  // namespace cutwater::test
