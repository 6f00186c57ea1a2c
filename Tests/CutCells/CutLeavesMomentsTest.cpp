#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include "CutCells/RandomLeaves.hpp"
#include "CutCells/ShellCells.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// The integrals of monomials over the fluid in a box, and over the wall in it, about the origin.
struct Sums {
  std::vector<double> volume = std::vector<double>(35);
  std::vector<double> wall = std::vector<double>(35);
};
template <typename Cut>
void add(const Cut& cut, std::size_t piece, Sums& sums) {
  const auto volume = shifted(cut.moments.ofVolume(piece), cut.pieces.centroid[piece], {});
  const auto wall = shifted(cut.moments.ofWall(piece), cut.pieces.wallCentroid[piece], {});
  for (std::size_t i = 0; i < volume.size(); ++i) {
    sums.volume[i] += volume[i];
    sums.wall[i] += wall[i];
  }
}
/// Of a box of fluid.
void add(const Box<double>& box, Sums& sums) {
  const auto integral = [](std::size_t power, double lower, double upper) {
    const auto n = static_cast<double>(power) + 1;
    return (std::pow(upper, n) - std::pow(lower, n)) / n;
  };
  for (std::size_t p = 0; p <= 4; ++p) {
    for (std::size_t q = 0; p + q <= 4; ++q) {
      for (std::size_t r = 0; p + q + r <= 4; ++r) {
        sums.volume[CutCells::Moments::indexOf(p, q, r)] += integral(p, box.lower.x, box.upper.x) *
                                                            integral(q, box.lower.y, box.upper.y) *
                                                            integral(r, box.lower.z, box.upper.z);
      }
    }
  }
}

/// Of the finest cells in a leaf.
Sums sumsOf(const CutCells& fine, const OctreeCell& leaf, int deepest) {
  Sums sums;
  const int shift = deepest - leaf.level;
  const int width = 1 << shift;
  for (int n = 0; n < width * width * width; ++n) {
    const Index3 cell{(leaf.index.i << shift) + n % width,
                      (leaf.index.j << shift) + n / width % width,
                      (leaf.index.k << shift) + n / width / width};
    const auto row = fine.rowOf(cell);
    if (row == CutCells::kNoRow) {
      if (fine.classOf(cell) == FluidClass::Fluid) add(fine.boxOf(cell), sums);
      continue;
    }
    for (auto p = fine.cells.firstPiece[row]; p < fine.cells.firstPiece[row + 1]; ++p) {
      add(fine, p, sums);
    }
  }
  return sums;
}

/// Compares the moments of leaves with those of the finest cells in them; returns how many are
/// coarser.
std::size_t expectSumsOfFinest(const CellCutter& cutter, const Mesh& mesh) {
  std::size_t coarse = 0;
  const auto leaves = cutter.cut(mesh, {.moments = 4});
  const auto fine = cutter.cut(finestOf(mesh), {.moments = 4});
  EXPECT_LT(check(leaves).worstMoments, 1e-13);
  for (std::size_t row = 0; row < leaves.cut.leaf.size(); ++row) {
    const auto& leaf = mesh.cells()[leaves.cut.leaf[row]];
    if (leaf.level < mesh.deepest()) ++coarse;
    Sums sums;
    for (auto p = leaves.cut.firstPiece[row]; p < leaves.cut.firstPiece[row + 1]; ++p) {
      add(leaves, p, sums);
    }
    const auto expected = sumsOf(fine, leaf, mesh.deepest());
    for (std::size_t i = 0; i < 35; ++i) {
      EXPECT_NEAR(sums.volume[i], expected.volume[i], 1e-13);
      EXPECT_NEAR(sums.wall[i], expected.wall[i], 1e-13);
    }
  }
  return coarse;
}

TEST(CutLeavesMomentsTest, AreSumsOfThoseOfTheFinestCells) {
  std::mt19937 random(21);
  std::size_t coarse = 0;
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(turnedTorus(), side);
    for (int n = 0; n < scaled(3) && !HasFailure(); ++n) {
      coarse += expectSumsOfFinest(cutter, randomMesh(random, 4, 0, 1, 80));
    }
  }
  EXPECT_GT(coarse, 100U);
}

TEST(CutLeavesMomentsTest, OfShellsThatOverlapAreSumsOfThoseOfTheFinestCells) {
  std::mt19937 random(24);
  const auto both = joined({ball(0.3, {0.35, 0.4, 0.51}, 2), ball(0.27, {0.6, 0.62, 0.48}, 2)});
  std::size_t coarse = 0;
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(solidOf(both), side);
    for (int n = 0; n < scaled(2) && !HasFailure(); ++n) {
      coarse += expectSumsOfFinest(cutter, randomMesh(random, 4, 0, 1, 80));
    }
  }
  EXPECT_GT(coarse, 50U);
}

TEST(CutLeavesMomentsTest, OfOneLevelAreThoseOfTheGrid) {
  const CellCutter cutter(turnedTorus());
  const OctreeDomain<double> domain({0.01, -0.02, 0.03}, 0.32, {3, 4, 3});
  const Octree<double> mesh(turnedTorus(), domain, {.cut = 2, .bands = {{10.0, 2}}});
  const auto cells = cutter.cut(finestOf(mesh), {.moments = 3});
  const auto leaves = cutter.cut(mesh, {.moments = 3});
  ASSERT_EQ(leaves.moments.degree, 3);
  ASSERT_EQ(leaves.moments.arc.size(), cells.moments.arc.size());
  for (std::uint32_t row = 0; row < leaves.cut.leaf.size(); ++row) {
    const auto same = cells.rowOf(mesh.cells()[leaves.cut.leaf[row]].index);
    ASSERT_NE(same, CutCells::kNoRow);
    auto q = cells.cells.firstPiece[same];
    for (auto p = leaves.cut.firstPiece[row]; p < leaves.cut.firstPiece[row + 1]; ++p, ++q) {
      EXPECT_TRUE(std::ranges::equal(leaves.moments.ofVolume(p), cells.moments.ofVolume(q)));
      EXPECT_TRUE(std::ranges::equal(leaves.moments.ofWall(p), cells.moments.ofWall(q)));
      EXPECT_TRUE(
          std::ranges::equal(leaves.moments.ofWallVector(p), cells.moments.ofWallVector(q)));
    }
  }
}

TEST(CutLeavesMomentsTest, ChecksFindWhatIsWrong) {
  std::mt19937 random(22);
  const auto leaves = CellCutter(turnedTorus()).cut(randomMesh(random, 4, 0, 1), {.moments = 2});
  const auto worstWith = [&](const auto& change) {
    auto changed = leaves;
    change(changed);
    return check(changed).worstMoments;
  };
  EXPECT_LT(worstWith([](CutLeaves&) {}), 1e-14);
  EXPECT_GT(worstWith([](CutLeaves& l) { l.moments.volume[1] += 1e-6; }), 1e-8);
  EXPECT_GT(worstWith([](CutLeaves& l) { l.moments.arc[2] += 1e-6; }), 1e-8);
  EXPECT_GT(worstWith([](CutLeaves& l) { l.moments.wallVector[3].y += 1e-6; }), 1e-8);
}

TEST(CutLeavesMomentsTest, AreOfDegreesUpToFour) {
  std::mt19937 random(23);
  const CellCutter cutter(turnedTorus());
  const auto mesh = randomMesh(random, 2, 0, 1);
  EXPECT_THROW(static_cast<void>(cutter.cut(mesh, {.moments = 5})), Error);
  EXPECT_TRUE(cutter.cut(mesh).moments.volume.empty());
}

}  // namespace
}  // namespace cutwater::test
