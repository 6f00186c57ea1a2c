#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "CutCells/JoinedCells.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "CutCells/SameRows.hpp"
#include "Support/CutIdentities.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// Cuts a mesh, and compares with its finest cells; returns how many leaves have several pieces.
std::size_t expectAsJoined(const CellCutter& cutter, const Mesh& mesh) {
  const auto leaves = cutter.cut(mesh);
  expectIdentities(leaves, 1e-13);
  const auto fine = cutter.cut(finestOf(mesh));
  EXPECT_NEAR(check(leaves).bodyVolume, check(fine).bodyVolume, 1e-13);
  EXPECT_NEAR(check(leaves).fluidVolume, check(fine).fluidVolume, 1e-13);
  EXPECT_NEAR(check(leaves).wallArea, check(fine).wallArea, 1e-12);
  JoinedCells joined(fine, mesh);
  joined.expectSame(leaves);
  return joined.splitLeaves();
}

TEST(CutLeavesTest, LeavesOfAnyLevelAreAsTheirFinestCellsJoined) {
  std::mt19937 random(1);
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(turnedTorus(), side);
    for (int n = 0; n < scaled(6) && !HasFailure(); ++n) {
      expectAsJoined(cutter, randomMesh(random, 4 + n % 2, 0, 1));
    }
  }
}

TEST(CutLeavesTest, AnOctreeOfOneLevelIsTheGrid) {
  const CellCutter cutter(turnedTorus());
  const OctreeDomain<double> domain({0.01, -0.02, 0.03}, 0.32, {3, 4, 3});
  const Octree<double> mesh(turnedTorus(), domain, {.cut = 3, .bands = {{10.0, 3}}});
  expectRowsOfGrid(cutter.cut(mesh), mesh, cutter.cut(finestOf(mesh)));
}

TEST(CutLeavesTest, VoxelSolidsInLeavesOfAnyLevel) {
  std::mt19937 random(3);
  std::size_t several = 0;
  for (int n = 0; n < scaled(12) && !HasFailure(); ++n) {
    const CellCutter cutter{Solid<double>(meshOf(randomVoxels(random)))};
    // Voxels on planes of the finest cells, or between them.
    const double lower = n % 2 == 0 ? 0 : -0.0113;
    const double width = n % 4 < 2 ? 0.75 : 1;
    several += expectAsJoined(cutter, randomMesh(random, 4, lower, width, 80));
  }
  EXPECT_GT(several, 50U);
}

/// Thin plates, rods and balls that pierce faces of leaves without touching an edge.
TEST(CutLeavesTest, ThinPlatesRodsAndBubbles) {
  auto soup = tessellation::box({-1, -1, 0.37}, {2, 2, 0.37 + 1e-9});
  soup = together(soup, tessellation::box({0.63, -1, 0.7}, {0.66, 2, 0.73}));
  const auto add = [&](const Vec3<double>& at, double radius) {
    auto ball = tessellation::icosphere(radius, 1);
    for (auto& p : ball.points) p += at;
    soup = together(soup, ball);
  };
  add({0.26, 0.31, 0.5}, 0.1);
  add({0.26, 0.76, 0.503}, 0.03);
  add({0.5, 0.5, 0.2}, 0.15);
  std::mt19937 random(5);
  std::size_t several = 0;
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(Solid<double>(MeshSDF<double>(soup)), side);
    for (int n = 0; n < scaled(4) && !HasFailure(); ++n) {
      several += expectAsJoined(cutter, randomMesh(random, 4, 0, 1, 70));
    }
  }
  EXPECT_GT(several, 100U);
}

