#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "CutCells/RandomVoxels.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

constexpr double kNear = 1e-13;

/// Planes of a grid, of which every ratio-th is one of a coarser grid.
using Planes = std::array<std::vector<double>, 3>;

Planes everyNth(const Planes& planes, const std::array<int, 3>& ratios) {
  Planes result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t n = 0; n < planes[axis].size(); n += static_cast<std::size_t>(ratios[axis])) {
      result[axis].push_back(planes[axis][n]);
    }
  }
  return result;
}

/// `n` cells along each axis that grow, from `lower` to `upper`.
Planes growing(double lower, double upper, int n) {
  Planes result;
  for (auto& planes : result) {
    for (int i = 0; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      planes.push_back(lower + (upper - lower) * t * (0.8 + 0.2 * t));
    }
  }
  return result;
}

/// Compares coarsened cells with cells that were cut by the coarse planes.
class Comparison {
 public:
  Comparison(const CutCells& coarse, const CutCells& direct) : coarse_(coarse), direct_(direct) {}

  void run() {
    EXPECT_EQ(coarse_.grid.planes, direct_.grid.planes);
    ASSERT_EQ(coarse_.cellCount, direct_.cellCount);
    ASSERT_EQ(coarse_.pieceCount, direct_.pieceCount);
    for (std::uint32_t row = 0; row < coarse_.cellCount; ++row) matchPieces(row);
    ASSERT_EQ(partners_.size(), coarse_.pieceCount);
    compareArcs();
    compareWalls();
    compareClasses();
    const auto report = check(coarse_);
    EXPECT_EQ(report.outOfRange, 0U);
    EXPECT_EQ(report.lostPieces, 0U);
    EXPECT_LT(report.worstClosure, 1e-14);
  }

 private:
  using Sum = std::pair<double, Vec3<double>>;

  void matchPieces(std::uint32_t row) {
    ASSERT_EQ(coarse_.cells.index[row], direct_.cells.index[row]);
    const auto &a = coarse_.pieces, &b = direct_.pieces;
    std::vector<std::uint32_t> open;
    for (auto p = direct_.cells.firstPiece[row]; p < direct_.cells.firstPiece[row + 1]; ++p) {
      open.push_back(p);
    }
    ASSERT_EQ(coarse_.cells.firstPiece[row + 1] - coarse_.cells.firstPiece[row], open.size());
    for (auto p = coarse_.cells.firstPiece[row]; p < coarse_.cells.firstPiece[row + 1]; ++p) {
      const auto found = std::ranges::find_if(open, [&](std::uint32_t q) {
        return std::abs(a.volume[p] - b.volume[q]) < kNear &&
               length(a.centroid[p] - b.centroid[q]) < 1e-9;
      });
      ASSERT_NE(found, open.end()) << "piece " << p;
      EXPECT_EQ(a.cell[p], row);
      EXPECT_NEAR(a.wallArea[p], b.wallArea[*found], kNear);
      EXPECT_LT(length(a.wallVector[p] - b.wallVector[*found]), kNear);
      EXPECT_LT(length(a.wallCentroid[p] - b.wallCentroid[*found]), 1e-9);
      partners_.push_back(*found);
      open.erase(found);
    }
  }

  void compareArcs() const {
    using Key = std::tuple<int, int, int, int, std::uint32_t, std::uint32_t>;
    const auto sumsOf = [&](const CutCells& cells, auto pieceOf) {
      std::map<Key, Sum> sums;
      for (std::size_t i = 0; i < cells.arcs.area.size(); ++i) {
        const auto above = cells.arcs.cell[i];
        const auto axis = cells.arcs.axis[i];
        const auto below = cells.arcs.cellBelow(i);
        const auto known = [&](const Index3& cell, std::uint32_t piece) {
          return cells.grid.indices().contains(cell) ? pieceOf(piece) : CutCells::kBeyond;
        };
        auto& [area, moment] =
            sums[{above.i, above.j, above.k, axis, known(below, cells.arcs.below[i]),
                  known(above, cells.arcs.above[i])}];
        area += cells.arcs.area[i];
        moment += cells.arcs.area[i] * cells.arcs.centroid[i];
      }
      return sums;
    };
    const auto found = sumsOf(coarse_, [&](std::uint32_t piece) {
      return piece < partners_.size() ? partners_[piece] : piece;
    });
    const auto expected = sumsOf(direct_, [](std::uint32_t piece) { return piece; });
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [key, sum] : expected) {
      const auto same = found.find(key);
      ASSERT_NE(same, found.end());
      EXPECT_NEAR(same->second.first, sum.first, kNear);
      EXPECT_LT(length(same->second.second - sum.second), kNear);
    }
    EXPECT_EQ(found.size(), coarse_.arcs.area.size());
  }

  void compareWalls() const {
    ASSERT_EQ(coarse_.patchNames, direct_.patchNames);
    std::map<std::pair<std::uint32_t, std::uint32_t>, Sum> sums;
    const auto& a = coarse_.wallParts;
    for (std::size_t i = 0; i < a.piece.size(); ++i) {
      sums[{partners_[a.piece[i]], a.patch[i]}] = {a.area[i], a.centroid[i]};
    }
    EXPECT_EQ(sums.size(), a.piece.size());
    const auto& b = direct_.wallParts;
    for (std::size_t i = 0; i < b.piece.size() && b.piece[i] < direct_.pieceCount; ++i) {
      const auto found = sums.find({b.piece[i], b.patch[i]});
      ASSERT_NE(found, sums.end());
      EXPECT_NEAR(found->second.first, b.area[i], kNear);
      EXPECT_LT(length(found->second.second - b.centroid[i]), 1e-9);
    }
  }

  void compareClasses() const {
    const auto box = coarse_.grid.indices();
    for (int k = box.lo.k; k <= box.hi.k; ++k) {
      for (int j = box.lo.j; j <= box.hi.j; ++j) {
        for (int i = box.lo.i; i <= box.hi.i; ++i) {
          ASSERT_EQ(coarse_.classOf({i, j, k}), direct_.classOf({i, j, k}));
        }
      }
    }
  }

  const CutCells& coarse_;
  const CutCells& direct_;
  std::vector<std::uint32_t> partners_;  // of each piece
};

