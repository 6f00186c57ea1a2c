// Cut cells through the C API, beside the library itself.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cstring>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "Bindings/CApiHandles.hpp"
#include "Support/Soups.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

/// A ball beside a thin plate, in a patch each.
PolygonSoup ballAndPlate() {
  auto soup = together(tessellation::icosphere(0.3, 2),
                       tessellation::box({-0.9, -0.9, 0.401}, {0.9, 0.9, 0.402}, 1));
  const auto ofBall = tessellation::icosphere(0.3, 2).polygonCount();
  soup.patchNames = {"ball", "plate"};
  for (std::size_t i = ofBall; i < soup.polygonCount(); ++i) soup.patches[i] = 1;
  return soup;
}

/// Turned, through C.
SolidHandle solidOfC() {
  const auto soup = MeshSDF<double>(ballAndPlate()).soup();
  const std::vector<std::int32_t> corners(soup.corners.begin(), soup.corners.end());
  const std::vector<std::int32_t> patches(soup.patches.begin(), soup.patches.end());
  const std::array<const char*, 2> names{"ball", "plate"};
  const cw_mesh arrays{&soup.points[0].x, static_cast<std::int64_t>(soup.points.size()),
                       corners.data(),    static_cast<std::int64_t>(patches.size()),
                       patches.data(),    2,
                       names.data()};
  const auto mesh = made([&](cw_solid** out) { return cw_from_mesh(&arrays, 1, out); });
  const double axis[3] = {1, 2, 3};
  return made([&](cw_solid** out) { return cw_rotated(mesh.get(), 33, axis, nullptr, out); });
}

/// The same by the library.
Solid<double> solidOfLibrary() {
  Solid<double> solid{MeshSDF<double>(ballAndPlate())};
  solid.rotate(33, {1, 2, 3});
  return solid;
}

constexpr cw_grid kGrid{{-1, -1, -1}, {0.1, 0.125, 0.2}, {2, 1, 0}, {17, 14, 8}, {1, 2, 3}, 0};

GridPatch<double> patchOfGrid() {
  return {Level<double>({-1, -1, -1}, {0.1, 0.125, 0.2}), IndexBox{{2, 1, 0}, {17, 14, 8}}};
}

template <typename Value, typename Record>
void expectArray(const Value* found, const std::vector<Record>& expected) {
  if (expected.empty()) return;
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(std::memcmp(found, expected.data(), expected.size() * sizeof(Record)), 0);
}

void expectCellsAndPieces(const cw_cells* cells, const CutCells& expected) {
  cw_cut_cells rows;
  ASSERT_EQ(cw_cells_rows(cells, &rows), CW_OK);
  const auto& own = expected.cells;
  ASSERT_EQ(rows.count, static_cast<std::int64_t>(expected.cellCount));
  ASSERT_EQ(rows.count + rows.countAround, std::ssize(own.index));
  expectArray(rows.index, own.index);
  expectArray(rows.firstPiece, own.firstPiece);
  expectArray(rows.fluidCorners, own.fluidCorners);
  expectArray(rows.meets, own.meets);
  expectArray(rows.wallFaces, own.wallFaces);
  cw_pieces pieces;
  ASSERT_EQ(cw_cells_pieces(cells, &pieces), CW_OK);
  ASSERT_EQ(pieces.count, static_cast<std::int64_t>(expected.pieceCount));
  ASSERT_EQ(pieces.count + pieces.countAround, std::ssize(expected.pieces.cell));
  expectArray(pieces.cell, expected.pieces.cell);
  expectArray(pieces.volume, expected.pieces.volume);
  expectArray(pieces.centroid, expected.pieces.centroid);
  expectArray(pieces.wallArea, expected.pieces.wallArea);
  expectArray(pieces.wallVector, expected.pieces.wallVector);
  expectArray(pieces.wallCentroid, expected.pieces.wallCentroid);
  expectArray(pieces.wallFaces, expected.pieces.wallFaces);
}

