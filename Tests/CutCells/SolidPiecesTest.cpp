// Pieces, arcs and moments of cells of solids that are no meshes.

#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "CutCells/SampledCell.hpp"
#include "CutCells/ShellCells.hpp"

namespace cutwater::test {
namespace {

TEST(SolidPiecesTest, APlateThatNoNodeSeesHasTwoSides) {
  for (const double thickness : {1e-3, 1e-6}) {
    for (const double turn : {0.0, 20.0}) {
      Cuboid<double> plate({-2, -2, 0.013}, {2, 2, 0.013 + thickness});
      plate.rotate(turn, {1, 2, 0.3});
      plate.translate({0.5, 0.5, 0.5});
      const auto cells = SolidCutter(Solid<double>(plate)).cut(unitGrid(8));
      const auto report = check(cells);
      EXPECT_LT(report.worstClosure, 1e-14);
      EXPECT_EQ(report.lostPieces, 0U);
      const CutRegions regions(cells);
      EXPECT_EQ(regions.regions().size(), 2U) << thickness << " turned by " << turn;
      if (turn == 0) {
        EXPECT_EQ(report.multiPieceCells, 64U);
        EXPECT_NEAR(report.bodyVolume, thickness, 1e-14);
        EXPECT_NEAR(report.wallArea, 2, 1e-13);
      } else {
        EXPECT_GT(report.multiPieceCells, 30U);
      }
    }
  }
}

TEST(SolidPiecesTest, OfAGyroidWallAreThoseOfAFlood) {
  const Solid<double> wall =
      TpmsSolid<double>(TpmsField<double>(TpmsPattern::gyroid(), 0.5), TpmsPart::Wall, 0.3);
  const SolidCutter cutter(wall, FluidSide::Outside, {.points = 2, .tolerance = 0.01});
  const auto cells = cutter.cut(unitGrid(15));
  EXPECT_GT(check(cells).multiPieceCells, 200U);
  // Of cells without pieces that samples miss.
  int compared = 0;
  for (std::size_t row = 0; row < cells.cellCount; row += 53) {
    const auto first = cells.cells.firstPiece[row];
    const auto last = cells.cells.firstPiece[row + 1];
    double smallest = 1;
    for (auto p = first; p < last; ++p) smallest = std::min(smallest, cells.volumeFraction(p));
    if (smallest < 0.01) continue;
    ++compared;
    EXPECT_EQ(
        static_cast<int>(last - first),
        SampledCell(wall, FluidSide::Outside, cells.boxOf(cells.cells.index[row]), 24).parts())
        << cells.cells.index[row].i << ' ' << cells.cells.index[row].j;
  }
  EXPECT_GT(compared, 20);
  // Two channels, which do not meet.
  EXPECT_EQ(CutRegions(cells).regions().size(), 2U);
}

TEST(SolidPiecesTest, WallsInPlanesOfTheGridAreThoseOfAMesh) {
  const Box<double> box{{0.25, 0.25, 0.375}, {0.75, 0.625, 0.75}};
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto solid =
        SolidCutter(Solid<double>(Cuboid<double>(box.lower, box.upper)), side).cut(unitGrid(8));
    const auto mesh =
        CellCutter(solidOf(tessellation::box(box.lower, box.upper)), side).cut(unitGrid(8));
    EXPECT_EQ(solid.cells.index, mesh.cells.index);
    EXPECT_EQ(solid.cells.wallFaces, mesh.cells.wallFaces);
    EXPECT_EQ(solid.bodyRuns, mesh.bodyRuns);
    EXPECT_EQ(solid.arcs.cell, mesh.arcs.cell);
    EXPECT_EQ(solid.arcs.below, mesh.arcs.below);
    EXPECT_EQ(solid.arcs.above, mesh.arcs.above);
    for (std::uint32_t row = 0; row < solid.cellCount; ++row) {
      EXPECT_TRUE(solid.isTouchedOnly(row));
      EXPECT_NEAR(solid.pieces.wallArea[row], mesh.pieces.wallArea[row], 1e-15);
    }
  }
}

Solid<double> twoBalls() {
  return Sphere<double>({0.4, 0.45, 0.5}, 0.21) | Sphere<double>({0.6, 0.55, 0.45}, 0.22);
}

TEST(SolidPiecesTest, HaveTheSameBitsInEveryBoxWithAnyThreads) {
  const SolidCutter cutter(twoBalls());
  const Level<double> level({0, 0, 0}, {1.0 / 20, 1.0 / 20, 1.0 / 20});
  const auto all =
      cutter.cut(GridPatch<double>{level, IndexBox::ofSize(20, 20, 20)}, {.threads = 1});
  const auto hash = checksum(toBytes(all));
  for (const int threads : {2, 5}) {
    const auto again =
        cutter.cut(GridPatch<double>{level, IndexBox::ofSize(20, 20, 20)}, {.threads = threads});
    EXPECT_EQ(checksum(toBytes(again)), hash);
  }
  const auto part = cutter.cut(GridPatch<double>{level, {{3, 5, 2}, {13, 16, 12}}});
  EXPECT_GT(part.cellCount, 200U);
  for (std::uint32_t row = 0; row < part.cellCount; ++row) {
    const auto whole = all.rowOf(part.cells.index[row]);
    ASSERT_NE(whole, CutCells::kNoRow);
    EXPECT_EQ(part.cells.error[row], all.cells.error[whole]);
    const auto first = part.cells.firstPiece[row];
    const auto firstOfAll = all.cells.firstPiece[whole];
    ASSERT_EQ(part.cells.firstPiece[row + 1] - first, all.cells.firstPiece[whole + 1] - firstOfAll);
    EXPECT_EQ(part.pieces.volume[first], all.pieces.volume[firstOfAll]);
    EXPECT_EQ(part.pieces.centroid[first], all.pieces.centroid[firstOfAll]);
    EXPECT_EQ(part.pieces.wallVector[first], all.pieces.wallVector[firstOfAll]);
  }
}

TEST(SolidPiecesTest, WallsBelongToTheirPatches) {
  const auto cells = SolidCutter(twoBalls()).cut(unitGrid(16));
  ASSERT_EQ(cells.patchNames.size(), 2U);
  std::array<double, 2> areas{};
  std::vector<Vec3<double>> vectors(cells.pieces.volume.size());
  for (std::size_t i = 0; i < cells.wallParts.piece.size(); ++i) {
    vectors[cells.wallParts.piece[i]] += cells.wallParts.vector[i];
    if (cells.wallParts.piece[i] < cells.pieceCount) {
      areas[cells.wallParts.patch[i]] += cells.wallParts.area[i];
    }
  }
  for (std::size_t p = 0; p < vectors.size(); ++p) {
    EXPECT_LT(length(vectors[p] - cells.pieces.wallVector[p]), 1e-16);
  }
  // What a sphere's cap has of its area: the share of its diameter.
  const double distance = length(Vec3<double>{0.2, 0.1, -0.05});
  const auto visible = [&](double r, double other) {
    const double plane = (distance * distance + r * r - other * other) / (2 * distance);
    return 2 * std::numbers::pi * r * (r + plane);
  };
  EXPECT_NEAR(areas[0], visible(0.21, 0.22), 1e-4);
  EXPECT_NEAR(areas[1], visible(0.22, 0.21), 1e-4);
}

TEST(SolidPiecesTest, MomentsOfABallAreThoseOfTheFormula) {
  const Vec3<double> center{0.51, 0.49, 0.505};
  const double r = 0.37;
  const auto cells =
      SolidCutter(Solid<double>(Sphere<double>(center, r)), FluidSide::Inside, {.points = 5})
          .cut(unitGrid(16), {.moments = 4});
  const auto report = check(cells);
  EXPECT_LT(report.worstMoments, 1e-5);
  std::vector<double> sum(cells.moments.perPiece());
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) {
    const auto row = shifted(cells.moments.ofVolume(p), cells.pieces.centroid[p], center);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += row[i];
  }
  // Of cells that are all fluid, by their own moments.
  const auto box = cells.grid.indices();
  for (std::size_t n = 0; n < std::size_t{16} * 16 * 16; ++n) {
    const auto cell =
        box.at(static_cast<std::uint32_t>(n % 16), static_cast<std::uint32_t>(n / 16 % 16),
               static_cast<std::uint32_t>(n / 256));
    if (cells.classOf(cell) != FluidClass::Fluid) continue;
    auto of = cells.boxOf(cell);
    of.lower -= center;
    of.upper -= center;
    for (std::size_t i = 0; i < kOrder.size(); ++i) sum[i] += ofBox(kOrder[i], of);
  }
  const double pi = std::numbers::pi;
  const double xx = 4 * pi / 15 * std::pow(r, 5);
  const double xxxx = 4 * pi / 35 * std::pow(r, 7);
  EXPECT_NEAR(sum[CutCells::Moments::indexOf(0, 0, 0)], 4 * pi / 3 * r * r * r, 1e-9);
  for (const auto& powers : {std::array{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}) {
    EXPECT_NEAR(sum[CutCells::Moments::indexOf(static_cast<std::size_t>(powers[0]),
                                               static_cast<std::size_t>(powers[1]),
                                               static_cast<std::size_t>(powers[2]))],
                xx, 1e-10);
  }
  EXPECT_NEAR(sum[CutCells::Moments::indexOf(1, 0, 0)], 0, 1e-10);
  EXPECT_NEAR(sum[CutCells::Moments::indexOf(0, 4, 0)], xxxx, 1e-11);
  EXPECT_NEAR(sum[CutCells::Moments::indexOf(0, 2, 2)], xxxx / 3, 1e-11);
}

/// Of the fluid in a cell.
double fractionOf(const CutCells& cells, std::uint32_t row) {
  double sum = 0;
  for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
    sum += cells.volumeFraction(p);
  }
  return sum;
}

