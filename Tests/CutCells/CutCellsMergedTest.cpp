#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "CutCells/RandomVoxels.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

GridPatch<double> cube(int n, double lower = 0, double upper = 1) {
  const double h = (upper - lower) / n;
  return {Level<double>({lower, lower, lower}, {h, h, h}), IndexBox::ofSize(n, n, n)};
}

/// Which pieces and whole cells of the box are connected by open faces.
class Fluid {
 public:
  explicit Fluid(const CutCells& cells) : cells_(cells), box_(cells.grid.indices()) {
    sets_.reset(cells.pieceCount + box_.count());
    const auto& arcs = cells.arcs;
    for (std::size_t a = 0; a < arcs.area.size(); ++a) {
      join(node(arcs.cellBelow(a), arcs.below[a]), node(arcs.cell[a], arcs.above[a]));
    }
    for (std::size_t n = 0; n < box_.count(); ++n) {
      const auto cell = at(n);
      if (cells.classOf(cell) != FluidClass::Fluid) continue;
      for (const Index3& next : {Index3{cell.i + 1, cell.j, cell.k},
                                 {cell.i, cell.j + 1, cell.k},
                                 {cell.i, cell.j, cell.k + 1}}) {
        const bool isOpen = box_.contains(next) && cells.classOf(next) == FluidClass::Fluid;
        if (isOpen) join(whole(cell), whole(next));
      }
    }
  }

  static constexpr std::uint32_t kNone = 0xffffffff;
  /// The set of the only piece of a cell, or of the whole cell; kNone for body.
  [[nodiscard]] std::uint32_t of(const Index3& cell) {
    const auto row = cells_.rowOf(cell);
    if (row != CutCells::kNoRow) return sets_.find(cells_.cells.firstPiece[row]);
    return cells_.classOf(cell) == FluidClass::Fluid ? sets_.find(whole(cell)) : kNone;
  }
  [[nodiscard]] std::uint32_t ofPiece(std::uint32_t piece) { return sets_.find(piece); }
  [[nodiscard]] Index3 at(std::size_t n) const {
    const auto u = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
    return box_.at(u(n % box_.length(0)), u(n / box_.length(0) % box_.length(1)),
                   u(n / box_.length(0) / box_.length(1)));
  }

 private:
  [[nodiscard]] std::uint32_t whole(const Index3& cell) const {
    const auto& lo = box_.lo;
    const auto n = [](int i) { return static_cast<std::size_t>(i); };
    return static_cast<std::uint32_t>(
        cells_.pieceCount +
        (n(cell.k - lo.k) * box_.length(1) + n(cell.j - lo.j)) * box_.length(0) + n(cell.i - lo.i));
  }
  [[nodiscard]] std::uint32_t node(const Index3& cell, std::uint32_t side) const {
    if (side < cells_.pieceCount) return side;
    return side == CutCells::kWholeCell && box_.contains(cell) ? whole(cell) : kNone;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    if (a != kNone && b != kNone) sets_.unite(a, b);
  }

  const CutCells& cells_;
  IndexBox box_;
  detail::DisjointSets sets_;
};

/// That merged cells hold one piece each, lose what they say, and connect nothing anew.
MergedCells expectMerged(const CutCells& cells, const MergeOptions& options = {}) {
  const auto result = merged(cells, options);
  const auto& after = result.cells;
  const auto report = check(after);
  EXPECT_EQ(report.multiPieceCells, 0U);
  EXPECT_EQ(report.outOfRange, 0U);
  EXPECT_EQ(report.lostPieces, 0U);
  EXPECT_LT(report.worstClosure, 1e-14);
  const double lost =
      std::accumulate(result.lost.begin(), result.lost.end(), 0.0,
                      [](double sum, const auto& piece) { return sum + piece.volume; });
  EXPECT_NEAR(report.fluidVolume + lost, check(cells).fluidVolume, 1e-13);
  for (std::size_t p = 0; p < after.pieceCount; ++p) {
    EXPECT_GT(length(after.pieces.wallVector[p]), 0);
    EXPECT_GE(after.volumeFraction(static_cast<std::uint32_t>(p)), options.smallest);
  }
  // Each connected part of the fluid lies in one that was connected before.
  Fluid fluid(after);
  Fluid before(cells);
  std::map<std::uint32_t, std::uint32_t> cameFrom;
  for (std::size_t n = 0; n < after.grid.indices().count(); ++n) {
    const auto cell = fluid.at(n);
    const auto here = fluid.of(cell);
    if (here == Fluid::kNone) continue;
    auto there = before.of(cell);
    const auto row = cells.rowOf(cell);
    if (row != CutCells::kNoRow) {
      // The piece that was kept is the first with its volume.
      const double volume = after.pieces.volume[after.cells.firstPiece[after.rowOf(cell)]];
      auto p = cells.cells.firstPiece[row];
      while (cells.pieces.volume[p] != volume) ++p;
      there = before.ofPiece(p);
    }
    EXPECT_EQ(cameFrom.emplace(here, there).first->second, there);
  }
  return result;
}