void expectArcsAndWalls(const cw_cells* cells, const CutCells& expected) {
  cw_arcs arcs;
  ASSERT_EQ(cw_cells_arcs(cells, &arcs), CW_OK);
  ASSERT_EQ(arcs.count, std::ssize(expected.arcs.area));
  expectArray(arcs.below, expected.arcs.below);
  expectArray(arcs.above, expected.arcs.above);
  expectArray(arcs.area, expected.arcs.area);
  expectArray(arcs.centroid, expected.arcs.centroid);
  expectArray(arcs.cell, expected.arcs.cell);
  expectArray(arcs.axis, expected.arcs.axis);
  cw_wall_parts walls;
  ASSERT_EQ(cw_cells_wall_parts(cells, &walls), CW_OK);
  ASSERT_EQ(walls.count, std::ssize(expected.wallParts.area));
  expectArray(walls.piece, expected.wallParts.piece);
  expectArray(walls.patch, expected.wallParts.patch);
  expectArray(walls.area, expected.wallParts.area);
  expectArray(walls.vector, expected.wallParts.vector);
  expectArray(walls.centroid, expected.wallParts.centroid);
}

void expectPolygons(const cw_cells* cells, const CutCells& expected) {
  cw_polygons outlines;
  ASSERT_EQ(cw_cells_arc_polygons(cells, &outlines), CW_OK);
  ASSERT_EQ(outlines.count, static_cast<std::int64_t>(expected.arcPolygons.count()));
  expectArray(outlines.first, expected.arcPolygons.first);
  expectArray(outlines.points, expected.arcPolygons.points);
  cw_polygons walls;
  const std::int64_t* first = nullptr;
  ASSERT_EQ(cw_cells_wall_polygons(cells, &walls, &first), CW_OK);
  ASSERT_EQ(walls.count, static_cast<std::int64_t>(expected.wallPolygons.count()));
  expectArray(walls.first, expected.wallPolygons.first);
  expectArray(walls.points, expected.wallPolygons.points);
  expectArray(first, expected.firstWallPolygon);
}

void expectRows(const cw_cells* cells, const CutCells& expected) {
  expectCellsAndPieces(cells, expected);
  expectArcsAndWalls(cells, expected);
  expectPolygons(cells, expected);
}

TEST(CApiCellsTest, RowsHaveTheLibrarysBits) {
  const auto solid = solidOfC();
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const int inside = side == FluidSide::Inside ? 1 : 0;
    const CellCutter cutter(solidOfLibrary(), side);
    for (const bool polygons : {false, true}) {
      const auto cells = cellsOf([&](auto* r) {
        return cw_cut_grid(solid.get(), &kGrid, inside, polygons ? 1 : 0, 0, r);
      });
      const auto expected = cutter.cut(patchOfGrid(), {.polygons = polygons});
      ASSERT_GT(expected.pieceCount, expected.cellCount);  // the plate leaves cells in two
      expectRows(cells.get(), expected);
    }
  }
}

TEST(CApiCellsTest, PlanesMayBeAnywhere) {
  const std::vector<double> x{-1, -0.3, 0.05, 0.1, 0.9};
  const std::vector<double> y{-0.5, -0.1, 0.4};
  const std::vector<double> z{-0.7, 0.3, 0.55, 2};
  const cw_planes planes{{x.data(), y.data(), z.data()}, {5, 3, 4}, {-3, 7, 0}};
  const auto solid = solidOfC();
  const auto cells =
      cellsOf([&](auto* r) { return cw_cut_planes(solid.get(), &planes, 0, 1, 2, r); });
  expectRows(
      cells.get(),
      CellCutter(solidOfLibrary()).cut(cellsBetween({x, y, z}, {-3, 7, 0}), {.polygons = true}));
}

TEST(CApiCellsTest, CellsAreMadeOfCellsAndComeBackFromFiles) {
  const TemporaryFolder folder;
  const auto path = (folder / "a.cells").string();
  const auto solid = solidOfC();
  const auto cells = cellsOf([&](auto* r) { return cw_cut_grid(solid.get(), &kGrid, 0, 0, 0, r); });
  const auto expected = CellCutter(solidOfLibrary()).cut(patchOfGrid());
  const std::array<std::int32_t, 3> ratios{2, 1, 3};
  const auto coarse = cellsOf([&](auto* r) { return cw_coarsened(cells.get(), ratios.data(), r); });
  expectRows(coarse.get(), coarsened(expected, {2, 1, 3}));
  const auto single = cellsOf([&](auto* r) { return cw_merged(cells.get(), 0.1, r); });
  expectRows(single.get(), merged(expected, {.smallest = 0.1}).cells);
  ASSERT_EQ(cw_save_cells(cells.get(), path.c_str()), CW_OK) << cw_last_error();
  const auto loaded = cellsOf([&](auto* r) { return cw_load_cells(path.c_str(), r); });
  expectRows(loaded.get(), expected);
}

