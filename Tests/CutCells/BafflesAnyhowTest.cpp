// Baffles that lie anyhow: closed ones beside both sides of the same surface as a wall, planes
// beside clipped cells, on octrees, with other options, and what is refused.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/JoinedCells.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "CutCells/Sheets.hpp"
#include "Support/CutIdentities.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/Refusal.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test::baffles {
namespace {

Solid<double> solidOf(const PolygonSoup& soup) {
  return Solid<double>(MeshSDF<double>(soup));
}
CellCutter cutterOf(const PolygonSoup& soup, FluidSide side = FluidSide::Outside) {
  return CellCutter(solidOf(soup), side, {.baffles = {"fin"}});
}
GridPatch<double> unitCube(int cells) {
  const double h = 1.0 / cells;
  return {Level<double>({0, 0, 0}, {h, h, h}), IndexBox::ofSize(cells, cells, cells)};
}
double volumeOf(const CutCells& cells) {
  double sum = 0;
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    sum += fluidIn(cells, cells.cells.index[row]);
  }
  return sum;
}

/// The volumes of the pieces of each cell that is cut.
using Volumes = std::map<std::array<int, 3>, std::vector<double>>;
void addVolumes(const CutCells& cells, Volumes& volumes) {
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    const auto& [i, j, k] = cells.cells.index[row];
    auto& there = volumes[{i, j, k}];
    for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
      there.push_back(cells.pieces.volume[p]);
    }
  }
  for (auto& [cell, there] : volumes) std::ranges::sort(there);
}

/// Of each cell, along x and y: what is open below it.
std::map<std::array<int, 3>, double> openAreas(const CutCells& cells) {
  std::map<std::array<int, 3>, double> areas;
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto& cell = cells.arcs.cell[a];
    if (cells.arcs.axis[a] < 2) areas[{cell.i, cell.j, cells.arcs.axis[a]}] += cells.arcs.area[a];
  }
  return areas;
}

TEST(BafflesAnyhowTest, InAPlaneTheyAreThoseOfALayer) {
  // Upright sheets, which are the same at all heights, some of them along sides of cells.
  std::mt19937 random(7);
  const auto number = [&] { return std::uniform_real_distribution<>(0.05, 0.95)(random); };
  const auto quarter = [&] { return static_cast<double>(random() % 5) / 4; };
  for (int round = 0; round < scaled(40); ++round) {
    auto soup = sheet({number(), number(), -1}, {number() - 0.5, number() - 0.5, 0}, {0, 0, 3});
    for (auto more = random() % 4; more > 0; --more) {
      const bool isAligned = random() % 2 == 0;
      const auto next = isAligned ? sheet({quarter(), number(), -1}, {0, 0.4, 0}, {0, 0, 3})
                                  : sheet({quarter(), quarter(), -1},
                                          {number() - 0.5, number() - 0.5, 0}, {0, 0, 3});
      soup = beside(soup, next);
    }
    const auto cutter = cutterOf(soup);
    auto grid = planesOf(unitCube(12));
    const auto flat = cutter.cutInPlane(grid, 0.5);
    grid.planes[2] = {-1, 0, 1, 2};  // as high
    const auto layer = cutter.cut(grid);
    expectIdentities(flat, 1e-13);
    Volumes found;
    Volumes expected;
    addVolumes(flat, found);
    addVolumes(layer, expected);
    for (const auto& [cell, volumes] : expected) {
      if (volumes.size() < 2 && !found.contains(cell)) continue;  // a wall in its side at most
      ASSERT_EQ(found[cell].size(), volumes.size()) << round;
      for (std::size_t n = 0; n < volumes.size(); ++n) {
        ASSERT_NEAR(found[cell][n], volumes[n], 1e-12) << round;
      }
    }
    EXPECT_NEAR(check(flat).wallArea, check(layer).wallArea, 1e-11) << round;
    const auto areas = openAreas(layer);
    for (const auto& [face, area] : openAreas(flat)) {
      const auto same = areas.find(face);
      if (same == areas.end()) continue;
      ASSERT_NEAR(area, same->second, 1e-12) << round;
    }
  }
}

