// Random voxels that repeat, with CutterOptions::period.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "CutCells/PeriodicCells.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using VoxelPlace = std::array<int, 3>;

/// A set of voxels that repeats after n along each axis, of which no two touch along an edge or in
/// a vertex only, and the same of what is not in it.
class VoxelTorus {
 public:
  VoxelTorus(std::mt19937& random, int n, unsigned percent) : n_(n) {
    for (int v = 0; v < n * n * n; ++v) {
      if (random() % 100 < percent) voxels_.insert({v % n, v / n % n, v / n / n});
    }
    for (bool isChanged = true; isChanged;) {
      isChanged = false;
      for (int v = 0; v < n * n * n; ++v) {
        isChanged = closeAt({v % n, v / n % n, v / n / n}) || isChanged;
      }
    }
  }

  [[nodiscard]] int size() const { return n_; }
  [[nodiscard]] std::size_t count() const { return voxels_.size(); }
  [[nodiscard]] bool has(const VoxelPlace& p) const { return voxels_.contains(within(p)); }
  [[nodiscard]] VoxelPlace within(const VoxelPlace& p) const {
    return {(p[0] % n_ + n_) % n_, (p[1] % n_ + n_) % n_, (p[2] % n_ + n_) % n_};
  }

  /// Those from `lower` up to, but without, `upper`, as a mesh.
  [[nodiscard]] MeshSDF<double> mesh(const VoxelPlace& lower, const VoxelPlace& upper,
                                     double width) const {
    VoxelSolid solid(width);
    for (int x = lower[0]; x < upper[0]; ++x) {
      for (int y = lower[1]; y < upper[1]; ++y) {
        for (int z = lower[2]; z < upper[2]; ++z) {
          if (has({x, y, z})) solid.add({x, y, z});
        }
      }
    }
    return meshOf(solid);
  }

 private:
  /// Fills a voxel at a node unless both kinds are joined by faces there.
  bool closeAt(const VoxelPlace& node) {
    const auto voxel = [&](unsigned c) {
      return VoxelPlace{node[0] - static_cast<int>(c & 1U),
                        node[1] - static_cast<int>(c >> 1U & 1U),
                        node[2] - static_cast<int>(c >> 2U)};
    };
    unsigned body = 0;
    for (unsigned c = 0; c < 8; ++c) body |= (has(voxel(c)) ? 1U : 0U) << c;
    if (isJoined(body) && isJoined(~body & 0xffU)) return false;
    // One after the other, so that little is filled.
    unsigned next = body % 8;
    while (has(voxel(next))) next = (next + 1) % 8;
    voxels_.insert(within(voxel(next)));
    return true;
  }
  static bool isJoined(unsigned corners) {
    if (corners == 0) return true;
    unsigned found = corners & (~corners + 1);
    for (int n = 0; n < 8; ++n) {
      for (unsigned c = 0; c < 8; ++c) {
        if ((found >> c & 1U) == 0) continue;
        for (const unsigned other : {c ^ 1U, c ^ 2U, c ^ 4U}) found |= corners & 1U << other;
      }
    }
    return found == corners;
  }

  int n_;
  std::set<VoxelPlace> voxels_;
};

/// In how many faces two pieces are open to each other, those at the rim included.
std::size_t openings(const CutCells& cells) {
  std::set<std::array<std::int64_t, 6>> seen;
  for (std::uint32_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto& [i, j, k] = cells.arcs.cell[a];
    seen.insert({i, j, k, cells.arcs.axis[a], cells.arcs.below[a], cells.arcs.above[a]});
  }
  return seen.size();
}
/// The parts of the torus that are free of voxels, by their number of voxels.
std::vector<int> freeParts(const VoxelTorus& torus) {
  std::set<VoxelPlace> seen;
  std::vector<int> sizes;
  const int n = torus.size();
  for (int v = 0; v < n * n * n; ++v) {
    std::vector<VoxelPlace> pending{{v % n, v / n % n, v / n / n}};
    int size = 0;
    while (!pending.empty()) {
      const auto p = torus.within(pending.back());
      pending.pop_back();
      if (torus.has(p) || !seen.insert(p).second) continue;
      ++size;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
          auto next = p;
          next[axis] += step;
          pending.push_back(next);
        }
      }
    }
    if (size > 0) sizes.push_back(size);
  }
  std::ranges::sort(sizes, std::greater());
  return sizes;
}

