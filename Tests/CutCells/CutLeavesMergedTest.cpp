// merged() of cut leaves.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Grid/Detail/MortonCode.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "Support/CutIdentities.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// The piece that a merged leaf has kept: the first with its volume, of those that there were.
std::uint32_t keptOf(const CutLeaves& before, const CutLeaves& after, std::uint32_t leaf) {
  const double volume = after.pieces.volume[after.cut.firstPiece[after.rowOf(leaf)]];
  auto piece = before.cut.firstPiece[before.rowOf(leaf)];
  while (before.pieces.volume[piece] != volume) ++piece;
  return piece;
}

/// Each connected part of the fluid lies in one that was connected before.
void expectNothingLeaks(const CutLeaves& before, const CutLeaves& after, const Mesh& mesh) {
  const CutRegions wasIn(before, mesh);
  const CutRegions isIn(after, mesh);
  std::map<std::uint32_t, std::uint32_t> cameFrom;
  for (std::uint32_t leaf = 0; leaf < after.classes.size(); ++leaf) {
    if (after.classes[leaf] == FluidClass::Body) continue;
    const auto row = after.rowOf(leaf);
    const auto here =
        row == CutLeaves::kNoRow ? isIn.ofLeaf(leaf) : isIn.ofPiece(after.cut.firstPiece[row]);
    const auto there = before.rowOf(leaf) == CutLeaves::kNoRow
                           ? wasIn.ofLeaf(leaf)
                           : wasIn.ofPiece(keptOf(before, after, leaf));
    ASSERT_NE(here, CutRegions::kNone);
    ASSERT_NE(there, CutRegions::kNone);
    ASSERT_EQ(cameFrom.emplace(here, there).first->second, there);
  }
}

/// That merged leaves hold one piece each, lose what they say, and connect nothing anew.
MergedLeaves expectMerged(const CutLeaves& leaves, const Mesh& mesh,
                          const MergeOptions& options = {}) {
  auto result = merged(leaves, mesh, options);
  const auto& after = result.leaves;
  expectIdentities(after, 1e-13);
  const auto report = check(after);
  EXPECT_EQ(report.multiPieceCells, 0U);
  EXPECT_LT(report.worstMoments, 1e-13);
  const double lost =
      std::accumulate(result.lost.begin(), result.lost.end(), 0.0,
                      [](double sum, const auto& piece) { return sum + piece.volume; });
  EXPECT_NEAR(report.fluidVolume + lost, check(leaves).fluidVolume, 1e-13);
  EXPECT_NEAR(report.bodyVolume - lost, check(leaves).bodyVolume, 1e-13);
  EXPECT_TRUE(std::ranges::is_sorted(result.lost, {}, &LostLeafPiece::leaf));
  for (std::uint32_t p = 0; p < after.pieces.volume.size(); ++p) {
    EXPECT_GT(length(after.pieces.wallVector[p]), 0);
    EXPECT_GE(after.volumeFraction(p), options.smallest);
    EXPECT_EQ(after.classes[after.cut.leaf[p]], FluidClass::Cut);
  }
  EXPECT_EQ(std::ranges::count(after.classes, FluidClass::Cut), std::ssize(after.cut.leaf));
  static_cast<void>(toBytes(after));  // rows fit each other
  expectNothingLeaks(leaves, after, mesh);
  return result;
}

TEST(CutLeavesMergedTest, ShellsInLeavesOfAnyLevel) {
  std::mt19937 random(5);
  std::size_t several = 0;
  std::size_t covered = 0;
  for (int n = 0; n < scaled(24) && !HasFailure(); ++n) {
    const auto side = n % 2 == 0 ? FluidSide::Outside : FluidSide::Inside;
    const CellCutter cutter(Solid<double>(meshOf(randomVoxels(random))), side);
    // Voxels on planes of the finest cells, or between them.
    const double lower = n % 4 < 2 ? 0 : -0.0113;
    const auto mesh = dividedMesh(random, 4, lower, n % 8 < 4 ? 0.75 : 1, 80);
    const auto leaves = cutter.cut(mesh, {.moments = n % 3 == 0 ? 2 : -1});
    const auto once = expectMerged(leaves, mesh, {.smallest = n % 3 == 1 ? 0.1 : 0});
    several += check(leaves).multiPieceCells;
    covered += once.lost.size();
  }
  EXPECT_GT(several, 100U);
  EXPECT_GT(covered, 100U);
}

