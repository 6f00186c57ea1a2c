#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <gtest/gtest.h>

#include "CutCells/RandomVoxels.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/DamagedSoups.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

CutCells cut(const PolygonSoup& soup, int n, FluidSide side = FluidSide::Outside) {
  const double h = 1.0 / n;
  return CellCutter(Solid<double>(MeshSDF<double>(soup)), side)
      .cut(GridPatch<double>{Level<double>({0, 0, 0}, {h, h, h}), IndexBox::ofSize(n, n, n)},
           {.polygons = true});
}

TEST(CutPolygonsTest, CloseEveryPiece) {
  auto soup = tessellation::torus(0.3, 0.1, 40, 20);
  RigidTransform<double> motion;
  motion.rotate(33.0, Vec3<double>{1, 2, 3});
  motion.translate({0.51, 0.49, 0.47});
  for (auto& p : soup.points) p = motion.toWorld(p);
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    for (const int n : {1, 2, 7, 16}) expectPolygonsOf(cut(soup, n, side));
  }
}

TEST(CutPolygonsTest, OfSurfacesAlignedWithTheGrid) {
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    expectPolygonsOf(cut(tessellation::box({0.25, 0.25, 0.25}, {0.5, 0.75, 0.625}), 8, side));
    expectPolygonsOf(cut(moved(tessellation::icosphere(0.25, 2), {0.5, 0.5, 0.5}), 8, side));
    expectPolygonsOf(cut(moved(lPrism(), {-1, -1, 0.25}), 4, side));
  }
}

TEST(CutPolygonsTest, CutOpenTheHolesOfAFace) {
  // Balls and rings about the plane z = 1/2, all within the faces of eight cells.
  auto soup = moved(tessellation::icosphere(0.05, 2), {0.25, 0.25, 0.503});
  for (const Vec3<double>& at :
       {Vec3<double>{0.1, 0.12, 0.51}, {0.26, 0.1, 0.49}, {0.4, 0.41, 0.5}}) {
    soup = together(soup, moved(tessellation::icosphere(0.03, 2), at));
  }
  soup = together(soup, moved(tessellation::torus(0.15, 0.04, 30, 12), {0.75, 0.75, 0.501}));
  soup = together(soup, moved(tessellation::icosphere(0.06, 2), {0.75, 0.75, 0.49}));
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto cells = cut(soup, 2, side);
    expectPolygonsOf(cells);
    const auto found = check(cells);
    // Outside: within the ring about the ball the fluid is one with that above and below it.
    EXPECT_EQ(found.multiPieceCells, side == FluidSide::Outside ? 0U : 4U);
  }
}

TEST(CutPolygonsTest, OfAPlateAndABubbleInOneCell) {
  auto soup = tessellation::box({-1, -1, 0.4}, {2, 2, 0.4 + 1e-6});
  soup = together(soup, moved(tessellation::icosphere(0.1, 1), {0.5, 0.5, 0.7}));
  expectPolygonsOf(cut(soup, 1));
  EXPECT_EQ(check(cut(soup, 1)).multiPieceCells, 1U);
}

TEST(CutPolygonsTest, OfRandomVoxels) {
  std::mt19937 random(9);
  for (int n = 0; n < scaled(8) && !HasFailure(); ++n) {
    const CellCutter cutter{Solid<double>(meshOf(randomVoxels(random)))};
    // In planes of the grid, or between them; of all cells, or in every other one.
    const double lower = n % 2 == 0 ? 0 : -0.0113;
    const double h = n % 4 < 2 ? 1.0 / 16 : 0.09;
    const Level<double> level({lower, lower, lower}, {h, h, h});
    expectPolygonsOf(
        cutter.cut(GridPatch<double>{level, IndexBox::ofSize(12, 12, 12)}, {.polygons = true}));
  }
}

TEST(CutPolygonsTest, AreLeftOutUnlessAskedFor) {
  const CellCutter cutter(Solid<double>(MeshSDF<double>(tessellation::icosphere(0.3, 1))));
  const auto cells = cutter.cut(cellsBetween({{{-1, 0.1, 1}, {-1, 0.1, 1}, {-1, 0.1, 1}}}));
  EXPECT_EQ(cells.cellCount, 8U);
  EXPECT_EQ(cells.arcPolygons.count(), 0U);
  EXPECT_EQ(cells.wallPolygons.count(), 0U);
  EXPECT_TRUE(cells.firstWallPolygon.empty());
}

}  // namespace
}  // namespace cutwater::test