struct Several {
  std::size_t pieces = 0;
  std::size_t regions = 0;
};

/// Against the same body written thrice along each axis, in a grid without a period; and against a
/// flood fill.
void expectMiddleOfMany(const VoxelTorus& torus, Several& seen) {
  constexpr double kVoxel = 0.125;
  const int size = torus.size();
  const auto free = freeParts(torus);
  if (torus.count() == 0 || free.empty()) return;
  const Solid<double> one(torus.mesh({0, 0, 0}, {size, size, size}, kVoxel));
  const Solid<double> many(
      torus.mesh({-size, -size, -size}, {2 * size, 2 * size, 2 * size}, kVoxel));
  const double period = size * kVoxel;
  const CellCutter cutter(one, FluidSide::Outside, {.period = {period, period, period}});
  const CellCutter reference(many);
  for (const int n : {4, 5}) {
    const double lower = n == 4 ? 0 : 0.0317;  // in planes of walls, or beside them
    const auto across = planesOfPeriod(n, lower, period);
    const auto cells =
        cutter.cut(cutter.cellsOfPeriod({across, across, across}, {}, IndexBox::ofSize(n, n, n)));
    const auto expected = reference.cut(cellsBetween({across, across, across}));
    expectIdentities(cells, 1e-13);
    for (int c = 0; c < n * n * n; ++c) {
      const Index3 cell{c % n, c / n % n, c / n / n};
      ASSERT_NO_FATAL_FAILURE(expectSameCell(cells, expected, cell));
      seen.pieces += volumesIn(cells, cell).size() > 1 ? 1 : 0;
    }
    const CutRegions fluid(cells);
    ASSERT_EQ(fluid.regions().size(), free.size());
    for (std::size_t r = 0; r < free.size(); ++r) {
      EXPECT_NEAR(fluid.regions()[r].volume, free[r] * kVoxel * kVoxel * kVoxel, 1e-13);
      EXPECT_FALSE(fluid.regions()[r].goesOn);
    }
    seen.regions += free.size() > 1 ? 1 : 0;
  }
  expectRepeats(cutter, 5, 0.0317, {.polygons = true});
  expectRepeats(cutter, 6, 0);
}

TEST(PeriodicVoxelsTest, WrappedVoxelsAreTheMiddleOfMany) {
  std::mt19937 random(21);
  Several seen;
  // The fewer voxels, the farther triangles reach beyond where cells are cut.
  for (const int size : {6, 3, 2}) {
    for (int round = 0; round < scaled(12) && !HasFailure(); ++round) {
      expectMiddleOfMany({random, size, 10 + 3 * static_cast<unsigned>(round % 12)}, seen);
    }
  }
  EXPECT_GT(seen.pieces, 50U);
  EXPECT_GT(seen.regions, 2U);
}

/// Arcs at both ends of the period are the same, between the same pieces. Returns on how many
/// faces.
std::size_t expectSameEnds(const CutCells& cells) {
  const auto [lo, hi] = cells.grid.indices();
  std::map<std::array<int, 3>, std::array<std::vector<std::array<double, 3>>, 2>> faces;
  const auto ordinal = [&](std::uint32_t side) {
    if (side >= cells.pieces.cell.size()) return -1.0 * (side - CutCells::kBeyond + 1);
    return double(side - cells.cells.firstPiece[cells.pieces.cell[side]]);
  };
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const int axis = cells.arcs.axis[a];
    const auto& cell = cells.arcs.cell[a];
    const std::array at{cell.i, cell.j, cell.k};
    const std::array first{lo.i, lo.j, lo.k};
    const std::array last{hi.i, hi.j, hi.k};
    const auto n = static_cast<std::size_t>(axis);
    if (at[n] != first[n] && at[n] != last[n] + 1) continue;
    EXPECT_NE(cells.arcs.below[a], CutCells::kBeyond);
    EXPECT_NE(cells.arcs.above[a], CutCells::kBeyond);
    // Those beside whole cells are at one end alone.
    if (std::max(cells.arcs.below[a], cells.arcs.above[a]) >= cells.pieces.cell.size()) continue;
    const std::array key{axis, at[(n + 1) % 3], at[(n + 2) % 3]};
    faces[key][at[n] == first[n] ? 0 : 1].push_back(
        {cells.arcs.area[a], ordinal(cells.arcs.below[a]), ordinal(cells.arcs.above[a])});
  }
  for (auto& [key, ends] : faces) EXPECT_EQ(ends[0], ends[1]);
  return faces.size();
}

