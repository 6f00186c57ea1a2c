// Leaves of octrees that are cut by solids that are no meshes.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/JoinedCells.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "CutCells/SameRows.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

constexpr double kPiOfLeaves = std::numbers::pi;

Solid<double> leafTorus() {
  return Torus<double>({0.51, 0.49, 0.47}, {1, 2, 3}, 0.3, 0.1);
}

Solid<double> gyroid(double level) {
  return TpmsSolid<double>(TpmsField<double>(TpmsPattern::gyroid(), 1.5), TpmsPart::Wall, level);
}

void expectSound(const CutCellsReport& report) {
  EXPECT_LT(report.worstClosure, 1e-14);
  EXPECT_EQ(report.lostPieces, 0U);
  EXPECT_EQ(report.outOfRange, 0U);
}

TEST(SolidLeavesTest, AnOctreeOfOneLevelIsTheGrid) {
  const SolidCutter cutter(leafTorus());
  const OctreeDomain<double> domain({0.01, -0.02, 0.03}, 0.32, {3, 4, 3});
  const Octree<double> mesh(leafTorus(), domain, {.cut = 3, .bands = {{10.0, 3}}});
  const auto leaves = cutter.cut(mesh, {.moments = 2, .quadrature = true});
  const auto cells = cutter.cut(finestOf(mesh));
  expectRowsOfGrid(leaves, mesh, cells);
  ASSERT_EQ(leaves.cut.error.size(), leaves.cut.leaf.size());
  for (std::size_t row = 0; row < leaves.cut.leaf.size(); ++row) {
    const auto same = cells.rowOf(mesh.cells()[leaves.cut.leaf[row]].index);
    EXPECT_EQ(leaves.cut.error[row], cells.cells.error[same]);
  }
}

/// A slab and a box with walls between planes of the grid, and thin ones, which are exact. In
/// leaves of any level, pieces and arcs are those that cells of the finest level are joined to.
TEST(SolidLeavesTest, BoxesInLeavesOfAnyLevelAreThoseOfTheFinestCells) {
  std::mt19937 random(7);
  const Solid<double> blocks = Cuboid<double>({0.21, 0.33, 0.11}, {0.68, 0.77, 0.93}) |
                               Cuboid<double>({0.83, -1, 0.59}, {0.84, 2, 0.61});
  const auto withSlab = blocks | Cuboid<double>({-1, -1, 0.37}, {2, 2, 0.3701});
  std::size_t several = 0;
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const SolidCutter cutter(side == FluidSide::Outside ? withSlab : blocks, side, {.points = 1});
    for (int n = 0; n < scaled(1) && !HasFailure(); ++n) {
      const auto lower = (n % 2 == 0) == (side == FluidSide::Outside) ? -0.0113 : 0;
      const auto mesh = dividedMesh(random, 4, lower, 1, 70);
      const auto cells = cutter.cut(finestOf(mesh));
      const auto leaves = cutter.cut(mesh);
      expectSound(check(leaves));
      JoinedCells joined(cells, mesh, 2e-9);
      joined.expectSame(leaves);
      several += joined.splitLeaves();
    }
  }
  EXPECT_GT(several, 100U);
}

TEST(SolidLeavesTest, CurvedWallsInLeavesOfAnyLevelWithinTheirErrors) {
  std::mt19937 random(11);
  const double volume = 2 * kPiOfLeaves * kPiOfLeaves * 0.3 * 0.1 * 0.1;
  const SolidCutter cutter(leafTorus());
  for (int n = 0; n < scaled(3) && !HasFailure(); ++n) {
    const auto mesh = dividedMesh(random, 4, 0, 1, 90);
    const auto leaves = cutter.cut(mesh);
    const auto report = check(leaves);
    expectSound(report);
    double error = 0;
    for (std::size_t row = 0; row < leaves.cut.leaf.size(); ++row) {
      error += leaves.cut.error[row] * leaves.leafVolume(static_cast<std::uint32_t>(row));
    }
    EXPECT_LT(std::abs(report.bodyVolume - volume), error);
    EXPECT_LT(std::abs(report.bodyVolume / volume - 1), 1e-2);
  }
}

/// Walls of a gyroid keep two channels apart in leaves of any level.
TEST(SolidLeavesTest, BothSidesOfLeavesFillThemAndAgreeOnArcs) {
  std::mt19937 random(13);
  const auto solid = gyroid(0.2);
  const auto mesh = dividedMesh(random, 3, 0, 1, 95);
  const auto outside = SolidCutter(solid, FluidSide::Outside).cut(mesh);
  const auto inside = SolidCutter(solid, FluidSide::Inside).cut(mesh);
  expectSound(check(outside));
  expectSound(check(inside));
  for (std::uint32_t row = 0; row < outside.cut.leaf.size(); ++row) {
    const auto same = inside.rowOf(outside.cut.leaf[row]);
    if (same == CutLeaves::kNoRow) continue;
    double sum = 0;
    for (auto p = outside.cut.firstPiece[row]; p < outside.cut.firstPiece[row + 1]; ++p) {
      sum += outside.pieces.volume[p];
    }
    for (auto p = inside.cut.firstPiece[same]; p < inside.cut.firstPiece[same + 1]; ++p) {
      sum += inside.pieces.volume[p];
    }
    const double whole = outside.leafVolume(row);
    const double error = outside.cut.error[row] + inside.cut.error[same];
    EXPECT_LT(std::abs(sum - whole), (error + 1e-13) * whole) << row;
  }
}

