// toBytes(), cutCellsFrom(), saveCutCells() and loadCutCells().

#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/RandomVoxels.hpp"
#include "CutCells/RowFiles.hpp"
#include "Support/FileRefusal.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

/// A box across cells with a ball beside it, in a patch each: walls in planes of the grid, bubbles,
/// thin cells, cells beyond the box.
CutCells cutTwo(const CutOptions& options, FluidSide side = FluidSide::Outside) {
  auto soup = together(tessellation::box({0.25, 0.25, -0.5}, {0.5, 0.75, 0.6}),
                       tessellation::icosphere(0.12, 1));
  soup.patchNames = {"box", "", "a ball"};
  for (std::size_t i = 6; i < soup.polygonCount(); ++i) soup.patches[i] = 2;
  const CellCutter cutter(Solid<double>(MeshSDF<double>(soup)), side);
  return cutter.cut(
      GridPatch<double>{Level<double>({-1, -1, -1}, {0.25, 0.25, 0.25}), {{3, 3, 3}, {5, 6, 5}}},
      options);
}

/// One cell with a part of a tetrahedron's wall: a small file.
CutCells cutOne(bool polygons) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(tetrahedron()))};
  return cutter.cut(cellsBetween({{{0.125, 1}, {0.125, 1}, {0.25, 1}}}, {-1, 0, 7}),
                    {.polygons = polygons});
}

/// Everything there is.
void expectSame(const CutCells& a, const CutCells& b) {
  EXPECT_EQ(a.grid.planes, b.grid.planes);
  EXPECT_EQ(a.grid.first, b.grid.first);
  EXPECT_EQ(a.cells.index, b.cells.index);
  EXPECT_EQ(a.cells.firstPiece, b.cells.firstPiece);
  EXPECT_EQ(a.cells.fluidCorners, b.cells.fluidCorners);
  EXPECT_EQ(a.cells.meets, b.cells.meets);
  EXPECT_EQ(a.cells.wallFaces, b.cells.wallFaces);
  EXPECT_EQ(a.arcs.cell, b.arcs.cell);
  EXPECT_EQ(a.cellCount, b.cellCount);
  EXPECT_EQ(a.pieceCount, b.pieceCount);
  EXPECT_EQ(a.bodyRuns, b.bodyRuns);
  expectSameRows(a, b);
}

void expectComesBack(const CutCells& cells) {
  const auto bytes = toBytes(cells);
  const auto back = cutCellsFrom(bytes);
  expectSame(back, cells);
  EXPECT_EQ(toBytes(back), bytes);
}

TEST(CutCellsFileTest, RowsComeBackToTheBit) {
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    for (const bool polygons : {false, true}) {
      const auto cells = cutTwo({.polygons = polygons, .moments = polygons ? -1 : 2}, side);
      ASSERT_GT(cells.cells.index.size(), cells.cellCount);
      ASSERT_EQ(cells.patchNames.size(), 3U);
      ASSERT_FALSE(cells.bodyRuns.empty());
      expectComesBack(cells);
      expectComesBack(merged(cells).cells);
    }
  }
  expectComesBack(cutOne(true));
}

TEST(CutCellsFileTest, SoDoCoarserCellsAndThoseWithoutASurface) {
  const CellCutter cutter(Solid<double>(MeshSDF<double>(tessellation::torus(0.3, 0.1, 24, 12))));
  const Level<double> level({-0.5, -0.5, -0.5}, {0.125, 0.125, 0.125});
  const auto cells = cutter.cut(GridPatch<double>{level, IndexBox::ofSize(8, 8, 8)});
  for (const int ratio : {1, 2, 8}) expectComesBack(coarsened(cells, {ratio, ratio, ratio}));
  const auto far = cutter.cut(GridPatch<double>{level, {{70, 0, 0}, {72, 1, 1}}});
  ASSERT_EQ(far.cellCount, 0U);
  expectComesBack(far);
}

TEST(CutCellsFileTest, SoDoCellsOfRandomVoxels) {
  std::mt19937 random(3);
  for (int n = 0; n < scaled(20); ++n) {
    const CellCutter cutter{Solid<double>(meshOf(randomVoxels(random)))};
    // In planes of the grid, or between them.
    const double lower = n % 2 == 0 ? 0 : -0.0113;
    const Level<double> level({lower, lower, lower}, {1.0 / 16, 1.0 / 16, 1.0 / 16});
    const auto cells = cutter.cut(GridPatch<double>{level, IndexBox::ofSize(12, 12, 12)});
    expectComesBack(cells);
    expectComesBack(coarsened(cells, {3, 2, 4}));
    expectComesBack(merged(cells, {.smallest = 0.3}).cells);
  }
}

