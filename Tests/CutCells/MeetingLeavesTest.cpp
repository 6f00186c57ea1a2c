// Leaves of octrees around surfaces whose shells overlap.

#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Grid/Octree.hpp>

#include <random>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/JoinedCells.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "CutCells/SameRows.hpp"
#include "CutCells/ShellCells.hpp"
#include "CutCells/Tetrahedra.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// Cuts a mesh, and compares with its finest cells: pieces, what connects them, and the regions of
/// the fluid. Counts leaves in which triangles meet, and those of several pieces.
struct Found {
  std::size_t meeting = 0;
  std::size_t several = 0;
};
CutLeaves expectAsJoined(const CellCutter& cutter, const Mesh& mesh, Found& sum) {
  auto leaves = cutter.cut(mesh);
  expectIdentities(leaves, 1e-12);
  const auto fine = cutter.cut(finestOf(mesh));
  const auto report = check(leaves);
  EXPECT_NEAR(report.bodyVolume, check(fine).bodyVolume, 1e-13);
  EXPECT_NEAR(report.wallArea, check(fine).wallArea, 1e-12);
  JoinedCells joined(fine, mesh);
  joined.expectSame(leaves);
  sum.meeting += report.meetingCells;
  sum.several += joined.splitLeaves();
  const CutRegions ofLeaves(leaves, mesh);
  const CutRegions ofCells(fine);
  EXPECT_EQ(ofLeaves.regions().size(), ofCells.regions().size());
  for (std::size_t n = 0; n < ofLeaves.regions().size() && n < ofCells.regions().size(); ++n) {
    EXPECT_NEAR(ofLeaves.regions()[n].volume, ofCells.regions()[n].volume, 1e-13);
  }
  return leaves;
}

/// Compares the volume of the fluid in each leaf with inclusion and exclusion.
void expectUnion(const std::vector<Box<double>>& boxes, const Mesh& mesh, Found& sum) {
  const auto leaves = expectAsJoined(CellCutter(solidOf(soupOf(boxes))), mesh, sum);
  for (std::uint32_t leaf = 0; leaf < mesh.cells().size(); ++leaf) {
    const auto box = mesh.box(mesh.cells()[leaf]);
    const auto row = leaves.rowOf(leaf);
    double fluid = leaves.classes[leaf] == FluidClass::Fluid ? covered(box, {box}) : 0;
    if (row != CutLeaves::kNoRow) {
      for (auto p = leaves.cut.firstPiece[row]; p < leaves.cut.firstPiece[row + 1]; ++p) {
        fluid += leaves.pieces.volume[p];
      }
    }
    ASSERT_NEAR(fluid, covered(box, {box}) - covered(box, boxes), 1e-14);
  }
}

TEST(MeetingLeavesTest, UnionsOfBoxesAreThoseOfTheFinestCells) {
  std::mt19937 random(31);
  Found sum;
  for (int n = 0; n < scaled(30) && !HasFailure(); ++n) {
    const auto boxes = randomBoxes(random, 2 + n % 3);
    expectUnion(boxes, randomMesh(random, 3 + n % 2, 0, 1, 75), sum);
  }
  EXPECT_GT(sum.meeting, 500U);
  EXPECT_GT(sum.several, 20U);
}

/// Faces lie on one another, and in planes of leaves of some levels.
TEST(MeetingLeavesTest, UnionsOfBoxesInPlanesOfLeaves) {
  std::mt19937 random(32);
  Found sum;
  for (int n = 0; n < scaled(60) && !HasFailure(); ++n) {
    const auto boxes = randomBoxesInPlanes(random, 2 + n % 3, 8);
    expectUnion(boxes, randomMesh(random, 3 + n % 2, 0, 1, 75), sum);
  }
  EXPECT_GT(sum.meeting, 500U);
}

/// Edges and triangles lie in planes and lines of leaves of some levels: behind the faces of finer
/// leaves, films without volume are all that a triangle has.
TEST(MeetingLeavesTest, TetrahedraInPlanesOfLeaves) {
  std::mt19937 random(35);
  const auto corner = [&] { return (1 + static_cast<double>(random() % 7)) / 8; };
  for (int n = 0; n < scaled(300) && !HasFailure();) {
    const auto soup = tetrahedraOf(1, [&] { return Vec3<double>{corner(), corner(), corner()}; });
    if (volumeOf(soup) == 0) continue;
    const auto mesh = randomMesh(random, 3 + n % 2, 0, 1, 75);
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      // Films may part an arc on one level and not on another.
      const CellCutter cutter(solidOf(soup), side);
      const auto leaves = cutter.cut(mesh);
      const auto fine = cutter.cut(finestOf(mesh));
      expectIdentities(leaves, 1e-12);
      EXPECT_NEAR(check(leaves).bodyVolume, check(fine).bodyVolume, 1e-13);
      EXPECT_NEAR(check(leaves).wallArea, check(fine).wallArea, 1e-12);
      EXPECT_EQ(CutRegions(leaves, mesh).regions().size(), CutRegions(fine).regions().size());
    }
    ++n;
  }
}

TEST(MeetingLeavesTest, BallsThatOverlap) {
  std::mt19937 random(33);
  Found sum;
  const auto both = joined({ball(0.3, {0.35, 0.4, 0.51}, 2), ball(0.27, {0.6, 0.62, 0.48}, 2)});
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(solidOf(both), side);
    for (int n = 0; n < scaled(4) && !HasFailure(); ++n) {
      expectAsJoined(cutter, randomMesh(random, 4, 0, 1, 80), sum);
    }
  }
  EXPECT_GT(sum.meeting, 100U);
}

/// Plates that cross part the leaves, and leave openings between them.
TEST(MeetingLeavesTest, PlatesThatCross) {
  const auto plates = joined({tessellation::box({-1, -1, 0.37}, {2, 2, 0.38}),
                              tessellation::box({0.61, -1, -1}, {0.62, 2, 2}),
                              tessellation::box({-1, 0.403, -1}, {0.7, 0.409, 2}),
                              tessellation::box({0.3, 0.6, 0.1}, {0.4, 0.7, 0.9})});
  std::mt19937 random(34);
  Found sum;
  for (int n = 0; n < scaled(6) && !HasFailure(); ++n) {
    expectAsJoined(CellCutter(solidOf(plates)), randomMesh(random, 4, 0, 1, 70), sum);
  }
  EXPECT_GT(sum.several, 100U);
}

TEST(MeetingLeavesTest, AnOctreeOfOneLevelIsTheGrid) {
  const auto both = joined({ball(0.3, {0.35, 0.4, 0.51}, 2), ball(0.27, {0.6, 0.62, 0.48}, 2)});
  const auto solid = solidOf(both);
  const CellCutter cutter(solid);
  const OctreeDomain<double> domain({0.01, -0.02, 0.03}, 0.32, {3, 4, 3});
  const Octree<double> mesh(solid, domain, {.cut = 3, .bands = {{10.0, 3}}});
  const auto leaves = cutter.cut(mesh);
  expectRowsOfGrid(leaves, mesh, cutter.cut(finestOf(mesh)));
  EXPECT_GT(check(leaves).meetingCells, 50U);
}

}  // namespace
}  // namespace cutwater::test
