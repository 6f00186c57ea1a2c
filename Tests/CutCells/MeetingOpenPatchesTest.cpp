// Open patches where triangles meet: polygons, and planes of the solid.
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Io/PointData.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/MomentCells.hpp"
#include "CutCells/OpenCells.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "CutCells/ShellCells.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

const Box<double> kDuct{{0.25, 0.3, 0.35}, {0.75, 0.61, 0.72}};

/// The ends of the first box are open, where they are not within others.
struct OpenUnion {
  std::vector<Box<double>> boxes;

  [[nodiscard]] Solid<double> solid() const {
    const auto bars = soupOf({boxes.begin() + 1, boxes.end()});
    const auto duct = tessellation::box(boxes[0].lower, boxes[0].upper);
    return Solid<double>(
        MeshSDF<double>(together(ductOf(duct).as<MeshSDF<double>>()->soup(), bars)));
  }
  /// What is open of an end of the duct.
  [[nodiscard]] double openArea(int end) const {
    auto rim = boxes[0];
    rim.lower.x = rim.upper.x = end == 1 ? rim.lower.x : rim.upper.x;
    std::vector<Box<double>> across;
    for (const auto& box : boxes) {
      if (box.lower.x < rim.lower.x && box.upper.x > rim.upper.x) across.push_back(box);
    }
    return covered(rim, {rim}, 0) - covered(rim, across, 0);
  }
};

/// Bars within the unit cube that may go through the ends of the duct, and its sides.
OpenUnion randomUnion(std::mt19937& random, int bars) {
  OpenUnion result{{kDuct}};
  for (const auto& box : randomBoxes(random, bars)) {
    const bool isFlush = random() % 4 == 0;
    result.boxes.push_back(box);
    auto& bar = result.boxes.back();
    if (isFlush) bar.upper.y = std::max(bar.lower.y + 0.01, kDuct.upper.y);
  }
  return result;
}

double openAreaOf(const CutCells& cells, std::uint32_t patch) {
  double area = 0;
  for (std::size_t n = 0; n < cells.openArcs.arc.size(); ++n) {
    if (cells.openArcs.patch[n] == patch) area += cells.arcs.area[cells.openArcs.arc[n]];
  }
  return area;
}