TEST(CutCellsMergedTest, APlateStaysTight) {
  const auto plate = tessellation::box({-1, -1, 0.43}, {2, 2, 0.43 + 1e-6});
  const auto cells = CellCutter(Solid<double>(MeshSDF<double>(plate))).cut(cube(8));
  ASSERT_EQ(check(cells).multiPieceCells, 64U);
  const auto result = expectMerged(cells);
  // 0.43 is in the fourth cell from below: its larger part is the lower one, 0.055 of 0.125.
  EXPECT_EQ(result.lost.size(), 64U);
  EXPECT_EQ(result.cells.patchNames, (std::vector<std::string>{"box", "covered"}));
  // Each of the cells above, all fluid before, has got a wall below.
  EXPECT_EQ(result.cells.cellCount, 128U);
  double covered = 0;
  for (std::size_t w = 0; w < result.cells.wallParts.area.size(); ++w) {
    if (result.cells.wallParts.patch[w] == 1) covered += result.cells.wallParts.area[w];
  }
  EXPECT_NEAR(covered, 1, 1e-14);
  Fluid fluid(result.cells);
  EXPECT_NE(fluid.of({3, 3, 0}), fluid.of({3, 3, 7}));
}

TEST(CutCellsMergedTest, ThinGapsAndSeveralSheets) {
  // Two plates in one layer of cells: the gap between them is the smallest piece; and a bubble.
  auto soup = tessellation::box({-1, -1, 0.4}, {2, 2, 0.43});
  soup = together(soup, tessellation::box({-1, -1, 0.45}, {2, 2, 0.46}));
  auto bubble = tessellation::icosphere(0.02, 1);
  for (auto& p : bubble.points) p += {0.5, 0.5, 0.8};
  soup = together(soup, bubble);
  for (const int n : {2, 5, 8}) {
    const auto cells = CellCutter(Solid<double>(MeshSDF<double>(soup))).cut(cube(n));
    expectMerged(cells);
    expectMerged(cells, {.smallest = 0.3});
  }
}

TEST(CutCellsMergedTest, RandomVoxels) {
  std::mt19937 random(5);
  std::size_t several = 0;
  std::size_t again = 0;
  for (int n = 0; n < scaled(8) && !HasFailure(); ++n) {
    const Solid<double> solid{meshOf(randomVoxels(random))};
    const double lower = n % 2 == 0 ? 0 : -0.0113;
    const auto cells = CellCutter(solid).cut(cube(6, lower, lower + 0.75));
    const auto result = expectMerged(cells, {.smallest = n % 3 == 0 ? 0.1 : 0});
    several += check(cells).multiPieceCells;
    again += expectMerged(result.cells).lost.size();
  }
  EXPECT_GT(several, 100U);
  EXPECT_EQ(again, 0U);  // once is enough
}

TEST(CutCellsMergedTest, BoxesAgreeWithinTwoCells) {
  std::mt19937 random(7);
  const CellCutter cutter{Solid<double>(meshOf(randomVoxels(random)))};
  const Level<double> level({0, 0, 0}, {0.107, 0.107, 0.107});
  const auto whole = merged(cutter.cut(GridPatch<double>{level, {{-2, -2, -2}, {8, 8, 8}}})).cells;
  const IndexBox inner{{2, 1, 2}, {5, 5, 6}};
  const auto part = merged(cutter.cut(GridPatch<double>{level, {{0, -1, 0}, {7, 7, 8}}})).cells;
  std::size_t compared = 0;
  for (std::size_t row = 0; row < part.cellCount; ++row) {
    const auto& cell = part.cells.index[row];
    if (!inner.contains(cell)) continue;
    const auto there = whole.rowOf(cell);
    ASSERT_NE(there, CutCells::kNoRow);
    EXPECT_EQ(part.pieces.wallVector[row], whole.pieces.wallVector[there]);
    EXPECT_EQ(part.pieces.volume[row], whole.pieces.volume[there]);
    ++compared;
  }
  EXPECT_GT(compared, 20U);
}

TEST(CutCellsMergedTest, NeedsAShare) {
  EXPECT_THROW(static_cast<void>(merged(CutCells{}, {.smallest = -0.1})), Error);
  EXPECT_THROW(static_cast<void>(merged(CutCells{}, {.smallest = 1.1})), Error);
}

}  // namespace
}  // namespace cutwater::test