TEST(PeriodicVoxelsTest, CoarserCellsAreThoseThatCuttingGives) {
  std::mt19937 random(22);
  std::size_t faces = 0;
  for (int round = 0; round < scaled(6) && !HasFailure(); ++round) {
    const VoxelTorus torus(random, 6, 15 + 3 * static_cast<unsigned>(round % 8));
    const Solid<double> one(torus.mesh({0, 0, 0}, {6, 6, 6}, 0.125));
    const CellCutter cutter(one, FluidSide::Outside, {.period = {0.75, 0.75, 0.75}});
    const auto cellsOf = [&](int n, double lower) {
      const auto across = planesOfPeriod(n, lower, 0.75);
      return cutter.cut(
          cutter.cellsOfPeriod({across, across, across}, {}, IndexBox::ofSize(n, n, n)),
          {.moments = 2});
    };
    for (const double lower : {0.0, 0.0317}) {
      const auto coarse = coarsened(cellsOf(8, lower), {2, 2, 2});
      const auto expected = cellsOf(4, lower);
      EXPECT_EQ(coarse.grid.period, expected.grid.period);
      expectIdentities(coarse, 1e-13);
      faces += expectSameEnds(coarse);
      static_cast<void>(toBytes(coarse));
      for (int c = 0; c < 64; ++c) {
        const Index3 cell{c % 4, c / 4 % 4, c / 16};
        ASSERT_NO_FATAL_FAILURE(
            expectSameShares(volumesIn(coarse, cell), volumesIn(expected, cell)));
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_NO_FATAL_FAILURE(
              expectSameShares(openBelow(coarse, cell, axis), openBelow(expected, cell, axis)));
        }
      }
      ASSERT_EQ(coarse.cellCount, expected.cellCount);
      ASSERT_EQ(coarse.pieceCount, expected.pieceCount);
      ASSERT_EQ(coarse.arcs.area.size(), openings(coarse));
      ASSERT_EQ(openings(coarse), openings(expected));
      ASSERT_EQ(CutRegions(coarse).regions().size(), CutRegions(expected).regions().size());
      EXPECT_EQ(CutRegions(coarse).regions()[0].goesOn, false);
      const auto all = coarsened(coarse, {4, 4, 4});
      expectIdentities(all, 1e-13);
      EXPECT_EQ(CutRegions(all).regions().size(), CutRegions(expected).regions().size());
    }
  }
  EXPECT_GT(faces, 50U);
}

TEST(PeriodicVoxelsTest, MergedCellsCloseThroughTheEnds) {
  std::mt19937 random(23);
  std::size_t covered = 0;
  std::size_t faces = 0;
  for (int round = 0; round < scaled(6) && !HasFailure(); ++round) {
    const VoxelTorus torus(random, 6, 15 + 3 * static_cast<unsigned>(round % 8));
    const Solid<double> one(torus.mesh({0, 0, 0}, {6, 6, 6}, 0.125));
    const CellCutter cutter(one, FluidSide::Outside, {.period = {0.75, 0.75, 0.75}});
    for (const int n : {2, 4, 5}) {
      const auto across = planesOfPeriod(n, 0.0317, 0.75);
      const auto cells =
          cutter.cut(cutter.cellsOfPeriod({across, across, across}, {}, IndexBox::ofSize(n, n, n)),
                     {.moments = 1});
      const auto [single, lost] = merged(cells, {.smallest = 0.2});
      covered += lost.size();
      expectIdentities(single, 1e-13);
      EXPECT_LT(check(single).worstMoments, 1e-13);
      EXPECT_EQ(check(single).multiPieceCells, 0U);
      faces += expectSameEnds(single);
      static_cast<void>(toBytes(single));
      double sum = check(cells).fluidVolume - check(single).fluidVolume;
      for (const auto& piece : lost) sum -= piece.volume;
      EXPECT_NEAR(sum, 0, 1e-13);
      const CutRegions fluid(single);
      for (const auto& region : fluid.regions()) EXPECT_FALSE(region.goesOn);
    }
  }
  EXPECT_GT(covered, 50U);
  EXPECT_GT(faces, 50U);
}

}  // namespace
}  // namespace cutwater::test