/// Leaves that get finer towards a corner of the body, each as wide as all finer ones across.
TEST(CutLeavesTest, LeavesBesideMuchFinerOnes) {
  const Vec3<double> corner{0.3, 0.4, 0.45};
  const auto soup = tessellation::box(corner, {0.8, 0.9, 0.95});
  const CellCutter cutter{Solid<double>(MeshSDF<double>(soup))};
  constexpr int kDeepest = 12;
  std::vector<OctreeCell> leaves;
  const OctreeDomain<double> domain({0, 0, 0}, 1, {1, 1, 1});
  const auto divide = [&](const auto& self, const Index3& index, int level) -> void {
    const auto box = domain.level(level).cell(index);
    const bool isThere = maxComponent(max(box.lower - corner, corner - box.upper)) < 0;
    if (!isThere || level == kDeepest) {
      leaves.push_back({.index = index, .level = static_cast<std::uint8_t>(level)});
      return;
    }
    for (int child = 0; child < 8; ++child) {
      self(self,
           {2 * index.i + (child & 1), 2 * index.j + (child >> 1 & 1), 2 * index.k + (child >> 2)},
           level + 1);
    }
  };
  divide(divide, {}, 0);
  const auto cut = cutter.cut(Mesh(domain, kDeepest, leaves));
  expectIdentities(cut, 1e-13);
  EXPECT_NEAR(check(cut).bodyVolume, 0.125, 1e-15);
  EXPECT_NEAR(check(cut).wallArea, 1.5, 1e-14);
  std::size_t jumps = 0;
  for (std::size_t a = 0; a < cut.arcs.area.size(); ++a) {
    if (cut.arcs.leafAbove[a] == CutLeaves::kNoLeaf || cut.arcs.leafBelow[a] == CutLeaves::kNoLeaf)
      continue;
    if (std::abs(leaves[cut.arcs.leafAbove[a]].level - leaves[cut.arcs.leafBelow[a]].level) > 1)
      ++jumps;
  }
  EXPECT_GT(jumps, 0U);
}

TEST(CutLeavesTest, ClassesAreThoseOfTheSolid) {
  const auto solid = turnedTorus();
  const OctreeDomain<float> domain({-0.01F, -0.02F, 0.03F}, 0.3F, {4, 4, 3});
  const Octree<float> mesh(Solid<float>(MeshSDF<float>(tessellation::icosphere(0.6, 2))), domain,
                           {.cut = 5}, {.balance = Balance::None});
  const auto leaves = CellCutter(solid).cut(mesh);
  expectIdentities(leaves, 1e-13);
  std::map<FluidClass, int> count;
  for (std::size_t leaf = 0; leaf < mesh.cells().size(); ++leaf) {
    const auto box = mesh.box(mesh.cells()[leaf]);
    const auto expected = solid.classify({Vec3<double>(box.lower), Vec3<double>(box.upper)});
    ++count[leaves.classes[leaf]];
    EXPECT_EQ(leaves.classes[leaf] == FluidClass::Cut, expected == BoxClass::Cut);
    EXPECT_EQ(leaves.classes[leaf] == FluidClass::Body, expected == BoxClass::Inside);
    EXPECT_EQ(leaves.rowOf(static_cast<std::uint32_t>(leaf)) == CutLeaves::kNoRow,
              expected != BoxClass::Cut);
  }
  EXPECT_GT(count[FluidClass::Body], 10);
  EXPECT_GT(count[FluidClass::Cut], 100);
}

