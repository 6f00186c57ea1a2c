// Open patches: parts of a closed surface that are apertures.
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "CutCells/OpenCells.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "Support/CutIdentities.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/Refusal.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// From x = 1/4 to 3/4; its sides are between planes.
PolygonSoup duct(int n = 1) {
  return tessellation::box({0.25, 0.3, 0.35}, {0.75, 0.61, 0.72}, n);
}
constexpr double kSection = 0.31 * 0.37;

double sumOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

void expectEnds(const CutCells& cells, int first, int last) {
  std::array<OpenSum, 2> ends;
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    if (!isOpenPatch(cells, a)) continue;
    ASSERT_EQ(cells.arcs.axis[a], 0);
    const bool isUp = cells.arcs.above[a] == CutCells::kBeyond;
    ASSERT_EQ(cells.arcs.cell[a].i, isUp ? last : first);
    EXPECT_EQ(cells.openArcs.patchOf(static_cast<std::uint32_t>(a)), isUp ? 2U : 1U);
    EXPECT_EQ(cells.arcs.centroid[a].x, isUp ? 0.75 : 0.25);
    ends[isUp ? 1 : 0].area += cells.arcs.area[a];
    ends[isUp ? 1 : 0].moment += cells.arcs.area[a] * cells.arcs.centroid[a];
  }
  for (const auto& end : ends) {
    EXPECT_NEAR(end.area, kSection, 1e-15);
    EXPECT_NEAR(end.moment.y / end.area, 0.455, 1e-15);
    EXPECT_NEAR(end.moment.z / end.area, 0.535, 1e-15);
  }
}

TEST(OpenPatchesTest, ADuctIsOpenAtItsEnds) {
  for (const int parts : {1, 3}) {
    const CellCutter cutter(ductOf(duct(parts)), FluidSide::Inside, kEndsOpen);
    for (const int n : {4, 8, 20}) {
      const auto cells = cutter.cut(unitGrid(n), {.polygons = true, .moments = 3});
      expectIdentities(cells, 1e-14);
      const auto report = check(cells);
      EXPECT_NEAR(report.fluidVolume, 0.5 * kSection, 1e-15);
      EXPECT_NEAR(report.wallArea, 0.5 * 2 * (0.31 + 0.37), 1e-14);
      EXPECT_LT(report.worstMoments, 1e-14);
      expectEnds(cells, n / 4, n - n / 4);
      expectPolygonsOf(cells);
      EXPECT_EQ(std::ranges::count(cells.wallParts.patch, 0U), std::ssize(cells.wallParts.patch));
      const CutRegions regions(cells);
      ASSERT_EQ(regions.regions().size(), 1U);
      EXPECT_TRUE(regions.regions()[0].goesOn);
      const auto mesh = cutCellMesh(cells, true);
      EXPECT_NEAR(sumOf(std::get<std::vector<double>>(mesh.cellArrays[1].numbers)), 0.5 * kSection,
                  1e-15);
    }
  }
  const auto closed = CellCutter(ductOf(duct()), FluidSide::Inside).cut(unitGrid(8));
  EXPECT_FALSE(CutRegions(closed).regions()[0].goesOn);
}

TEST(OpenPatchesTest, OneEndMayStayAWall) {
  const CellCutter cutter(ductOf(duct()), FluidSide::Inside, {.openPatches = {"outlet"}});
  const auto cells = cutter.cut(unitGrid(8));
  expectIdentities(cells, 1e-14);
  EXPECT_NEAR(check(cells).wallArea, 0.5 * 2 * (0.31 + 0.37) + kSection, 1e-14);
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    if (isOpenPatch(cells, a)) {
      EXPECT_EQ(cells.arcs.cell[a].i, 6);
    }
  }
}

/// All that an arc says, but for the numbers of rows.
auto contentOf(const CutCells& cells, std::size_t a) {
  const auto& c = cells.arcs.centroid[a];
  const auto& at = cells.arcs.cell[a];
  return std::tuple(at.k, at.j, at.i, cells.arcs.axis[a], cells.arcs.area[a], c.x, c.y, c.z,
                    cells.arcs.below[a] == CutCells::kBeyond,
                    cells.arcs.above[a] == CutCells::kBeyond);
}

/// Cuts part of a grid's cells, and compares arcs.
void expectSameInPart(const CellCutter& cutter, const GridPatch<double>& grid, const IndexBox& part,
                      const CutCells& all) {
  std::vector<decltype(contentOf(all, 0))> expected;
  const auto isIn = [&](std::size_t a, bool isBelow) {
    const auto side = isBelow ? all.arcs.below[a] : all.arcs.above[a];
    return side < all.pieceCount &&
           part.contains(isBelow ? all.arcs.cellBelow(a) : all.arcs.cell[a]);
  };
  for (std::size_t a = 0; a < all.arcs.area.size(); ++a) {
    if (isIn(a, true) || isIn(a, false)) expected.push_back(contentOf(all, a));
  }
  const auto some = cutter.cut(GridPatch<double>{grid.level, part});
  expectIdentities(some, 1e-14);
  ASSERT_EQ(some.arcs.area.size(), expected.size());
  for (std::size_t a = 0; a < expected.size(); ++a) EXPECT_EQ(contentOf(some, a), expected[a]);
}