/// By the divergence theorem: of (x^3, y^2 z, x y z) over a piece, its wall and its open parts.
TEST(SolidPiecesTest, QuadratureKeepsTheDivergenceTheorem) {
  const Solid<double> ball = Sphere<double>({0.51, 0.49, 0.505}, 0.37);
  const SolidCutter cutter(ball, FluidSide::Outside, {.points = 4});
  const auto cells = cutter.cut(unitGrid(16), {.quadrature = true});
  const auto& [volume, wall, normals, arc] = cells.quadrature;
  const auto field = [](const Vec3<double>& p) {
    return Vec3<double>{p.x * p.x * p.x, p.y * p.y * p.z, p.x * p.y * p.z};
  };
  std::vector<double> gaps;
  std::vector<double> volumes;
  for (std::uint32_t piece = 0; piece < cells.pieces.volume.size(); ++piece) {
    double sum = 0;
    double divergence = 0;
    for (std::size_t i = 0; i < volume.pointsOf(piece).size(); ++i) {
      const auto& p = volume.pointsOf(piece)[i];
      const double weight = volume.weightsOf(piece)[i];
      EXPECT_GT(weight, 0);
      sum += weight;
      divergence += weight * (3 * p.x * p.x + 2 * p.y * p.z + p.x * p.y);
    }
    double area = 0;
    for (std::size_t i = 0; i < wall.pointsOf(piece).size(); ++i) {
      const auto& normal = normals[wall.first[piece] + i];
      const double weight = wall.weightsOf(piece)[i];
      EXPECT_GT(weight, 0);
      EXPECT_NEAR(length(normal), 1, 1e-14);
      area += weight;
      divergence -= weight * dot(field(wall.pointsOf(piece)[i]), normal);
    }
    EXPECT_NEAR(sum, cells.pieces.volume[piece], 1e-16);
    EXPECT_NEAR(area, cells.pieces.wallArea[piece], 1e-15);
    gaps.push_back(divergence);
    volumes.push_back(sum);
  }
  for (std::uint32_t a = 0; a < cells.arcs.area.size(); ++a) {
    double sum = 0;
    double flux = 0;
    for (std::size_t i = 0; i < arc.pointsOf(a).size(); ++i) {
      sum += arc.weightsOf(a)[i];
      flux += arc.weightsOf(a)[i] * field(arc.pointsOf(a)[i])[cells.arcs.axis[a]];
    }
    EXPECT_NEAR(sum, cells.arcs.area[a], 1e-16);
    if (cells.arcs.below[a] < gaps.size()) gaps[cells.arcs.below[a]] -= flux;
    if (cells.arcs.above[a] < gaps.size()) gaps[cells.arcs.above[a]] += flux;
  }
  double worst = 0;
  for (std::uint32_t piece = 0; piece < cells.pieceCount; ++piece) {
    worst = std::max(worst, std::abs(gaps[piece]) * 16 * 16);
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_GT(cells.pieceCount, 300U);
  auto forged = cells;
  forged.quadrature.arc.weights.pop_back();
  EXPECT_THROW((void)toBytes(forged), Error);
  EXPECT_EQ(cutCellsFrom(toBytes(cells)).quadrature.wallNormals, normals);
}

TEST(SolidPiecesTest, CoarserCellsAreThoseCutDirectly) {
  const SolidCutter cutter(twoBalls());
  const auto coarse = coarsened(cutter.cut(unitGrid(24)), {2, 2, 2});
  const auto direct = cutter.cut(unitGrid(12));
  ASSERT_EQ(coarse.cells.index.size(), direct.cellCount);
  for (std::uint32_t row = 0; row < coarse.cellCount; ++row) {
    ASSERT_EQ(coarse.cells.index[row], direct.cells.index[row]);
    const double bound = 10 * (direct.cells.error[row] + coarse.cells.error[row]) + 1e-12;
    EXPECT_NEAR(fractionOf(coarse, row), fractionOf(direct, row), bound);
  }
}

TEST(SolidPiecesTest, FilesAndMergedCellsKeepTheirErrors) {
  const auto cells = SolidCutter(twoBalls()).cut(unitGrid(12));
  EXPECT_EQ(cells.cells.error.size(), cells.cells.index.size());
  const auto bytes = toBytes(cells);
  EXPECT_EQ(cutCellsFrom(bytes).cells.error, cells.cells.error);
  const auto [single, lost] = merged(cells);
  EXPECT_EQ(single.cells.error.size(), single.cells.index.size());
  auto forged = cells;
  forged.cells.error.pop_back();
  EXPECT_THROW((void)toBytes(forged), Error);
}

}  // namespace
}  // namespace cutwater::test
