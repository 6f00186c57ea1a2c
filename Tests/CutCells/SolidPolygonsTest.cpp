// Polygons of cells that are cut by solids that are no meshes.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "Support/CutPolygons.hpp"

namespace cutwater::test {
namespace {

Solid<double> thickTorus() {
  return Torus<double>({0.513, 0.507, 0.489}, {3, -2, 4}, 0.28, 0.13);
}
Solid<double> boredBall() {
  return Solid<double>(Sphere<double>({0.5, 0.5, 0.5}, 0.4)) -
         Cylinder<double>({-0.1, 0.52, 0.5}, {1.1, 0.5, 0.48}, 0.17);
}
Solid<double> gyroid() {
  return TpmsSolid<double>(TpmsField<double>(TpmsPattern::gyroid(), 1), TpmsPart::Wall, 0.3);
}

CutCells cutOf(const Solid<double>& solid, int cells, FluidSide side = FluidSide::Outside) {
  return SolidCutter(solid, side).cut(unitGrid(cells), {.polygons = true});
}

/// The sum of what polygons enclose, and of what rows say.
struct Volumes {
  double ofPolygons = 0;
  double ofRows = 0;
};
template <typename Cut>
Volumes expectClosedPolygons(const Cut& cut) {
  Volumes sum;
  const auto pieces = closedPieces(cut);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    sum.ofPolygons += pieces[p].volume();
    sum.ofRows += cut.pieces.volume[p];
  }
  return sum;
}

TEST(SolidPolygonsTest, CloseEveryPieceToTheBit) {
  for (const auto& solid : {thickTorus(), boredBall(), gyroid()}) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      expectClosedPolygons(cutOf(solid, 12, side));
    }
  }
}

TEST(SolidPolygonsTest, CloseEveryPieceAcrossTheEndsOfPeriods) {
  for (const auto& solid : {thickTorus(), boredBall()}) {
    const SolidCutter cutter(translated(solid, Vec3<double>{0.4, -0.3, 0.55}), FluidSide::Outside,
                             {.period = {1, 1, 1}});
    const auto volumes = expectClosedPolygons(cutter.cut(unitGrid(9), {.polygons = true}));
    EXPECT_NEAR(volumes.ofPolygons, volumes.ofRows, 0.01);
    expectClosedPolygons(cutter.cut(
        GridPatch<double>{unitGrid(9).level, {{5, -3, -11}, {11, 2, -7}}}, {.polygons = true}));
  }
}

TEST(SolidPolygonsTest, EncloseTheVolumeButForTheSecondOrder) {
  for (const auto& solid :
       {thickTorus(), Solid<double>(Sphere<double>({0.513, 0.507, 0.489}, 0.37))}) {
    const auto errorOf = [&](int cells) {
      const auto volumes = expectClosedPolygons(cutOf(solid, cells));
      return std::abs(volumes.ofPolygons - volumes.ofRows);
    };
    const double coarse = errorOf(8);
    const double fine = errorOf(16);
    EXPECT_LT(coarse, 0.01);
    EXPECT_LT(fine, coarse / 3.5);
  }
}

/// Walls in planes of the grid, with the fluid on their outer side, are exact.
TEST(SolidPolygonsTest, WallsInPlanesOfTheGridAreExact) {
  const Cuboid<double> box({0.25, 0.25, 0.375}, {0.75, 0.625, 0.75});
  const auto volumes = expectClosedPolygons(cutOf(Solid<double>(box), 16));
  EXPECT_NEAR(volumes.ofPolygons, volumes.ofRows, 1e-13);
}

/// No node of the lattice sees the plate: pieces on its two sides are closed all the same.
TEST(SolidPolygonsTest, PiecesOnBothSidesOfAThinPlateAreClosed) {
  const Cuboid<double> plate({-1, -1, 0.5131}, {2, 2, 0.5132});
  const auto cells = cutOf(Solid<double>(plate), 8);
  EXPECT_EQ(check(cells).multiPieceCells, 64U);
  expectClosedPolygons(cells);
}

TEST(SolidPolygonsTest, PointsOfWallsLieInTheSurface) {
  const auto solid = thickTorus();
  const auto cells = cutOf(solid, 12);
  const double width = 1.0 / 12;
  for (const auto& point : cells.wallPolygons.points) {
    ASSERT_LT(std::abs(solid.signedDistance(point)), 1e-6 * width);
  }
}