TEST(BafflesAnyhowTest, AClosedSheetHasBothSidesOfTheBody) {
  auto soup = called("fin", tessellation::torus(0.3, 0.1, 40, 20));
  auto solid = Solid<double>(MeshSDF<double>(soup));
  solid.rotate(33.0, Vec3<double>{1, 2, 3});
  solid.translate({0.51, 0.49, 0.47});
  for (const int n : {5, 9, 16}) {
    const auto cells = CellCutter(solid, FluidSide::Outside, {.baffles = {"fin"}})
                           .cut(unitCube(n), {.polygons = true, .moments = 2});
    const auto outside = CellCutter(solid, FluidSide::Outside).cut(unitCube(n));
    const auto inside = CellCutter(solid, FluidSide::Inside).cut(unitCube(n));
    Volumes found;
    Volumes expected;
    addVolumes(cells, found);
    addVolumes(outside, expected);
    addVolumes(inside, expected);
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [cell, volumes] : expected) {
      ASSERT_EQ(found[cell].size(), volumes.size()) << n;
      for (std::size_t i = 0; i < volumes.size(); ++i) {
        EXPECT_NEAR(found[cell][i], volumes[i], 1e-14);
      }
    }
    const auto report = check(cells);
    EXPECT_NEAR(report.wallArea, 2 * check(outside).wallArea, 1e-12);
    EXPECT_EQ(report.meetingCells, cells.cellCount);
    expectIdentities(cells, 1e-13);
    expectPolygonsOf(cells);
    const CutRegions regions(cells);
    ASSERT_EQ(regions.regions().size(), 2U);
    EXPECT_NEAR(regions.regions()[1].volume, check(outside).bodyVolume, 1e-13);
  }
}

TEST(BafflesAnyhowTest, ASheetWithARimLetsTheFluidAround) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(0.1, 0.9);
  const auto point = [&] { return Vec3<double>{at(random), at(random), at(random)}; };
  for (int round = 0; round < scaled(30); ++round) {
    const auto a = point();
    PolygonSoup soup = sheet(a, 0.5 * (point() - a), 0.5 * (point() - a));
    for (int n = round % 3; n > 0; --n) {  // others that may cross it
      const auto b = point();
      soup = beside(soup, sheet(b, 0.5 * (point() - b), 0.5 * (point() - b)));
    }
    double area = 0;
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      const auto p = soup.polygon(i);
      area += 0.5 * length(cross(soup.points[p[1]] - soup.points[p[0]],
                                 soup.points[p[2]] - soup.points[p[0]]));
    }
    const auto cells = cutterOf(soup).cut(unitCube(6), {.polygons = true, .moments = 1});
    EXPECT_NEAR(check(cells).wallArea, 2 * area, 1e-12);
    EXPECT_NEAR(volumeOf(cells), double(cells.cellCount) / 216, 1e-13);
    expectIdentities(cells, 1e-12);
    expectPolygonsOf(cells);
    EXPECT_EQ(CutRegions(cells).regions().size(), 1U);
    const auto coarse = coarsened(cells, {2, 2, 2});
    const auto direct = cutterOf(soup).cut(unitCube(3));
    EXPECT_EQ(coarse.pieceCount, direct.pieceCount);
    EXPECT_NEAR(check(coarse).wallArea, check(direct).wallArea, 1e-12);
  }
}

