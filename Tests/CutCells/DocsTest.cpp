// The code of Docs/cut-cells.md.
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

TEST(DocsTest, FractionsAndAperturesOfCutCells) {
  const Solid<double> hull(MeshSDF<double>(tessellation::icosphere(0.4, 3)));
  const Level<double> level({-0.5, -0.5, -0.5}, {0.125, 0.125, 0.125});
  const auto indices = IndexBox::ofSize(8, 8, 8);
  double fluid = 0;
  double faces = 0;
  const auto useFraction = [&](const Index3&, double fraction, const Vec3<double>& centroid) {
    fluid += fraction;
    EXPECT_LE(maxComponent(abs(centroid)), 0.5);
  };
  const auto useFace = [&](const Index3& cell, int axis, double aperture) {
    EXPECT_LE(cell.i, 8);
    EXPECT_LT(axis, 3);
    faces += aperture;
  };
  // [DOCS
  const CellCutter cutter(hull);  // fluid outside; FluidSide::Inside: within it
  const CutCells cells = cutter.cut(GridPatch<double>{level, indices});
  for (std::size_t row = 0; row < cells.cellCount; ++row) {
    const Index3& cell = cells.cells.index[row];
    for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
      useFraction(cell, cells.volumeFraction(p), cells.pieces.centroid[p]);
    }
  }
  for (std::uint32_t a = 0; a < cells.arcs.area.size(); ++a) {
    useFace(cells.arcs.cell[a], cells.arcs.axis[a], cells.aperture(a));
  }
  // DOCS]
  EXPECT_GT(fluid, 10);
  EXPECT_LT(fluid, static_cast<double>(cells.cellCount));
  EXPECT_GT(faces, fluid);
}

TEST(DocsTest, PolyhedraOfCutCells) {
  const TemporaryFolder folder;
  const auto path = folder / "cells.vtu";
  const CellCutter cutter{Solid<double>(MeshSDF<double>(tessellation::icosphere(0.4, 1)))};
  const Level<double> level({-0.5, -0.5, -0.5}, {0.25, 0.25, 0.25});
  const auto indices = IndexBox::ofSize(4, 4, 4);
  // [DOCS
  const CutCells cells = cutter.cut(GridPatch<double>{level, indices}, {.polygons = true});
  writePointData(path, cutCellMesh(cells));  // .vtu, which ParaView opens: each piece a polyhedron
  // DOCS]
  EXPECT_EQ(cutCellMesh(cells).cells.count(), cells.pieceCount);
  EXPECT_GT(std::filesystem::file_size(path), 64 * cells.pieceCount);
}

TEST(DocsTest, CoarserLevels) {
  const Solid<double> hull(MeshSDF<double>(tessellation::icosphere(0.4, 3)));
  const Level<double> level({-0.5, -0.5, -0.5}, {0.125, 0.125, 0.125});
  const auto cells = CellCutter(hull).cut(GridPatch<double>{level, IndexBox::ofSize(8, 8, 8)});
  // [DOCS
  const CutCells half = coarsened(cells, {2, 2, 2});  // and so on, down to one cell
  // DOCS]
  EXPECT_NEAR(check(half).fluidVolume, check(cells).fluidVolume, 1e-15);
}

TEST(DocsTest, FilesOfCutCells) {
  const TemporaryFolder folder;
  const auto path = folder / "ball.cells";
  const CellCutter cutter{Solid<double>(MeshSDF<double>(tessellation::icosphere(0.4, 1)))};
  const auto cells = cutter.cut(cellsBetween({{{-1, 0, 1}, {-1, 0, 1}, {-1, 0, 1}}}));
  // [DOCS
  saveCutCells(path, cells);
  const CutCells loaded = loadCutCells(path);  // the same to the bit
  // DOCS]
  EXPECT_EQ(loaded.pieces.volume, cells.pieces.volume);
}

TEST(DocsTest, OnePieceACell) {
  const Solid<double> plate(MeshSDF<double>(tessellation::box({-1, -1, 0}, {1, 1, 1e-9})));
  const Level<double> level({-0.5, -0.5, -0.45}, {0.125, 0.125, 0.125});
  const auto cells = CellCutter(plate).cut(GridPatch<double>{level, IndexBox::ofSize(8, 8, 8)});
  // [DOCS
  const auto [single, lost] = merged(cells);  // or merged(cells, {.smallest = 0.01})
  // DOCS]
  EXPECT_EQ(lost.size(), 64U);
  EXPECT_EQ(check(single).multiPieceCells, 0U);
}

}  // namespace
}  // namespace cutwater::test