TEST(CutCellsFileTest, AFileHoldsTheBytes) {
  const TemporaryFolder folder;
  const auto cells = cutTwo({.polygons = true});
  saveCutCells(folder / "two.cells", cells);
  EXPECT_EQ(folder.fileCount(), 1U);
  const auto content = contentOf(folder / "two.cells");
  EXPECT_TRUE(std::ranges::equal(std::as_bytes(std::span(content)), toBytes(cells)));
  expectSame(loadCutCells(folder / "two.cells"), cells);
}

TEST(CutCellsFileTest, HasTheBytesOfItsVersion) {
  // If the layout has changed, raise the version in the file's head, and write down the new value.
  const auto bytes = toBytes(cutOne(true));
  EXPECT_EQ(std::to_integer<int>(bytes[8]), 5);
  EXPECT_EQ(xxHash64(bytes), 0x38f5fc426a398555U);
}

TEST(CutCellsFileTest, EveryBitCounts) {
  const auto bytes = toBytes(cutOne(true));
  ASSERT_LT(bytes.size(), 6000U);
  expectEveryBitCounts(bytes, cutCellsFrom);
}

TEST(CutCellsFileTest, RefusesBytesThatAreCutOffOrFollowedByOthers) {
  expectNeedsItsLength(toBytes(cutOne(false)), cutCellsFrom);
}

/// All that can be asked of cut cells.
void ask(const CutCells& cells) {
  static_cast<void>(check(cells));
  static_cast<void>(coarsened(cells, {1, 1, 1}));
  static_cast<void>(merged(cells, {.smallest = 0.5}));
  if (!cells.firstWallPolygon.empty()) static_cast<void>(cutCellMesh(cells, true));
}

TEST(CutCellsFileTest, CellsWithAForgedChecksumAreRefusedOrSafeToUse) {
  expectForgeriesAreSafe(toBytes(cutTwo({.polygons = true})), scaled(2000), cutCellsFrom, ask);
}

/// What toBytes() says of two boxes' cells once something in them is changed.
std::string flawWith(const std::function<void(CutCells&)>& change) {
  return flawAfter(cutTwo({.polygons = true, .moments = 1}), change);
}

TEST(CutCellsFileTest, PlanesAndCellsAreThoseOfAGrid) {
  const std::string planes = "its planes are not those of a grid";
  const std::string cells = "its cells are not those of a grid, in order";
  const std::string runs = "its runs of cells without fluid are none";
  EXPECT_EQ(flawWith([](CutCells&) {}), "");
  EXPECT_EQ(flawWith([](CutCells& c) { c = {}; }), planes);
  EXPECT_EQ(flawWith([](CutCells& c) { c.grid.planes[1][2] = c.grid.planes[1][3]; }), planes);
  EXPECT_EQ(flawWith([](CutCells& c) { c.grid.planes[2].back() = INFINITY; }), planes);
  EXPECT_EQ(flawWith([](CutCells& c) { c.grid.first.i = INT32_MAX - 2; }), planes);
  EXPECT_EQ(flawWith([](CutCells& c) { c.grid.first.j = INT32_MIN; }), planes);
  EXPECT_EQ(flawWith([](CutCells& c) { c.grid.first.k += 1; }), cells);
  EXPECT_EQ(flawWith([](CutCells& c) { std::swap(c.cells.index[0], c.cells.index[1]); }), cells);
  EXPECT_EQ(flawWith([](CutCells& c) { c.cells.index.back().i += 9; }), cells);
  EXPECT_EQ(flawWith([](CutCells& c) { --c.cellCount; }), cells);
  EXPECT_EQ(flawWith([](CutCells& c) { c.cells.fluidCorners.pop_back(); }), cells);
  EXPECT_EQ(flawWith([](CutCells& c) { c.cells.meets.pop_back(); }), cells);
  EXPECT_EQ(flawWith([](CutCells& c) { c.cells.wallFaces.pop_back(); }), cells);
  EXPECT_EQ(flawWith([](CutCells& c) { c.cells.firstPiece.back() += 1; }), cells);
  EXPECT_EQ(flawWith([](CutCells& c) { c.cells.firstPiece[1] = 1000; }), cells);
  EXPECT_EQ(flawWith([](CutCells& c) { c.bodyRuns.back()[1] = 37; }), runs);
  EXPECT_EQ(flawWith([](CutCells& c) { c.bodyRuns.push_back(c.bodyRuns.back()); }), runs);
}