TEST(CutLeavesMergedTest, OnceIsEnough) {
  std::mt19937 random(6);
  const CellCutter cutter{Solid<double>(meshOf(randomVoxels(random)))};
  const auto mesh = dividedMesh(random, 4, -0.0113, 1, 80);
  const auto once = merged(cutter.cut(mesh, {.moments = 1}), mesh, {.smallest = 0.05});
  ASSERT_GT(once.lost.size(), 0U);
  auto twice = merged(once.leaves, mesh, {.smallest = 0.05});
  EXPECT_TRUE(twice.lost.empty());
  ASSERT_EQ(twice.leaves.patchNames.back(), "covered");
  twice.leaves.patchNames.pop_back();  // of which there is nothing
  EXPECT_EQ(toBytes(twice.leaves), toBytes(once.leaves));
}

/// A plate through leaves of several levels: its sides stay apart.
TEST(CutLeavesMergedTest, APlateStaysTightAcrossLevels) {
  const auto plate = tessellation::box({-1, -1, 0.43}, {2, 2, 0.43 + 1e-6});
  const CellCutter cutter{Solid<double>(MeshSDF<double>(plate))};
  std::mt19937 random(7);
  std::size_t wholeCut = 0;
  for (int n = 0; n < scaled(4) && !HasFailure(); ++n) {
    const auto mesh = dividedMesh(random, 5, 0, 1, 60);
    const auto leaves = cutter.cut(mesh, {.moments = 1});
    const auto result = expectMerged(leaves, mesh);
    EXPECT_EQ(CutRegions(result.leaves, mesh).regions().size(), 2U);
    EXPECT_EQ(result.leaves.patchNames, (std::vector<std::string>{"box", "covered"}));
    // As much as the plate's own side that was lost, in each leaf by its own way around.
    double covered = 0;
    for (std::size_t w = 0; w < result.leaves.wallParts.area.size(); ++w) {
      if (result.leaves.wallParts.patch[w] == 1)
        covered += std::abs(result.leaves.wallParts.vector[w].z);
    }
    EXPECT_GE(covered, 1 - 1e-14);
    for (const auto leaf : result.leaves.cut.leaf) {
      if (leaves.classes[leaf] == FluidClass::Fluid) ++wholeCut;
    }
  }
  EXPECT_GT(wholeCut, 100U);
}