/// Integrals over volumes and walls by the points that are handed out, open parts of coarser leaves
/// included: the divergence theorem.
TEST(SolidLeavesTest, QuadratureAndMomentsOfLeaves) {
  std::mt19937 random(17);
  const auto mesh = dividedMesh(random, 4, 0, 1, 90);
  const auto leaves = SolidCutter(leafTorus(), FluidSide::Outside, {.points = 4})
                          .cut(mesh, {.moments = 1, .quadrature = true});
  const auto& [volume, wall, normals, arc] = leaves.quadrature;
  std::vector<double> left(leaves.pieces.cell.size());
  std::vector<double> size(left.size());
  const auto sumOf = [](std::span<const double> weights) {
    double sum = 0;
    for (const double weight : weights) sum += weight;
    return sum;
  };
  // The integral of x's derivative less that of x over the boundary, from the leaf's center.
  const auto centerOf = [&](std::size_t p) {
    return leaves.cut.box[leaves.pieces.cell[p]].center().x;
  };
  for (std::size_t p = 0; p < left.size(); ++p) {
    const auto row = leaves.pieces.cell[p];
    size[p] = leaves.leafVolume(row) * leaves.cut.error[row];
    left[p] = sumOf(volume.weightsOf(p));
    EXPECT_NEAR(left[p], leaves.pieces.volume[p], 1e-15);
    EXPECT_NEAR(leaves.moments.ofVolume(p)[0], leaves.pieces.volume[p], 1e-15);
    const auto points = wall.pointsOf(p);
    for (std::size_t i = 0; i < points.size(); ++i) {
      left[p] -= wall.weightsOf(p)[i] * normals[wall.first[p] + i].x * (points[i].x - centerOf(p));
    }
  }
  for (std::size_t a = 0; a < leaves.arcs.area.size(); ++a) {
    EXPECT_NEAR(sumOf(arc.weightsOf(a)), leaves.arcs.area[a], 1e-15);
    if (leaves.arcs.axis[a] != 0) continue;
    const auto points = arc.pointsOf(a);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const bool isBelow : {true, false}) {
        const auto p = (isBelow ? leaves.arcs.below : leaves.arcs.above)[a];
        if (p >= left.size()) continue;
        left[p] -= (isBelow ? 1 : -1) * arc.weightsOf(a)[i] * (points[i].x - centerOf(p));
      }
    }
  }
  for (std::size_t p = 0; p < left.size(); ++p) EXPECT_LT(std::abs(left[p]), 4 * size[p] + 1e-14);
}

TEST(SolidLeavesTest, FilesKeepErrorsAndQuadrature) {
  std::mt19937 random(19);
  const auto mesh = dividedMesh(random, 3, 0, 1, 90);
  const auto leaves = SolidCutter(leafTorus()).cut(mesh, {.quadrature = true});
  const auto bytes = toBytes(leaves);
  const auto read = cutLeavesFrom(bytes);
  EXPECT_EQ(read.cut.error, leaves.cut.error);
  EXPECT_EQ(read.quadrature.wallNormals, leaves.quadrature.wallNormals);
  EXPECT_EQ(toBytes(read), bytes);
  auto broken = leaves;
  broken.cut.error.pop_back();
  EXPECT_ANY_THROW(toBytes(broken));
  broken = leaves;
  broken.quadrature.arc.weights.pop_back();
  EXPECT_ANY_THROW(toBytes(broken));
}

TEST(SolidLeavesTest, MergedLeavesKeepTheirErrors) {
  std::mt19937 random(23);
  const auto mesh = dividedMesh(random, 3, 0, 1, 95);
  const auto leaves = SolidCutter(gyroid(0.2)).cut(mesh);
  const auto one = merged(leaves, mesh).leaves;
  EXPECT_EQ(one.cut.error.size(), one.cut.leaf.size());
  expectSound(check(one));
}

TEST(SolidLeavesTest, BitsDoNotDependOnThreads) {
  std::mt19937 random(29);
  const auto mesh = dividedMesh(random, 3, 0, 1, 95);
  const SolidCutter cutter(gyroid(0.2));
  EXPECT_EQ(toBytes(cutter.cut(mesh, {.threads = 1})), toBytes(cutter.cut(mesh, {.threads = 4})));
}

}  // namespace
}  // namespace cutwater::test