/// A box with named ends along x; without the last triangle, it has a hole.
PolygonSoup duct(bool isOpen) {
  auto soup = MeshSDF<double>(tessellation::box({-0.75, -0.6, -0.55}, {0.75, 0.6, 0.55}, 3)).soup();
  soup.patchNames = {"walls", "inlet", "outlet"};
  PolygonSoup result;
  result.points = soup.points;
  result.patchNames = soup.patchNames;
  for (std::size_t i = isOpen ? 1 : 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    const auto isAt = [&](double x) {
      return std::ranges::all_of(p, [&](auto c) { return soup.points[c].x == x; });
    };
    const std::uint32_t patch = isAt(-0.75) ? 1 : isAt(0.75) ? 2 : 0;
    result.addPolygon(p, patch);
  }
  return result;
}

TEST(CApiCellsTest, CuttersHaveOpenPatchesAndCaps) {
  constexpr cw_grid grid{{-1, -1, -1}, {0.25, 0.25, 0.25}, {0, 0, 0}, {7, 7, 7}, {0, 0, 0}, 0};
  const GridPatch<double> patch{Level<double>({-1, -1, -1}, {0.25, 0.25, 0.25}),
                                IndexBox::ofSize(8, 8, 8)};
  const std::array<const char*, 2> names{"outlet", "inlet"};
  for (const bool isOpen : {false, true}) {
    const auto soup = duct(isOpen);
    const std::vector<std::int32_t> corners(soup.corners.begin(), soup.corners.end());
    const std::vector<std::int32_t> patches(soup.patches.begin(), soup.patches.end());
    const std::array<const char*, 3> all{"walls", "inlet", "outlet"};
    const cw_mesh arrays{&soup.points[0].x,   std::ssize(soup.points), corners.data(),
                         std::ssize(patches), patches.data(),          3,
                         all.data()};
    const auto solid = made([&](cw_solid** out) { return cw_from_mesh(&arrays, 0, out); });
    const cw_cutter_options options{1, isOpen ? 1 : 0, names.data(), 2, {0, 0, 0}, nullptr, 0};
    cw_cutter* made = nullptr;
    ASSERT_EQ(cw_make_cutter(solid.get(), &options, &made), CW_OK) << cw_last_error();
    const CutterHandle cutter(made, &cw_free_cutter);
    const CellCutter expected(Solid<double>(MeshSDF<double>(soup)), FluidSide::Inside,
                              {.capHoles = isOpen, .openPatches = {"outlet", "inlet"}});
    const auto rows = expected.cut(patch, {.polygons = true});
    ASSERT_GT(rows.openArcs.arc.size(), 30U);
    const auto cells =
        cellsOf([&](auto* r) { return cw_cutter_grid(cutter.get(), &grid, 1, 0, r); });
    expectRows(cells.get(), rows);
    cw_open_arcs open;
    ASSERT_EQ(cw_cells_open_arcs(cells.get(), &open), CW_OK);
    ASSERT_EQ(open.count, std::ssize(rows.openArcs.arc));
    expectArray(open.arc, rows.openArcs.arc);
    expectArray(open.patch, rows.openArcs.patch);
    std::int32_t count = 0;
    ASSERT_EQ(cw_cells_patch_count(cells.get(), &count), CW_OK);
    ASSERT_EQ(count, isOpen ? 4 : 3);
    const char* name = nullptr;
    ASSERT_EQ(cw_cells_patch_name(cells.get(), count - 1, &name), CW_OK);
    EXPECT_STREQ(name, isOpen ? "cap" : "outlet");
    const std::vector<double> planes{-0.75, 0, 0.75};
    const cw_planes between{{planes.data(), planes.data(), planes.data()}, {3, 3, 3}, {0, 0, 0}};
    const auto large =
        cellsOf([&](auto* r) { return cw_cutter_planes(cutter.get(), &between, 0, 0, r); });
    expectRows(large.get(), expected.cut(cellsBetween({planes, planes, planes})));
  }
}

TEST(CApiCellsTest, CuttersHaveBaffles) {
  const auto solid = solidOfC();
  const std::array<const char*, 1> names{"plate"};
  const cw_cutter_options options{0, 0, nullptr, 0, {0, 0, 0}, names.data(), 1};
  cw_cutter* made = nullptr;
  ASSERT_EQ(cw_make_cutter(solid.get(), &options, &made), CW_OK) << cw_last_error();
  const CutterHandle cutter(made, &cw_free_cutter);
  const CellCutter expected(solidOfLibrary(), FluidSide::Outside, {.baffles = {"plate"}});
  const auto rows = expected.cut(patchOfGrid(), {.polygons = true});
  ASSERT_GT(std::ranges::count(rows.cells.meets, 1), 30);
  const auto cells =
      cellsOf([&](auto* r) { return cw_cutter_grid(cutter.get(), &kGrid, 1, 0, r); });
  expectRows(cells.get(), rows);
}