/// Coarsens cells between these planes, and compares.
void expectAsCut(const CellCutter& cutter, const Planes& planes, const Index3& first,
                 const std::array<int, 3>& ratios) {
  const auto fine = cutter.cut(cellsBetween(planes, first));
  const auto coarse = coarsened(fine, ratios);
  const Index3 coarseFirst{first.i / ratios[0], first.j / ratios[1], first.k / ratios[2]};
  const auto direct = cutter.cut(cellsBetween(everyNth(planes, ratios), coarseFirst));
  Comparison(coarse, direct).run();
  auto corners = direct.cells.fluidCorners;
  corners.resize(direct.cellCount);  // without those beyond the box
  EXPECT_EQ(coarse.cells.fluidCorners, corners);
}

TEST(CutCellsCoarsenedTest, CoarseCellsAreAsCutDirectly) {
  Solid<double> torus(MeshSDF<double>(tessellation::torus(0.3, 0.1, 40, 20)));
  torus.rotate(33.0, Vec3<double>{1, 2, 3});
  torus.translate({0.51, 0.49, 0.47});
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(torus, side);
    for (const auto& ratios : {std::array{2, 2, 2}, std::array{4, 1, 2}, std::array{3, 3, 3}}) {
      expectAsCut(cutter, growing(0, 1, 24), {0, 0, 0}, ratios);
      expectAsCut(cutter, growing(0.3, 0.8, 12), {-12, 24, -36}, ratios);
    }
  }
}

TEST(CutCellsCoarsenedTest, PiecesJoinWhereFluidConnectsThem) {
  // A comb of plates in planes of the fine grid, and between them.
  PolygonSoup soup;
  soup.patchNames = {"plates"};
  for (const double x : {0.25, 0.5, 0.7}) {
    const auto plate = triangulated(tessellation::box({x, 0.1, 0.1}, {x + 1e-6, 0.9, 0.9}));
    const auto shift = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), plate.points.begin(), plate.points.end());
    for (std::size_t i = 0; i < plate.polygonCount(); ++i) {
      const auto t = plate.polygon(i);
      soup.addPolygon(std::array{t[0] + shift, t[1] + shift, t[2] + shift});
    }
  }
  const Solid<double> plates{MeshSDF<double>(soup)};
  const CellCutter cutter(plates);
  Planes planes;
  for (auto& axis : planes) {
    for (int i = 0; i <= 16; ++i) axis.push_back(i / 16.0);
  }
  for (const int ratio : {2, 4, 8, 16}) expectAsCut(cutter, planes, {}, {ratio, ratio, ratio});
}

TEST(CutCellsCoarsenedTest, VoxelSolidsDownToOneCell) {
  std::mt19937 random(3);
  std::size_t several = 0;
  for (int n = 0; n < scaled(6) && !HasFailure(); ++n) {
    const Solid<double> solid{meshOf(randomVoxels(random))};
    const CellCutter cutter(solid);
    // Voxels on planes of the finest cells, or between them.
    const double lower = n % 2 == 0 ? 0 : -0.0113;
    Planes planes;
    for (auto& axis : planes) {
      for (int i = 0; i <= 8; ++i) axis.push_back(lower + i * 0.75 / 8);
    }
    auto cells = cutter.cut(cellsBetween(planes));
    for (int ratio = 2; ratio <= 8; ratio *= 2) {
      cells = coarsened(cells, {2, 2, 2});
      const auto direct = cutter.cut(cellsBetween(everyNth(planes, {ratio, ratio, ratio})));
      Comparison(cells, direct).run();
      several += check(cells).multiPieceCells;
    }
    EXPECT_EQ(cells.grid.indices().count(), 1U);
  }
  EXPECT_GT(several, 20U);
}

TEST(CutCellsCoarsenedTest, NeedsCoarseCells) {
  const Solid<double> ball{MeshSDF<double>(tessellation::icosphere(0.3, 1))};
  const CellCutter cutter(ball);
  const auto planes = growing(-1, 1, 6);
  const auto cells = cutter.cut(cellsBetween(planes));
  EXPECT_THROW(static_cast<void>(coarsened(cells, {4, 1, 1})), Error);
  EXPECT_THROW(static_cast<void>(coarsened(cells, {0, 1, 1})), Error);
  EXPECT_THROW(static_cast<void>(coarsened(cutter.cut(cellsBetween(planes, {1, 0, 0})), {2, 2, 2})),
               Error);
  const auto same = coarsened(cells, {1, 1, 1});
  EXPECT_EQ(same.pieces.volume, std::vector(cells.pieces.volume.begin(),
                                            cells.pieces.volume.begin() +
                                                static_cast<std::ptrdiff_t>(cells.pieceCount)));
}

}  // namespace
}  // namespace cutwater::test