TEST(BafflesAnyhowTest, SailsOfManyTrianglesLetNothingThrough) {
  // Ruled: along each straight line, neighbouring triangles are nearly parallel.
  for (const std::uint32_t n : {10U, 60U, 100U}) {
    PolygonSoup sail;
    sail.patchNames = {"fin"};
    for (std::uint32_t j = 0; j <= n; ++j) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        const double u = double(i) / n;
        const double v = double(j) / n;
        sail.points.push_back(
            {0.1 + 0.8 * u, 0.51 + 0.15 * std::sin(3 * u) * (1 - v), 0.1 + 0.8 * v});
      }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const auto a = j * (n + 1) + i;
        sail.addPolygon(std::array{a, a + 1, a + n + 2});
        sail.addPolygon(std::array{a, a + n + 2, a + n + 1});
      }
    }
    const auto cells = cutterOf(sail).cut(unitCube(16));
    EXPECT_LT(check(cells).worstClosure, 1e-13);
    for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
      const auto& [i, j, k] = cells.cells.index[row];
      if (i < 2 || i > 13 || k < 2 || k > 13) continue;  // at the rim
      EXPECT_EQ(cells.cells.firstPiece[row + 1] - cells.cells.firstPiece[row], 2U)
          << n << " " << i << " " << j << " " << k;
    }
  }
}

TEST(BafflesAnyhowTest, TwoPlanesMakeFourPieces) {
  // Through all cells, crossing in the line through the center along (1, 1, 1).
  const Vec3<double> middle{0.5, 0.5, 0.5};
  const Vec3<double> axis{1, 1, 1};
  const Vec3<double> u{1, -1, 0};
  const Vec3<double> v{1, 1, -2};
  auto soup = sheet(middle - 2.0 * axis - 2.0 * u, 4.0 * axis, 4.0 * u);
  soup = beside(soup, sheet(middle - 2.0 * axis - 2.0 * v, 4.0 * axis, 4.0 * v));
  const auto one = cutterOf(soup).cut(unitCube(1));
  ASSERT_EQ(one.pieceCount, 4U);
  // By the symmetry of both planes, and the point reflection.
  for (std::uint32_t p = 0; p < 4; ++p) EXPECT_NEAR(one.pieces.volume[p], 0.25, 1e-14);
  const CutRegions regions(cutterOf(soup).cut(unitCube(7)));
  ASSERT_EQ(regions.regions().size(), 4U);
  for (const auto& region : regions.regions()) EXPECT_NEAR(region.volume, 0.25, 1e-13);
}

/// However little it has of the cell: what is thin is rounding, not what is small.
TEST(BafflesAnyhowTest, ASmallCornerIsAPiece) {
  for (const double size : {1e-2, 1e-4, 1e-5}) {
    // The plane x + y + z = 1.5 + size cuts a corner off the cell at the middle.
    const Vec3<double> middle{0.5 + size / 3, 0.5 + size / 3, 0.5 + size / 3};
    const Vec3<double> u{1, -1, 0};
    const Vec3<double> v{1, 1, -2};
    const auto cells = cutterOf(sheet(middle - 0.2 * u - 0.2 * v, 0.4 * u, 0.4 * v))
                           .cut(unitCube(2), {.polygons = true});
    expectIdentities(cells, 1e-13);
    expectPolygonsOf(cells);
    const auto row = cells.rowOf({1, 1, 1});
    const auto first = cells.cells.firstPiece[row];
    ASSERT_EQ(cells.cells.firstPiece[row + 1] - first, 2U) << size;
    const double least = std::min(cells.pieces.volume[first], cells.pieces.volume[first + 1]);
    EXPECT_NEAR(least / (size * size * size / 6), 1, 1e-9) << size;
    EXPECT_NEAR(check(cells).wallArea, 2 * 0.16 * length(cross(u, v)), 1e-13) << size;
  }
}

TEST(BafflesAnyhowTest, LeavesAreTheFinestCellsJoined) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(0.05, 0.95);
  const auto point = [&] { return Vec3<double>{at(random), at(random), at(random)}; };
  std::size_t several = 0;
  for (int round = 0; round < scaled(12); ++round) {
    const auto mesh = dividedMesh(random, 4, 0, 1);
    auto soup = called("fin", tessellation::icosphere(0.2 + 0.1 * at(random), 1));
    const auto shift = 0.3 * point() + Vec3<double>{0.35, 0.35, 0.35};
    for (auto& p : soup.points) p += shift;
    if (round % 2 == 0) {  // in planes of leaves
      soup = sheet({0.25, 0.125, 0.5}, {0.5, 0, 0}, {0, 0.5, 0});
      soup = beside(soup, sheet({0.5, 0.25, 0.25}, {0, 0.5, 0}, {0, 0, 0.5}));
    }
    soup = beside(soup, sheet(point(), 0.4 * point(), -0.4 * point()));
    const auto cutter = cutterOf(soup);
    const auto leaves = cutter.cut(mesh, {.polygons = true});
    expectIdentities(leaves, 1e-12);
    expectPolygonsOf(leaves);
    const auto fine = cutter.cut(finestOf(mesh));
    JoinedCells joined(fine, mesh);
    joined.expectSame(leaves);
    several += joined.splitLeaves();
  }
  EXPECT_GT(several, 50U);
}