TEST(SolidPolygonsTest, HaveTheSameBitsInEveryBox) {
  const auto solid = boredBall();
  const SolidCutter cutter(solid);
  const Level<double> level({0, 0, 0}, {0.0625, 0.0625, 0.0625});
  const auto all = cutter.cut(GridPatch<double>{level, IndexBox::ofSize(16, 16, 16)},
                              {.polygons = true, .threads = 2});
  const auto some = cutter.cut(GridPatch<double>{level, {{3, 2, 5}, {13, 12, 14}}},
                               {.polygons = true, .threads = 1});
  std::size_t compared = 0;
  const auto rangeOf = [](const CutCells& cells, std::uint32_t row) {
    std::vector<Vec3<double>> points;
    for (std::size_t w = 0; w < cells.wallParts.piece.size(); ++w) {
      if (cells.pieces.cell[cells.wallParts.piece[w]] != row) continue;
      for (auto n = cells.firstWallPolygon[w]; n < cells.firstWallPolygon[w + 1]; ++n) {
        const auto polygon = cells.wallPolygons.of(n);
        points.insert(points.end(), polygon.begin(), polygon.end());
      }
    }
    return points;
  };
  for (std::uint32_t row = 0; row < some.cellCount; row += 7) {
    const auto same = all.rowOf(some.cells.index[row]);
    ASSERT_NE(same, CutCells::kNoRow);
    EXPECT_EQ(rangeOf(some, row), rangeOf(all, same));
    ++compared;
  }
  EXPECT_GT(compared, 30U);
}

TEST(SolidPolygonsTest, MakeAMeshOfPolyhedra) {
  const auto cells = cutOf(thickTorus(), 8);
  const auto mesh = cutCellMesh(cells);
  EXPECT_EQ(mesh.cells.count(), cells.pieceCount);
}

/// Whatever the levels beside each other.
TEST(SolidPolygonsTest, CloseEveryPieceOfLeaves) {
  std::mt19937 random(31);
  for (const auto& solid : {thickTorus(), boredBall(), gyroid()}) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      for (const int deepest : {3, 5}) {
        const auto mesh =
            dividedMesh(random, deepest, 0, 1, 70 - 5U * static_cast<unsigned>(deepest));
        expectClosedPolygons(SolidCutter(solid, side).cut(mesh, {.polygons = true}));
      }
    }
  }
}

/// So their lattices fit together: no gap is closed in the plane of a face.
TEST(SolidPolygonsTest, WallsOfLeavesOfAnyLevelsMeet) {
  std::mt19937 random(35);
  for (const auto& solid : {thickTorus(), gyroid()}) {
    const auto leaves =
        SolidCutter(solid).cut(dividedMesh(random, 5, 0, 1, 50), {.polygons = true});
    for (std::size_t n = 0; n < leaves.wallPolygons.count(); ++n) {
      const auto polygon = leaves.wallPolygons.of(n);
      for (int axis = 0; axis < 3; ++axis) {
        const auto isBeside = [&](const Vec3<double>& p) { return p[axis] != polygon[0][axis]; };
        EXPECT_TRUE(std::ranges::any_of(polygon, isBeside)) << n;
      }
    }
  }
}

/// All leaves divided once more.
Mesh onceMore(const Mesh& mesh) {
  std::vector<OctreeCell> leaves;
  for (const auto& [index, level, kind] : mesh.cells()) {
    for (int child = 0; child < 8; ++child) {
      const Index3 within{2 * index.i + (child & 1), 2 * index.j + (child >> 1 & 1),
                          2 * index.k + (child >> 2)};
      leaves.push_back({.index = within, .level = static_cast<std::uint8_t>(level + 1)});
    }
  }
  return {mesh.domain(), mesh.deepest() + 1, leaves};
}

TEST(SolidPolygonsTest, OfLeavesEncloseTheVolumeButForTheSecondOrder) {
  std::mt19937 random(33);
  const auto solid = thickTorus();
  const auto errorOn = [&](const Mesh& mesh) {
    const auto leaves = SolidCutter(solid).cut(mesh, {.polygons = true});
    const auto volumes = expectClosedPolygons(leaves);
    return std::abs(volumes.ofPolygons - volumes.ofRows);
  };
  const auto mesh = onceMore(onceMore(dividedMesh(random, 3, 0, 1, 70)));
  const double coarse = errorOn(mesh);
  const double fine = errorOn(onceMore(mesh));
  EXPECT_LT(coarse, 0.01);
  EXPECT_LT(fine, coarse / 3);
}

TEST(SolidPolygonsTest, AreRefusedInAPlane) {
  const SolidCutter cutter(thickTorus());
  EXPECT_THROW((void)cutter.cutInPlane(planesOf(unitGrid(4)), 0.5, {.polygons = true}), Error);
}

}  // namespace
}  // namespace cutwater::test
