#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "Support/DamagedSoups.hpp"
#include "Support/Grid.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

GridPatch<double> cubeOf(int n, double lower, double upper) {
  const double h = (upper - lower) / n;
  return {Level<double>({lower, lower, lower}, {h, h, h}), IndexBox::ofSize(n, n, n)};
}

/// The volumes of what voxels from 0 to 12 leave free, in parts that share faces, largest first.
std::vector<double> freeVolumes(const VoxelSolid& solid) {
  constexpr int kCount = 13;
  const auto number = [](int x, int y, int z) {
    return static_cast<std::uint32_t>((z * kCount + y) * kCount + x);
  };
  detail::DisjointSets sets(kCount * kCount * kCount);
  std::vector<double> volumes(kCount * kCount * kCount);
  const auto forFree = [&](auto&& visit) {
    for (int z = 0; z < kCount; ++z) {
      for (int y = 0; y < kCount; ++y) {
        for (int x = 0; x < kCount; ++x) {
          if (!solid.has({x, y, z})) visit(x, y, z);
        }
      }
    }
  };
  forFree([&](int x, int y, int z) {
    if (x > 0 && !solid.has({x - 1, y, z})) sets.unite(number(x, y, z), number(x - 1, y, z));
    if (y > 0 && !solid.has({x, y - 1, z})) sets.unite(number(x, y, z), number(x, y - 1, z));
    if (z > 0 && !solid.has({x, y, z - 1})) sets.unite(number(x, y, z), number(x, y, z - 1));
  });
  const double each = solid.width() * solid.width() * solid.width();
  forFree([&](int x, int y, int z) { volumes[sets.find(number(x, y, z))] += each; });
  std::erase(volumes, 0.0);
  std::ranges::sort(volumes, std::greater{});
  return volumes;
}

/// What is on both sides of an open part is in one region; and all fluid is in some region.
void expectArcsWithin(const CutCells& cells, const CutRegions& regions) {
  const auto box = cells.grid.indices();
  const auto regionOf = [&](std::uint32_t side, const Index3& cell) {
    return side < cells.pieces.cell.size() ? regions.ofPiece(side) : regions.ofCell(cell);
  };
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto& cell = cells.arcs.cell[a];
    const auto under = cells.arcs.cellBelow(a);
    if (!box.contains(cell) || !box.contains(under)) continue;
    ASSERT_EQ(regionOf(cells.arcs.below[a], under), regionOf(cells.arcs.above[a], cell));
  }
  forEachIndex(box, [&](const Index3& cell) {
    EXPECT_EQ(regions.ofCell(cell) != CutRegions::kNone, cells.classOf(cell) == FluidClass::Fluid);
  });
}

std::vector<double> volumesOf(const CutRegions& regions) {
  std::vector<double> volumes;
  for (const auto& region : regions.regions()) volumes.push_back(region.volume);
  return volumes;
}

void expectVolumes(const CutRegions& regions, const std::vector<double>& expected) {
  const auto volumes = volumesOf(regions);
  ASSERT_EQ(volumes.size(), expected.size());
  for (std::size_t n = 0; n < volumes.size(); ++n) EXPECT_NEAR(volumes[n], expected[n], 1e-13);
}

TEST(CutRegionsTest, AreThoseOfVoxelsThatShareFaces) {
  std::mt19937 random(1);
  std::size_t cavities = 0;
  for (int n = 0; n < scaled(20) && !HasFailure(); ++n) {
    const auto solid = randomVoxels(random);
    const auto mesh = meshOf(solid);
    // All voxels, in cells from larger than these to smaller.
    const auto cells = CellCutter(Solid<double>(mesh)).cut(cubeOf(5 + n % 13, 0, 13.0 / 16));
    const CutRegions regions(cells);
    expectVolumes(regions, freeVolumes(solid));
    expectArcsWithin(cells, regions);
    for (std::size_t r = 0; r < regions.regions().size(); ++r) {
      EXPECT_EQ(regions.regions()[r].goesOn, regions.ofCell({}) == r || regions.ofPiece(0) == r);
    }
    cavities += regions.regions().size() - 1;
  }
  EXPECT_GT(cavities, 30U);
}

