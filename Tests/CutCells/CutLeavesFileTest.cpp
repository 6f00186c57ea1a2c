// toBytes(), cutLeavesFrom(), saveCutLeaves() and loadCutLeaves().

#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "CutCells/RowFiles.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

/// A box with a ball beside it, in a patch each: walls in planes of leaves, bubbles, thin leaves.
CellCutter leafCutter(FluidSide side = FluidSide::Outside) {
  auto soup = together(tessellation::box({0.25, 0.25, 0.25}, {0.5, 0.75, 0.6}),
                       tessellation::icosphere(0.12, 1));
  soup.patchNames = {"box", "", "a ball"};
  for (std::size_t i = 6; i < soup.polygonCount(); ++i) soup.patches[i] = 2;
  return CellCutter(Solid<double>(MeshSDF<double>(soup)), side);
}

/// Leaves of several levels around both.
Mesh leafMesh() {
  std::mt19937 random(4);
  return dividedMesh(random, 3, -1, 2, 90);
}

/// Part of a mesh around one corner of the box: a small file.
CutLeaves cutFew(bool polygons) {
  const Mesh mesh({{-1, -1, -1}, 2, {1, 1, 1}}, 2,
                  {{.index = {2, 2, 2}, .level = 2}, {.index = {3, 2, 2}, .level = 2}});
  return leafCutter().cut(mesh, {.polygons = polygons});
}

void expectSameLeaves(const CutLeaves& a, const CutLeaves& b) {
  EXPECT_EQ(a.cut.leaf, b.cut.leaf);
  ASSERT_EQ(a.cut.box.size(), b.cut.box.size());
  for (std::size_t row = 0; row < a.cut.box.size(); ++row) {
    EXPECT_EQ(a.cut.box[row].lower, b.cut.box[row].lower);
    EXPECT_EQ(a.cut.box[row].upper, b.cut.box[row].upper);
  }
  EXPECT_EQ(a.cut.firstPiece, b.cut.firstPiece);
  EXPECT_EQ(a.cut.fluidCorners, b.cut.fluidCorners);
  EXPECT_EQ(a.cut.meets, b.cut.meets);
  EXPECT_EQ(a.cut.wallFaces, b.cut.wallFaces);
  EXPECT_EQ(a.arcs.leafBelow, b.arcs.leafBelow);
  EXPECT_EQ(a.arcs.leafAbove, b.arcs.leafAbove);
  EXPECT_EQ(a.arcs.faceArea, b.arcs.faceArea);
  EXPECT_EQ(a.classes, b.classes);
  EXPECT_EQ(a.wholeFluid, b.wholeFluid);
  EXPECT_EQ(a.wholeBody, b.wholeBody);
  expectSameRows(a, b);
}

void expectLeavesComeBack(const CutLeaves& leaves) {
  const auto bytes = toBytes(leaves);
  const auto back = cutLeavesFrom(bytes);
  expectSameLeaves(back, leaves);
  EXPECT_EQ(toBytes(back), bytes);
}

TEST(CutLeavesFileTest, RowsComeBackToTheBit) {
  const auto mesh = leafMesh();
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    for (const bool polygons : {false, true}) {
      const auto leaves = leafCutter(side).cut(mesh, {.polygons = polygons, .moments = 2});
      ASSERT_GT(leaves.arcs.area.size(), 10U);
      ASSERT_EQ(leaves.patchNames.size(), 3U);
      expectLeavesComeBack(leaves);
      expectLeavesComeBack(merged(leaves, mesh).leaves);
    }
  }
  expectLeavesComeBack(cutFew(true));
}

TEST(CutLeavesFileTest, SoDoLeavesOfRandomVoxelsAndPartsOfAMesh) {
  std::mt19937 random(3);
  for (int n = 0; n < scaled(12); ++n) {
    const CellCutter cutter{Solid<double>(meshOf(randomVoxels(random)))};
    const auto mesh = dividedMesh(random, 4, n % 2 == 0 ? 0 : -0.0113, 1, 80);
    const auto leaves = cutter.cut(mesh);
    expectLeavesComeBack(leaves);
    expectLeavesComeBack(merged(leaves, mesh, {.smallest = 0.3}).leaves);
    auto cells = std::vector(mesh.cells().begin(), mesh.cells().end());
    std::erase_if(cells, [&](const OctreeCell&) { return random() % 2 == 0; });
    expectLeavesComeBack(cutter.cut(Mesh(mesh.domain(), mesh.deepest(), cells)));
  }
}