/// Everything that is said of some leaves, by the numbers that `nameOf` gives them.
using Known = std::map<std::tuple<std::uint32_t, std::uint32_t, int>, std::vector<Vec3<double>>>;
template <typename NameOf>
Known knownOf(const CutLeaves& leaves, const std::set<std::uint32_t>& which, NameOf&& nameOf) {
  Known known;
  const auto& pieces = leaves.pieces;
  for (std::size_t p = 0; p < pieces.volume.size(); ++p) {
    const auto leaf = nameOf(leaves.cut.leaf[pieces.cell[p]]);
    if (!which.contains(leaf)) continue;
    auto& list = known[{leaf, leaf, 0}];
    list.insert(list.end(), {{pieces.volume[p], pieces.wallArea[p], 0},
                             pieces.centroid[p],
                             pieces.wallCentroid[p],
                             pieces.wallVector[p]});
  }
  const auto numberOf = [&](std::uint32_t piece) {
    const bool isPiece = piece < pieces.volume.size();
    return static_cast<double>(piece - (isPiece ? leaves.cut.firstPiece[pieces.cell[piece]] : 0));
  };
  for (std::size_t a = 0; a < leaves.arcs.area.size(); ++a) {
    const auto below = nameOf(leaves.arcs.leafBelow[a]);
    const auto above = nameOf(leaves.arcs.leafAbove[a]);
    if (!which.contains(below) && !which.contains(above)) continue;
    auto& list = known[{below, above, 1 + leaves.arcs.axis[a]}];
    list.insert(list.end(), {{leaves.arcs.area[a], numberOf(leaves.arcs.below[a]),
                              numberOf(leaves.arcs.above[a])},
                             leaves.arcs.centroid[a]});
  }
  return known;
}

/// With the leaves that touch one of them.
std::set<std::uint32_t> withNeighbours(const Mesh& mesh, const std::set<std::uint32_t>& leaves) {
  std::set<std::uint32_t> result;
  for (std::uint32_t other = 0; other < mesh.cells().size(); ++other) {
    const auto box = mesh.box(mesh.cells()[other]);
    if (std::ranges::any_of(leaves, [&](std::uint32_t leaf) {
          const auto own = mesh.box(mesh.cells()[leaf]);
          return maxComponent(max(box.lower - own.upper, own.lower - box.upper)) <= 0;
        })) {
      result.insert(other);
    }
  }
  return result;
}

TEST(CutLeavesTest, AreTheSameOnAnyNumberOfThreadsAndInEveryPart) {
  std::mt19937 random(8);
  std::size_t compared = 0;
  std::size_t left = 0;  // out of parts
  const CellCutter cutter(turnedTorus());
  for (int n = 0; n < scaled(4); ++n) {
    const auto mesh = randomMesh(random, 4, 0, 1, 80);
    const auto whole = cutter.cut(mesh, {.threads = 1});
    std::set<std::uint32_t> own;
    const auto count = static_cast<std::uint32_t>(mesh.cells().size());
    for (auto leaf = count / 3; leaf < count / 2; ++leaf) own.insert(leaf);
    const auto expected = knownOf(whole, own, std::identity{});
    EXPECT_EQ(knownOf(cutter.cut(mesh, {.threads = 4}), own, std::identity{}), expected);
    compared += expected.size();
    // As on one of several ranks: those that are finer across a neighbour's face are there, too.
    std::vector<std::uint32_t> names;
    std::vector<OctreeCell> cells;
    for (const auto leaf : withNeighbours(mesh, withNeighbours(mesh, own))) {
      names.push_back(leaf);
      cells.push_back(mesh.cells()[leaf]);
    }
    left += mesh.cells().size() - cells.size();
    const auto part = cutter.cut(Mesh(mesh.domain(), mesh.deepest(), cells));
    EXPECT_EQ(knownOf(part, own,
                      [&](std::uint32_t leaf) {
                        return leaf == CutLeaves::kNoLeaf ? leaf : names[leaf];
                      }),
              expected);
  }
  EXPECT_GT(compared, 200U);
  EXPECT_GT(left, 200U);
}

TEST(CutLeavesTest, SaysWhatItCannotCut) {
  // Between 1e17 and the next number there is no plane.
  const OctreeDomain<double> domain({1e17, 0, 0}, 1, {2, 2, 2});
  const Mesh mesh(domain, 0, {{.index = {0, 0, 0}}});
  EXPECT_THROW(static_cast<void>(CellCutter(turnedTorus()).cut(mesh)), Error);
}

}  // namespace
}  // namespace cutwater::test