TEST(CApiCellsTest, CuttersMayHaveAPeriod) {
  constexpr cw_grid grid{{-1, -1, -1}, {0.25, 0.25, 0.25}, {-2, 0, 0}, {5, 7, 7}, {0, 0, 0}, 0};
  const auto solid = solidOfC();
  const cw_cutter_options options{0, 0, nullptr, 0, {2, 0, 2}, nullptr, 0};
  cw_cutter* made = nullptr;
  ASSERT_EQ(cw_make_cutter(solid.get(), &options, &made), CW_OK) << cw_last_error();
  const CutterHandle cutter(made, &cw_free_cutter);
  const CellCutter expected(solidOfLibrary(), FluidSide::Outside, {.period = {2, 0, 2}});
  const auto cells = cellsOf([&](auto* r) { return cw_cutter_grid(cutter.get(), &grid, 0, 0, r); });
  const Level<double> level({-1, -1, -1}, {0.25, 0.25, 0.25});
  expectRows(cells.get(), expected.cut(GridPatch<double>{level, {{-2, 0, 0}, {5, 7, 7}}}));
  const std::vector<double> x{-1, -0.3, 0.05, 0.1, 1};
  const std::vector<double> y{-0.5, -0.1, 0.4};
  const cw_planes planes{{x.data(), y.data(), x.data()}, {5, 3, 5}, {-3, 7, 0}};
  const auto grown =
      cellsOf([&](auto* r) { return cw_cutter_planes(cutter.get(), &planes, 0, 0, r); });
  expectRows(grown.get(),
             expected.cut(expected.cellsOfPeriod({x, y, x}, {-3, 7, 0}, {{-3, 7, 0}, {0, 8, 3}})));
}

TEST(CApiCellsTest, FractionsAreThoseOfAllCells) {
  const auto solid = solidOfC();
  for (const int inside : {0, 1}) {
    const auto cells =
        cellsOf([&](auto* r) { return cw_cut_grid(solid.get(), &kGrid, inside, 0, 0, r); });
    const auto expected =
        CellCutter(solidOfLibrary(), inside == 1 ? FluidSide::Inside : FluidSide::Outside)
            .cut(patchOfGrid());
    const auto box = expected.grid.indices();
    std::vector<double> fractions(box.count(), 7);
    ASSERT_EQ(cw_fluid_fractions(cells.get(), fractions.data(), std::ssize(fractions)), CW_OK);
    double volume = 0;
    std::size_t n = 0;
    for (std::uint32_t k = 0; k < box.length(2); ++k) {
      for (std::uint32_t j = 0; j < box.length(1); ++j) {
        for (std::uint32_t i = 0; i < box.length(0); ++i, ++n) {
          const auto cell = box.at(i, j, k);
          const auto found = expected.classOf(cell);
          ASSERT_TRUE(found == FluidClass::Cut ||
                      fractions[n] == (found == FluidClass::Fluid ? 1.0 : 0.0));
          ASSERT_TRUE(fractions[n] >= 0 && fractions[n] <= 1);
          volume += fractions[n] * expected.cellVolume(cell);
        }
      }
    }
    EXPECT_NEAR(volume, check(expected).fluidVolume, 1e-12);
  }
}

TEST(CApiCellsTest, ManyThreadsCutAtOnce) {
  const auto solid = solidOfC();
  const auto expected = CellCutter(solidOfLibrary()).cut(patchOfGrid());
  std::vector<CellsHandle> found;
  for (int t = 0; t < 4; ++t) found.emplace_back(nullptr, &cw_free_cells);
  std::vector<std::thread> threads;
  for (auto& cells : found) {
    threads.emplace_back([&] {  // all at once make what cuts
      cells = cellsOf([&](auto* r) { return cw_cut_grid(solid.get(), &kGrid, 0, 0, 1, r); });
    });
  }
  for (auto& thread : threads) thread.join();
  for (const auto& cells : found) expectRows(cells.get(), expected);
}

}  // namespace
}  // namespace cutwater::test