/// Of an octree of one level, every row of the grid's merged cells, to the bit.
void expectAsGrid(const CellCutter& cutter, const Mesh& mesh, const MergeOptions& options) {
  const auto cells = merged(cutter.cut(finestOf(mesh), {.moments = 2}), options);
  const auto leaves = merged(cutter.cut(mesh, {.moments = 2}), mesh, options);
  const auto& c = cells.cells;
  const auto& l = leaves.leaves;
  ASSERT_GT(cells.lost.size(), 0U);
  ASSERT_EQ(l.cut.leaf.size(), c.cellCount);
  ASSERT_EQ(leaves.lost.size(), cells.lost.size());
  const auto indexOf = [&](std::uint32_t leaf) { return mesh.cells()[leaf].index; };
  std::map<std::uint32_t, std::uint32_t> partners{{CutLeaves::kWholeCell, CutCells::kWholeCell},
                                                  {CutLeaves::kBeyond, CutCells::kBeyond}};
  const auto same = [](const auto& a, const auto& b) { return std::ranges::equal(a, b); };
  for (std::uint32_t row = 0; row < l.cut.leaf.size(); ++row) {
    const auto other = c.rowOf(indexOf(l.cut.leaf[row]));
    ASSERT_NE(other, CutCells::kNoRow);
    partners[row] = other;
    EXPECT_EQ(l.cut.fluidCorners[row], c.cells.fluidCorners[other]);
    EXPECT_EQ(l.cut.meets[row], c.cells.meets[other]);
    EXPECT_EQ(l.pieces.volume[row], c.pieces.volume[other]);
    EXPECT_EQ(l.pieces.centroid[row], c.pieces.centroid[other]);
    EXPECT_EQ(l.pieces.wallArea[row], c.pieces.wallArea[other]);
    EXPECT_EQ(l.pieces.wallVector[row], c.pieces.wallVector[other]);
    EXPECT_EQ(l.pieces.wallCentroid[row], c.pieces.wallCentroid[other]);
    EXPECT_TRUE(same(l.moments.ofVolume(row), c.moments.ofVolume(other)));
    EXPECT_TRUE(same(l.moments.ofWall(row), c.moments.ofWall(other)));
    EXPECT_TRUE(same(l.moments.ofWallVector(row), c.moments.ofWallVector(other)));
  }
  for (std::uint32_t leaf = 0; leaf < l.classes.size(); ++leaf) {
    EXPECT_EQ(l.classes[leaf], c.classOf(indexOf(leaf)));
  }
  using Arc = std::tuple<int, std::uint32_t, std::uint32_t, double, double, double, double, double>;
  std::vector<Arc> expected;
  std::vector<Arc> found;
  for (std::size_t a = 0; a < c.arcs.area.size(); ++a) {
    const auto& at = c.arcs.centroid[a];
    expected.emplace_back(c.arcs.axis[a], c.arcs.below[a], c.arcs.above[a], c.arcs.area[a], at.x,
                          at.y, at.z, c.moments.ofArc(a).back());
  }
  for (std::size_t a = 0; a < l.arcs.area.size(); ++a) {
    const auto& at = l.arcs.centroid[a];
    found.emplace_back(l.arcs.axis[a], partners.at(l.arcs.below[a]), partners.at(l.arcs.above[a]),
                       l.arcs.area[a], at.x, at.y, at.z, l.moments.ofArc(a).back());
  }
  std::ranges::sort(expected);
  std::ranges::sort(found);
  EXPECT_EQ(found, expected);
}

TEST(CutLeavesMergedTest, AnOctreeOfOneLevelIsTheGrid) {
  std::mt19937 random(9);
  for (int n = 0; n < scaled(6) && !HasFailure(); ++n) {
    const CellCutter cutter{Solid<double>(meshOf(randomVoxels(random)))};
    // Planes of cells in those of voxels, or between them.
    const double lower = n % 2 == 0 ? 0 : -0.0113;
    const OctreeDomain<double> domain({lower, lower, lower}, n % 2 == 0 ? 0.5 : 0.428, {2, 2, 2});
    std::vector<OctreeCell> leaves;
    for (std::uint64_t code = 0; code < 512; ++code) {
      leaves.push_back({.index = detail::indexOf(code), .level = 2});
    }
    expectAsGrid(cutter, Mesh(domain, 2, leaves), {.smallest = n % 3 == 0 ? 0 : 0.5});
  }
}

TEST(CutLeavesMergedTest, NeedsAShareAndItsMesh) {
  std::mt19937 random(9);
  const auto mesh = dividedMesh(random, 3, 0, 1);
  const auto other = dividedMesh(random, 3, 0, 1);
  ASSERT_NE(mesh.cells().size(), other.cells().size());
  const auto leaves = CellCutter(turnedTorus()).cut(mesh);
  EXPECT_THROW(static_cast<void>(merged(leaves, mesh, {.smallest = -0.1})), Error);
  EXPECT_THROW(static_cast<void>(merged(leaves, mesh, {.smallest = 1.1})), Error);
  EXPECT_THROW(static_cast<void>(merged(leaves, other)), Error);
}

}  // namespace
}  // namespace cutwater::test