TEST(CutLeavesFileTest, SoDoThoseWithoutASurfaceAndNone) {
  const OctreeDomain<double> domain({7, 7, 7}, 1, {2, 1, 1});
  const auto far = leafCutter().cut(Mesh(domain, 0, {{.index = {0, 0, 0}}, {.index = {1, 0, 0}}}));
  ASSERT_TRUE(far.cut.leaf.empty());
  ASSERT_EQ(far.wholeFluid, 2);
  expectLeavesComeBack(far);
  expectLeavesComeBack(leafCutter().cut(Mesh(domain, 0, {})));
}

TEST(CutLeavesFileTest, AFileHoldsTheBytes) {
  const TemporaryFolder folder;
  const auto leaves = leafCutter().cut(leafMesh(), {.polygons = true});
  saveCutLeaves(folder / "two.leaves", leaves);
  EXPECT_EQ(folder.fileCount(), 1U);
  const auto content = contentOf(folder / "two.leaves");
  EXPECT_TRUE(std::ranges::equal(std::as_bytes(std::span(content)), toBytes(leaves)));
  expectSameLeaves(loadCutLeaves(folder / "two.leaves"), leaves);
}

TEST(CutLeavesFileTest, HasTheBytesOfItsVersion) {
  // If the layout has changed, raise the version in the file's head, and write down the new value.
  const auto bytes = toBytes(cutFew(true));
  EXPECT_EQ(std::to_integer<int>(bytes[8]), 3);
  EXPECT_EQ(xxHash64(bytes), 9849627228787208516U);
}

TEST(CutLeavesFileTest, EveryBitCounts) {
  const auto bytes = toBytes(cutFew(true));
  ASSERT_LT(bytes.size(), 8000U);
  expectEveryBitCounts(bytes, cutLeavesFrom);
}

TEST(CutLeavesFileTest, RefusesBytesThatAreCutOffOrFollowedByOthers) {
  expectNeedsItsLength(toBytes(cutFew(false)), cutLeavesFrom);
}

TEST(CutLeavesFileTest, LeavesWithAForgedChecksumAreRefusedOrSafeToUse) {
  const auto mesh = leafMesh();
  const auto intact = toBytes(leafCutter().cut(mesh, {.polygons = true, .moments = 0}));
  expectForgeriesAreSafe(intact, scaled(400), cutLeavesFrom, [&](const CutLeaves& leaves) {
    static_cast<void>(check(leaves));
    if (leaves.classes.size() != mesh.cells().size()) return;
    static_cast<void>(CutRegions(leaves, mesh));
    static_cast<void>(merged(leaves, mesh, {.smallest = 0.5}));
    if (!leaves.firstWallPolygon.empty()) static_cast<void>(cutCellMesh(leaves, mesh, true));
  });
}

/// What toBytes() says of leaves once something in them is changed.
std::string leafFlawWith(const std::function<void(CutLeaves&)>& change) {
  return flawAfter(leafCutter().cut(leafMesh(), {.polygons = true, .moments = 1}), change);
}

/// The first arc between leaves that are cut, both.
std::size_t arcWithin(const CutLeaves& leaves) {
  std::size_t arc = 0;
  const auto pieces = leaves.pieces.cell.size();
  while (leaves.arcs.below[arc] >= pieces || leaves.arcs.above[arc] >= pieces) ++arc;
  return arc;
}

TEST(CutLeavesFileTest, ClassesAndLeavesAgree) {
  const std::string classes = "its classes are not those of leaves";
  const std::string leaves = "its leaves are not those that are cut, in order";
  const auto flaw = leafFlawWith;
  const auto first = [](CutLeaves& l, FluidClass of) {
    return std::ranges::find(l.classes, of) - l.classes.begin();
  };
  EXPECT_EQ(flaw([](CutLeaves&) {}), "");
  EXPECT_EQ(flaw([](CutLeaves& l) { l.classes[0] = FluidClass::Unknown; }), classes);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.classes[0] = static_cast<FluidClass>(77); }), classes);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.wholeFluid = NAN; }), classes);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.wholeFluid = -1; }), classes);
  EXPECT_EQ(flaw([](CutLeaves& l) {  // of none
              for (auto& it : l.classes) it = it == FluidClass::Body ? FluidClass::Fluid : it;
              l.wholeBody = 1;
            }),
            classes);
  EXPECT_EQ(flaw([](CutLeaves& l) { l = {}; }), leaves);
  EXPECT_EQ(flaw([&](CutLeaves& l) { l.classes[first(l, FluidClass::Fluid)] = FluidClass::Cut; }),
            leaves);
  EXPECT_EQ(flaw([&](CutLeaves& l) { l.classes[first(l, FluidClass::Cut)] = FluidClass::Fluid; }),
            leaves);
  EXPECT_EQ(flaw([&](CutLeaves& l) {
              std::swap(l.classes[first(l, FluidClass::Fluid)],
                        l.classes[first(l, FluidClass::Cut)]);
            }),
            leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.classes.resize(l.cut.leaf.back()); }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { std::swap(l.cut.leaf[0], l.cut.leaf[1]); }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.cut.leaf.back() = 0xfffffffe; }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.cut.box.pop_back(); }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.cut.box[2].upper.y = INFINITY; }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.cut.box[2].upper.y = l.cut.box[2].lower.y; }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.cut.fluidCorners.pop_back(); }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.cut.meets.pop_back(); }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.cut.wallFaces.pop_back(); }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.cut.firstPiece.back() += 1; }), leaves);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.cut.firstPiece[1] = 1000; }), leaves);
}