TEST(CutRegionsTest, CountWhatTheyHave) {
  const auto ball = tessellation::icosphere(0.5, 3);
  const auto shell = insideOut(tessellation::icosphere(0.49999, 3));
  const CellCutter cutter{Solid<double>(MeshSDF<double>(together(ball, shell)))};
  const auto cells = cutter.cut(cubeOf(24, -1, 1));
  const CutRegions regions(cells);
  ASSERT_EQ(regions.regions().size(), 2U);
  const auto& [around, within] = std::pair(regions.regions()[0], regions.regions()[1]);
  EXPECT_TRUE(around.goesOn);
  EXPECT_FALSE(within.goesOn);
  EXPECT_NEAR(within.volume, check(cells).fluidVolume - around.volume, 1e-12);
  EXPECT_NEAR(within.volume, 4 * std::numbers::pi / 3 * 0.125, 0.01);
  EXPECT_EQ(around.pieces + within.pieces, cells.pieceCount);
  EXPECT_EQ(regions.ofCell({0, 0, 0}), 0U);
  EXPECT_EQ(regions.ofCell({12, 12, 12}), 1U);
  std::array<std::size_t, 2> whole{};
  forEachIndex(cells.grid.indices(), [&](const Index3& cell) {
    if (cells.classOf(cell) == FluidClass::Fluid) ++whole[regions.ofCell(cell)];
  });
  EXPECT_EQ(whole[0], around.wholeCells);
  EXPECT_EQ(whole[1], within.wholeCells);
}

TEST(CutRegionsTest, APlateOfABillionthKeepsItsSidesApart) {
  const auto plate = tessellation::box({-2, -2, 0.1}, {2, 2, 0.1 + 1e-9}, 1);
  const CellCutter cutter{Solid<double>(MeshSDF<double>(plate))};
  const CutRegions regions(cutter.cut(cubeOf(9, -1, 1)));
  expectVolumes(regions, {4 * 1.1, 4 * (0.9 - 1e-9)});
  for (const auto& region : regions.regions()) EXPECT_TRUE(region.goesOn);
  EXPECT_NE(regions.ofCell({4, 4, 0}), regions.ofCell({4, 4, 8}));
}

TEST(CutRegionsTest, OfLeavesAreThoseOfTheirFinestCells) {
  std::mt19937 random(1);
  std::size_t cavities = 0;
  for (int n = 0; n < scaled(20) && !HasFailure(); ++n) {
    const auto solid = randomVoxels(random);
    const CellCutter cutter{Solid<double>(meshOf(solid))};
    // No planes in those of voxels; the domain reaches as far as theirs.
    const auto mesh = randomMesh(random, 4, -0.013, 13.0 / 16 + 0.026);
    const auto leaves = cutter.cut(mesh);
    const CutRegions regions(leaves, mesh);
    const GridPatch<double> finest{mesh.domain().level(mesh.deepest()),
                                   mesh.domain().indices(mesh.deepest())};
    const CutRegions fine(cutter.cut(finest));
    expectVolumes(regions, volumesOf(fine));
    ASSERT_EQ(regions.regions().size(), freeVolumes(solid).size());
    for (std::uint32_t leaf = 0; leaf < leaves.classes.size(); ++leaf) {
      EXPECT_EQ(regions.ofLeaf(leaf) != CutRegions::kNone,
                leaves.classes[leaf] == FluidClass::Fluid);
    }
    for (std::size_t r = 0; r < regions.regions().size(); ++r) {
      EXPECT_EQ(regions.regions()[r].goesOn, r == fine.ofCell({}));
    }
    cavities += regions.regions().size() - 1;
  }
  EXPECT_GT(cavities, 100U);
}

}  // namespace
}  // namespace cutwater::test