TEST(BafflesAnyhowTest, ADuctKeepsItsOpenEnds) {
  // A plate across half of a duct, from one wall to the other, and into both.
  auto duct = tessellation::box({0.25, 0.25, 0}, {0.75, 0.75, 1});
  duct.patchNames = {"wall", "inlet"};
  for (std::size_t i = 0; i < duct.polygonCount(); ++i) {
    const bool isLow = std::ranges::all_of(
        duct.polygon(i), [&](std::uint32_t corner) { return duct.points[corner].z == 0; });
    duct.patches[i] = isLow ? 1 : 0;
  }
  const auto soup = beside(duct, sheet({0.1, 0.1, 0.55}, {0.8, 0, 0}, {0, 0.4, 0}));
  const CellCutter cutter(solidOf(soup), FluidSide::Inside,
                          {.openPatches = {"inlet"}, .baffles = {"fin"}});
  const auto cells = cutter.cut(unitCube(4), {.polygons = true});
  expectIdentities(cells, 1e-13);
  expectPolygonsOf(cells);
  double open = 0;
  for (const auto arc : cells.openArcs.arc) open += cells.arcs.area[arc];
  EXPECT_NEAR(open, 0.25, 1e-14);
  // In the walls of the duct it is nothing.
  EXPECT_NEAR(check(cells).wallArea, 4 * 0.5 + 0.25 + 2 * 0.5 * 0.25, 1e-13);
  EXPECT_EQ(CutRegions(cells).regions().size(), 1U);
  EXPECT_EQ(check(cells).multiPieceCells, 2U);
}

TEST(BafflesAnyhowTest, WhatIsRefused) {
  const auto fin = sheet({0.2, 0.2, 0.5}, {0.5, 0, 0}, {0, 0.5, 0});
  auto ball = called("ball", tessellation::icosphere(0.1, 1));
  const auto both = solidOf(beside(fin, ball));
  const auto with = [&](const Solid<double>& solid, const CutterOptions& options) {
    return refusal([&] { return CellCutter(solid, FluidSide::Outside, options); });
  };
  EXPECT_NE(with(both, {}).find("it is open at patches \"fin\""), std::string::npos);
  EXPECT_NE(with(both, {.baffles = {"sail"}}).find("that could be a baffle; there are: \"fin\""),
            std::string::npos);
  EXPECT_NE(with(both, {.baffles = {"fin", "fin"}}).find("the baffle \"fin\" is named twice"),
            std::string::npos);
  EXPECT_NE(with(both, {.openPatches = {"fin"}, .baffles = {"fin"}}).find("open and a baffle"),
            std::string::npos);
  EXPECT_EQ(with(both, {.baffles = {"fin"}}), "");
  ball.addPolygon(std::array{0U, 1U, 2U});
  EXPECT_NE(with(solidOf(beside(fin, ball)), {.baffles = {"fin"}}).find("at patches \"ball\""),
            std::string::npos);
  const auto lying = sheet({0.25, 0.25, 0.3}, {0.5, 0, 0}, {0, 0.5, 0});
  const auto plane =
      refusal([&] { return cutterOf(lying).cutInPlane(planesOf(unitCube(4)), 0.3); });
  EXPECT_NE(plane.find("a baffle lies in the plane"), std::string::npos);
}

}  // namespace
}  // namespace cutwater::test::baffles