TEST(OpenPatchesTest, AreTheSameInEveryBoxAndForThreads) {
  const CellCutter cutter(ductOf(duct(2)), FluidSide::Inside, kEndsOpen);
  const auto grid = unitGrid(20);
  const auto all = cutter.cut(grid);
  // The ends at the rim of the box, and within it, and where tiles begin elsewhere.
  expectSameInPart(cutter, grid, {{5, 0, 0}, {14, 19, 19}}, all);
  expectSameInPart(cutter, grid, {{3, 7, 8}, {15, 11, 12}}, all);
  expectSameInPart(cutter, grid, {{2, 2, 2}, {5, 17, 17}}, all);
  const CutOptions options{.polygons = true, .moments = 2, .threads = 1};
  auto onThree = options;
  onThree.threads = 3;
  EXPECT_EQ(toBytes(cutter.cut(grid, options)), toBytes(cutter.cut(grid, onThree)));
}

/// Voxels of 1/16 around an empty one, in a row along x: the ends have a hole.
PolygonSoup ring(const std::vector<std::array<int, 2>>& empty) {
  VoxelSolid solid(1.0 / 16);
  for (int x = 4; x < 12; ++x) {
    for (int y = 5; y < 12; ++y) {
      for (int z = 5; z < 8; ++z) {
        if (std::ranges::count(empty, std::array{y, z}) == 0) solid.add({x, y, z});
      }
    }
  }
  return meshOf(solid).soup();
}

TEST(OpenPatchesTest, AnAnnulusIsOneApertureWithAHole) {
  const CellCutter cutter(ductOf(ring({{6, 6}, {9, 6}, {10, 6}})), FluidSide::Inside, kEndsOpen);
  // Faces have parts of it, with holes or without.
  for (const int n : {4, 8, 16}) {
    const auto cells = cutter.cut(unitGrid(n), {.polygons = true, .moments = 2});
    expectIdentities(cells, 1e-14);
    expectPolygonsOf(cells);
    EXPECT_LT(check(cells).worstMoments, 1e-14);
    EXPECT_NEAR(openArea(cells), 2 * 18.0 / 256, 1e-15);
  }
  // All of an end in one face.
  const std::vector<double> x{0, 0.25, 0.75, 1};
  const std::vector<double> all{0, 1};
  const auto cells = cutter.cut(cellsBetween({x, all, all}), {.polygons = true});
  expectPolygonsOf(cells);
  std::size_t arcs = 0;
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    if (!isOpenPatch(cells, a)) continue;
    ++arcs;
    EXPECT_NEAR(cells.arcs.area[a], 18.0 / 256, 1e-15);
    EXPECT_NEAR(areaVector(cells.arcPolygons.of(a)).x, 18.0 / 256, 1e-15);
  }
  EXPECT_EQ(arcs, 2U);
}

/// Which of the planes of voxels a grid has: every so many.
PolygonSoup randomlyPatched(std::mt19937& random, const VoxelSolid& solid, int each) {
  return withPatches(meshOf(solid).soup(), {"wall", "a", "b", "c"}, [&](const FlatTriangle& t) {
    const bool isOnPlane = static_cast<int>(std::lround(16 * t.middle[t.axis])) % each == 0;
    return isOnPlane ? static_cast<std::uint32_t>(random() % 4) : 0U;
  });
}

TEST(OpenPatchesTest, InRandomVoxelsTakeThePlaceOfWalls) {
  std::mt19937 random(7);
  std::size_t arcs = 0;
  for (int n = 0; n < scaled(12) && !HasFailure(); ++n) {
    const int each = 1 << n % 3;
    const auto side = n % 2 == 0 ? FluidSide::Outside : FluidSide::Inside;
    const Solid<double> solid{MeshSDF<double>(randomlyPatched(random, randomVoxels(random), each))};
    const CutOptions all{.polygons = true, .moments = 2};
    const auto grid = unitGrid(16 / each);
    const CellCutter cutter(solid, side, {.openPatches = {"c", "a"}});
    const auto open = cutter.cut(grid, all);
    const auto closed = CellCutter(solid, side).cut(grid, all);
    expectOpened(open, closed, [](std::uint32_t patch) { return patch == 1 || patch == 3; });
    expectIdentities(open, 1e-13);
    expectPolygonsOf(open);
    EXPECT_LT(check(open).worstMoments, 1e-13);
    EXPECT_EQ(toBytes(cutCellsFrom(toBytes(open))), toBytes(open));
    for (std::size_t a = 0; a < open.arcs.area.size(); ++a) arcs += isOpenPatch(open, a) ? 1U : 0U;
  }
  EXPECT_GT(arcs, 1000U);
}