TEST(CutCellsFileTest, RowsSayNothingThatOthersDeny) {
  const std::string pieces = "its pieces do not belong to its cells";
  const std::string arcs = "its arcs do not lie between its pieces";
  const std::string walls = "its walls do not belong to its pieces";
  const std::string polygons = "its polygons do not belong to its arcs and walls";
  EXPECT_EQ(flawWith([](CutCells& c) { ++c.pieceCount; }), pieces);
  EXPECT_EQ(flawWith([](CutCells& c) { c.pieces.cell[1] = 0; }), pieces);
  EXPECT_EQ(flawWith([](CutCells& c) { c.pieces.wallFaces.pop_back(); }), pieces);
  EXPECT_EQ(flawWith([](CutCells& c) { c.pieces.wallFaces[1] ^= 4; }), pieces);
  EXPECT_EQ(flawWith([](CutCells& c) { c.cells.wallFaces[0] = c.pieces.wallFaces[0] = 64; }),
            pieces);
  EXPECT_EQ(flawWith([](CutCells& c) { c.pieces.wallArea.pop_back(); }), pieces);
  EXPECT_EQ(flawWith([](CutCells& c) { c.pieces.centroid[2].y = NAN; }), pieces);
  EXPECT_EQ(flawWith([](CutCells& c) { c.arcs.axis[3] = 3; }), arcs);
  EXPECT_EQ(flawWith([](CutCells& c) { c.arcs.above.push_back(0); }), arcs);
  EXPECT_EQ(flawWith([](CutCells& c) { std::swap(c.arcs.below[0], c.arcs.above[0]); }), arcs);
  EXPECT_EQ(flawWith([](CutCells& c) { c.arcs.below[5] = CutCells::kNoRow; }), arcs);
  EXPECT_EQ(flawWith([](CutCells& c) { c.arcs.area[0] = INFINITY; }), arcs);
  EXPECT_EQ(flawWith([](CutCells& c) { c.arcs.cell[0].k -= 2; }), arcs);
  EXPECT_EQ(flawWith([](CutCells& c) { c.wallParts.patch[0] = 3; }), walls);
  EXPECT_EQ(flawWith([](CutCells& c) { c.wallParts.piece.back() = 1000; }), walls);
  EXPECT_EQ(flawWith([](CutCells& c) { c.wallParts.piece.front() = 5; }), walls);
  const std::string moments = "its moments do not belong to its pieces and arcs";
  EXPECT_EQ(flawWith([](CutCells& c) { c.moments.degree = 5; }), moments);
  EXPECT_EQ(flawWith([](CutCells& c) { c.moments.degree = -1; }), moments);
  EXPECT_EQ(flawWith([](CutCells& c) { c.moments.arc.pop_back(); }), moments);
  EXPECT_EQ(flawWith([](CutCells& c) { c.moments.wallVector[3].z = NAN; }), moments);
  EXPECT_EQ(flawWith([](CutCells& c) { c.wallPolygons.points[0].x = NAN; }), polygons);
  EXPECT_EQ(flawWith([](CutCells& c) { c.arcPolygons.first.pop_back(); }), polygons);
  EXPECT_EQ(flawWith([](CutCells& c) { c.arcPolygons.add({}); }), polygons);
  EXPECT_EQ(flawWith([](CutCells& c) { c.firstWallPolygon.clear(); }), polygons);
  EXPECT_EQ(flawWith([](CutCells& c) { c.firstWallPolygon.back() -= 1; }), polygons);
}

/// What loadCutCells() says of a file with this content, without the file's name.
std::string refusalOfFile(const std::string& content) {
  return fileRefusal(content, [](const auto& path) { return loadCutCells(path); });
}

TEST(CutCellsFileTest, SaysWhatAFileIsThatIsNone) {
  EXPECT_EQ(refusalOfFile(""), "there is nothing in it");
  EXPECT_EQ(refusalOfFile("solid hull\n"), "this is no file of cut cells");
  auto bytes = toBytes(cutOne(false));
  const auto asFile = [&] {
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  EXPECT_EQ(refusalOfFile(asFile().substr(0, 20)),
            "the file of cut cells is damaged: it ends within its head");
  put(bytes, 8, std::uint32_t{7});
  EXPECT_EQ(refusalOfFile(asFile()),
            "the file of cut cells has version 7, this library reads version 5: cut the cells "
            "anew");
  put(bytes, 12, std::uint32_t{0x04030201});
  EXPECT_EQ(refusalOfFile(asFile()),
            "the file of cut cells was written on a machine with another byte order");
  const TemporaryFolder folder;
  try {
    static_cast<void>(loadCutCells(folder / "missing"));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::File);
    EXPECT_NE(std::string(error.what()).find("missing"), std::string::npos);
  }
}

}  // namespace
}  // namespace cutwater::test