TEST(CutLeavesFileTest, RowsSayNothingThatOthersDeny) {
  const std::string pieces = "its pieces do not belong to its leaves";
  const std::string arcs = "its arcs do not lie between its pieces";
  const auto flaw = leafFlawWith;
  EXPECT_EQ(flaw([](CutLeaves& l) { l.pieces.cell[1] = 0; }), pieces);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.pieces.volume.pop_back(); }), pieces);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.arcs.axis[3] = 3; }), arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.arcs.above.push_back(0); }), arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.arcs.faceArea[3] = NAN; }), arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.arcs.below[5] = CutLeaves::kNoRow; }), arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.arcs.leafAbove[5] = 0xfffffffe; }), arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.arcs.leafBelow[5] = l.arcs.leafAbove[5]; }), arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.arcs.below[arcWithin(l)] = CutLeaves::kBeyond; }), arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.arcs.below[arcWithin(l)] = CutLeaves::kWholeCell; }), arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.arcs.leafBelow[arcWithin(l)] = CutLeaves::kNoLeaf; }), arcs);
  // The leaves of an arc touch in a face across its axis, the one below from below.
  EXPECT_EQ(flaw([](CutLeaves& l) { ++l.arcs.axis[arcWithin(l)] %= 3; }), arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) {
              const auto a = arcWithin(l);
              std::swap(l.arcs.below[a], l.arcs.above[a]);
              std::swap(l.arcs.leafBelow[a], l.arcs.leafAbove[a]);
            }),
            arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) {  // in order
              const auto swap = [](auto& array) { std::swap(array.front(), array.back()); };
              swap(l.arcs.below), swap(l.arcs.above), swap(l.arcs.leafBelow);
              swap(l.arcs.leafAbove), swap(l.arcs.axis);
            }),
            arcs);
  EXPECT_EQ(flaw([](CutLeaves& l) { l.wallParts.patch[0] = 3; }),
            "its walls do not belong to its pieces");
  EXPECT_EQ(flaw([](CutLeaves& l) { l.moments.arc.pop_back(); }),
            "its moments do not belong to its pieces and arcs");
  EXPECT_EQ(flaw([](CutLeaves& l) { l.firstWallPolygon.back() -= 1; }),
            "its polygons do not belong to its arcs and walls");
}

TEST(CutLeavesFileTest, SaysWhatAFileIsThatIsNone) {
  const auto refusal = [](const std::string& content) {
    return fileRefusal(content, [](const auto& path) { return loadCutLeaves(path); });
  };
  const auto asText = [](const std::vector<std::byte>& bytes) {
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  auto bytes = toBytes(cutFew(false));
  EXPECT_EQ(refusal(""), "there is nothing in it");
  EXPECT_EQ(refusal("solid hull\n"), "this is no file of cut leaves");
  EXPECT_EQ(refusal(asText(toBytes(leafCutter().cut(GridPatch<double>{
                Level<double>({0, 0, 0}, {1, 1, 1}), IndexBox::ofSize(1, 1, 1)})))),
            "this is no file of cut leaves");
  EXPECT_EQ(refusal(asText(bytes).substr(0, 20)),
            "the file of cut leaves is damaged: it ends within its head");
  EXPECT_EQ(fileRefusal([&] { return cutCellsFrom(bytes); }), "this is no file of cut cells");
  put(bytes, 8, std::uint32_t{7});
  EXPECT_EQ(refusal(asText(bytes)),
            "the file of cut leaves has version 7, this library reads version 3: cut the leaves "
            "anew");
}

}  // namespace
}  // namespace cutwater::test