TEST(MeetingOpenPatchesTest, PiecesOfUnionsOfBoxesAreClosedEdgeByEdge) {
  std::mt19937 random(71);
  std::size_t meeting = 0;
  std::size_t withoutWall = 0;
  for (int round = 0; round < scaled(24) && !HasFailure(); ++round) {
    const auto all = randomUnion(random, 1 + round % 3);
    const CellCutter cutter(all.solid(), FluidSide::Inside, kEndsOpen);
    const auto grid = unitGrid(std::array{4, 8, 20}[static_cast<std::size_t>(round) % 3]);
    const auto cells = cutter.cut(grid, {.polygons = true, .moments = 2});
    expectIdentities(cells, 1e-13);
    expectPolygonsOf(cells);
    EXPECT_LT(check(cells).worstMoments, 1e-13);
    for (const int end : {1, 2}) {
      EXPECT_NEAR(openAreaOf(cells, static_cast<std::uint32_t>(end)), all.openArea(end), 1e-14);
    }
    const auto closed = CellCutter(all.solid(), FluidSide::Inside).cut(grid, {.polygons = true});
    EXPECT_EQ(cells.pieces.volume, closed.pieces.volume);
    EXPECT_EQ(toBytes(cutCellsFrom(toBytes(cells))), toBytes(cells));
    for (std::size_t p = 0; p < cells.pieceCount; ++p) {
      if (cells.cells.meets[cells.pieces.cell[p]] == 0) continue;
      ++meeting;
      withoutWall += cells.pieces.wallArea[p] == 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(meeting, 100U);
  EXPECT_GT(withoutWall, 10U);
}

TEST(MeetingOpenPatchesTest, LeavesAreClosedEdgeByEdge) {
  std::mt19937 random(73);
  std::size_t open = 0;
  for (int round = 0; round < scaled(12) && !HasFailure(); ++round) {
    auto all = randomUnion(random, 1 + round % 2);
    all.boxes[0].lower.x = 0;  // in a plane of every leaf there
    all.boxes[0].upper.x = 1;
    for (auto& box : all.boxes) {
      box.lower = box.lower - Vec3<double>{0.1, 0, 0};
      box.upper = box.upper + Vec3<double>{0.1, 0, 0};
    }
    all.boxes[0].lower.x = 0;
    all.boxes[0].upper.x = 1;
    const CellCutter cutter(all.solid(), FluidSide::Inside, kEndsOpen);
    const auto mesh = dividedMesh(random, 4, 0, 1);
    const auto leaves = cutter.cut(mesh, {.polygons = true, .moments = 1});
    expectIdentities(leaves, 1e-13);
    expectPolygonsOf(leaves, 10);
    std::array<double, 3> areas{};
    for (std::size_t n = 0; n < leaves.openArcs.arc.size(); ++n) {
      areas[leaves.openArcs.patch[n]] += leaves.arcs.area[leaves.openArcs.arc[n]];
    }
    EXPECT_NEAR(areas[1], all.openArea(1), 1e-14);
    EXPECT_NEAR(areas[2], all.openArea(2), 1e-14);
    open += leaves.openArcs.arc.size();
  }
  EXPECT_GT(open, 100U);
}

/// What cells have of open patches, by their rows.
OpenSums sumsOfCells(const CutCells& cells) {
  OpenSums result;
  for (const auto& [key, sum] : openSums(cells)) {
    auto& ofCell = result[{cells.pieces.cell[key.first], key.second}];
    ofCell.area += sum.area;
    ofCell.vector += sum.vector;
    ofCell.moment += sum.moment;
  }
  return result;
}

/// Compares with a layer of cells: the boxes are the same at all heights.
TEST(MeetingOpenPatchesTest, InAPlaneTheyAreThoseOfALayer) {
  std::mt19937 random(72);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(60) && !HasFailure(); ++round) {
    auto all = randomUnion(random, 1 + round % 3);
    all.boxes = asPrisms(all.boxes, -1, 2);
    const CellCutter cutter(all.solid(), FluidSide::Inside, kEndsOpen);
    std::vector<double> planes;
    const int n = std::array{4, 8, 20}[static_cast<std::size_t>(round) % 3];
    for (int i = 0; i <= n; ++i) planes.push_back(i / static_cast<double>(n));
    const auto flat = cutter.cutInPlane(cellsBetween({planes, planes, {0, 1}}), 0.5);
    expectIdentities(flat, 1e-13);
    EXPECT_EQ(toBytes(cutCellsFrom(toBytes(flat))), toBytes(flat));
    meeting += check(flat).meetingCells;
    const auto layer = cutter.cut(cellsBetween({planes, planes, {0.25, 0.75}}));
    ASSERT_EQ(flat.cellCount, layer.cellCount);  // after these, the layer has some beyond it
    ASSERT_TRUE(std::ranges::equal(flat.cells.firstPiece,
                                   std::span(layer.cells.firstPiece).first(flat.cellCount + 1)));
    EXPECT_NEAR(check(flat).wallArea, 2 * check(layer).wallArea, 1e-12);
    const auto found = sumsOfCells(flat);
    auto expected = sumsOfCells(layer);
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [key, sum] : found) {
      const auto& other = expected[key];
      EXPECT_NEAR(sum.area, 2 * other.area, 1e-14);
      EXPECT_LT(length(sum.vector - 2 * other.vector), 1e-14);
      EXPECT_LT(length(sum.moment - 2 * other.moment), 1e-14);
    }
    for (const int end : {1, 2}) {
      EXPECT_NEAR(openAreaOf(flat, static_cast<std::uint32_t>(end)), all.openArea(end) / 3, 1e-14);
    }
    const CutRegions ofFlat(flat);
    const CutRegions ofLayer(layer);
    ASSERT_EQ(ofFlat.regions().size(), ofLayer.regions().size());
  }
  EXPECT_GT(meeting, 100U);
}

/// Where a wall and an opening share a side of a rectangle, each has its part.
TEST(MeetingOpenPatchesTest, ASideMayBeOpenInPart) {
  const auto duct =
      withPatches(tessellation::box(kDuct.lower, kDuct.upper, 3), {"wall", "outlet"},
                  [](const FlatTriangle& t) {
                    return t.middle.x == 0.75 && t.middle.y < 0.3 + 0.31 / 3 ? 1U : 0U;
                  });
  const auto bar = tessellation::box({0.4, 0.5, 0.2}, {0.6, 0.8, 0.9});
  const Solid<double> solid{MeshSDF<double>(together(duct, bar))};
  const CellCutter cutter(solid, FluidSide::Inside, {.openPatches = {"outlet"}});
  const std::vector<double> planes{0, 0.25, 0.75, 1};
  const auto cells = cutter.cutInPlane(cellsBetween({planes, {0.1, 0.9}, {0, 1}}), 0.5);
  expectIdentities(cells, 1e-14);
  EXPECT_EQ(check(cells).meetingCells, 1U);
  ASSERT_EQ(cells.openArcs.arc.size(), 1U);
  const auto arc = cells.openArcs.arc[0];
  EXPECT_NEAR(cells.arcs.area[arc], 0.31 / 3, 1e-15);
  EXPECT_NEAR(cells.arcs.centroid[arc].y, 0.3 + 0.31 / 6, 1e-15);
  EXPECT_NEAR(check(cells).wallArea, 2 * 0.5 + 0.31 + 0.31 * 2 / 3 + 2 * 0.19, 1e-14);
  EXPECT_NEAR(check(cells).fluidVolume, 0.5 * 0.31 + 0.2 * 0.19, 1e-15);
}

}  // namespace
}  // namespace cutwater::test