/// What open patches have of the faces of each cell, and the number of its pieces.
auto openOf(const CutCells& cells) {
  std::map<std::tuple<int, int, int, std::uint32_t>, std::array<double, 6>> result;
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) {
    const auto& at = cells.cells.index[cells.pieces.cell[p]];
    result[{at.i, at.j, at.k, CutCells::kNoRow}][0] += 1;
  }
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto patch = cells.openArcs.patchOf(static_cast<std::uint32_t>(a));
    if (patch == CutCells::kNoRow) continue;
    const bool isUp = cells.arcs.above[a] == CutCells::kBeyond;
    const auto at = isUp ? cells.arcs.cellBelow(a) : cells.arcs.cell[a];
    result[{at.i, at.j, at.k, patch}][2 * cells.arcs.axis[a] + (isUp ? 1 : 0)] +=
        cells.arcs.area[a];
  }
  return result;
}

TEST(OpenPatchesTest, CoarsenedCellsAreThoseOfTheCoarseGrid) {
  std::mt19937 random(3);
  for (int n = 0; n < scaled(6) && !HasFailure(); ++n) {
    const auto side = n % 2 == 0 ? FluidSide::Outside : FluidSide::Inside;
    const Solid<double> solid{MeshSDF<double>(randomlyPatched(random, randomVoxels(random), 2))};
    const CellCutter cutter(solid, side, {.openPatches = {"a", "b"}});
    const auto fine = cutter.cut(unitGrid(24, -0.25, 1.25), {.moments = 2});
    const auto half = coarsened(fine, {2, 2, 2});
    expectIdentities(half, 1e-13);
    EXPECT_LT(check(half).worstMoments, 1e-13);
    const auto expected = openOf(cutter.cut(unitGrid(12, -0.25, 1.25)));
    const auto found = openOf(half);
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [cell, sums] : expected) {
      const auto same = found.find(cell);
      ASSERT_NE(same, found.end());
      for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_NEAR(same->second[i], sums[i], 1e-16);
    }
    const auto again = refusal([&] { return coarsened(half, {2, 2, 2}); });
    EXPECT_NE(again.find("need open patches in planes between coarse cells"), std::string::npos);
  }
}

TEST(OpenPatchesTest, FilesWithOtherOpenArcsAreRefused) {
  const auto cells = CellCutter(ductOf(duct()), FluidSide::Inside, kEndsOpen).cut(unitGrid(8));
  const auto flawWith = [&](const std::function<void(CutCells&)>& damage) {
    auto damaged = cells;
    damage(damaged);
    return refusal([&] { return toBytes(damaged); });
  };
  const std::string need = "toBytes: need cut cells as they are made: ";
  const auto flaw = need + "its arcs do not lie between its pieces";
  const auto openFlaw = need + "its open patches are not those of arcs";
  EXPECT_EQ(flawWith([](CutCells&) {}), "");
  EXPECT_EQ(flawWith([](CutCells& c) { c.openArcs = {}; }), flaw);
  EXPECT_EQ(flawWith([](CutCells& c) { c.openArcs.arc.pop_back(); }), flaw);
  EXPECT_EQ(flawWith([](CutCells& c) { c.openArcs.patch.pop_back(); }), openFlaw);
  EXPECT_EQ(flawWith([](CutCells& c) { c.openArcs.patch[0] = 3; }), openFlaw);
  EXPECT_EQ(flawWith([](CutCells& c) { std::swap(c.openArcs.arc[0], c.openArcs.arc[1]); }),
            openFlaw);
  EXPECT_EQ(flawWith([](CutCells& c) {
              const auto a = c.openArcs.arc[0];
              std::swap(c.arcs.below[a], c.arcs.above[a]);
            }),
            flaw);
  auto bytes = toBytes(cells);
  EXPECT_EQ(toBytes(cutCellsFrom(bytes)), bytes);
}

TEST(OpenPatchesTest, MergingKeepsCellsThatOpenPatchesBoundAlone) {
  const CellCutter cutter(ductOf(duct()), FluidSide::Inside, kEndsOpen);
  const auto cells = cutter.cut(unitGrid(20), {.moments = 1});
  const auto isWithoutWall = [](double area) { return area == 0; };
  EXPECT_GT(std::ranges::count_if(cells.pieces.wallArea, isWithoutWall), 20);
  const auto [single, lost] = merged(cells);
  EXPECT_TRUE(lost.empty());
  EXPECT_EQ(single.pieces.volume, cells.pieces.volume);
  expectIdentities(single, 1e-14);
  EXPECT_LT(check(single).worstMoments, 1e-14);
  expectEnds(single, 5, 15);
  // Covering what is small closes nothing that is beyond an open patch.
  const auto smaller = merged(cells, {.smallest = 0.3});
  EXPECT_GT(smaller.lost.size(), 0U);
  expectIdentities(smaller.cells, 1e-14);
}

}  // namespace
}  // namespace cutwater::test
