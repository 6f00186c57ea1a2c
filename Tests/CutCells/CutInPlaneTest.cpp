#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "RandomVoxels.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

std::vector<double> evenly(int n, double from, double to) {
  std::vector<double> planes;
  for (int i = 0; i <= n; ++i) planes.push_back(from + (to - from) * i / n);
  return planes;
}

CellPlanes unitSquare(int n) {
  return cellsBetween({evenly(n, 0, 1), evenly(n, 0, 1), {0, 1}});
}

void expectSound(const CutCells& cells) {
  const auto report = check(cells);
  EXPECT_EQ(report.outOfRange, 0U);
  EXPECT_EQ(report.lostPieces, 0U);
  EXPECT_LT(report.worstClosure, 1e-13);
}

/// Of the section of a surface, by triangles; no vertex lies in the plane.
struct Section {
  double area = 0;
  double length = 0;
};
Section sectionOf(const PolygonSoup& soup, double z) {
  Section sum;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto t = soup.polygon(i);
    Vec3<double> up;
    Vec3<double> down;
    bool isCrossed = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = soup.points[t[k]];
      const auto& q = soup.points[t[(k + 1) % 3]];
      if ((p.z < z) == (q.z < z)) continue;
      isCrossed = true;
      (p.z < z ? up : down) = p + (z - p.z) / (q.z - p.z) * (q - p);
    }
    if (!isCrossed) continue;
    // The solid lies left of the way from where the triangle's rim goes up to where it goes down.
    sum.area += 0.5 * (down.x * up.y - down.y * up.x);
    sum.length += length(Vec3<double>{up.x - down.x, up.y - down.y, 0});
  }
  sum.area = std::abs(sum.area);
  return sum;
}

TEST(CutInPlaneTest, RectanglesTogetherAreTheSection) {
  Solid<double> solid(MeshSDF<double>(tessellation::torus(0.3, 0.1, 40, 20)));
  solid.rotate(33.0, Vec3<double>{1, 2, 3});
  solid.translate({0.51, 0.49, 0.47});
  auto soup = solid.as<MeshSDF<double>>()->soup();
  for (auto& p : soup.points) p = solid.placement().toWorld(p);
  for (const double z : {0.3, 0.45, 0.511}) {
    const auto section = sectionOf(soup, z);
    ASSERT_GT(section.area, 0.01);
    for (const int n : {1, 5, 8, 23, 64}) {
      for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
        const auto cells = CellCutter(solid, side).cutInPlane(unitSquare(n), z);
        expectSound(cells);
        const auto report = check(cells);
        const bool isOutside = side == FluidSide::Outside;
        EXPECT_NEAR(isOutside ? report.bodyVolume : report.fluidVolume, section.area, 1e-13);
        EXPECT_NEAR(report.wallArea, section.length, 1e-12);
      }
    }
  }
}

/// Voxels in one layer, and a grid of theirs or of another width.
VoxelSolid layerOfVoxels(std::mt19937& random) {
  VoxelSolid solid(1.0 / 16);
  const auto share = 20 + random() % 60;
  for (int x = 1; x < 12; ++x) {
    for (int y = 1; y < 12; ++y) {
      if (random() % 100 < share) solid.add({x, y, 1});
    }
  }
  solid.close(12);
  return solid;
}

/// Cells of one layer within a solid that is the same at all heights there.
TEST(CutInPlaneTest, PrismsAreCutAsCells) {
  std::mt19937 random(7);
  std::size_t multiple = 0;
  for (int n = 0; n < scaled(40); ++n) {
    const auto solid = layerOfVoxels(random);
    if (solid.count() == 0) continue;
    const double shift = n % 2 == 0 ? 0 : 0.013;
    const int count = n % 3 == 0 ? 16 : 11;
    const CellCutter cutter(Solid<double>(meshOf(solid)));
    const auto planes = evenly(count, shift, 1 + shift);
    const auto flat = cutter.cutInPlane(cellsBetween({planes, planes, {0, 1}}), 1.4 / 16);
    const auto layer = cutter.cut(cellsBetween({planes, planes, {1.25 / 16, 1.75 / 16}}));
    expectSound(flat);
    const double height = 0.5 / 16;
    ASSERT_EQ(flat.cellCount, layer.cellCount) << n;
    EXPECT_EQ(flat.bodyRuns, layer.bodyRuns);
    multiple += check(flat).multiPieceCells;
    for (std::uint32_t row = 0; row < flat.cellCount; ++row) {
      const auto first = flat.cells.firstPiece[row];
      const auto last = flat.cells.firstPiece[row + 1];
      ASSERT_EQ(flat.cells.index[row], layer.cells.index[row]) << n;
      ASSERT_EQ(first, layer.cells.firstPiece[row]) << n;
      ASSERT_EQ(last, layer.cells.firstPiece[row + 1]) << n;
      EXPECT_EQ(flat.cells.fluidCorners[row], layer.cells.fluidCorners[row]) << n;
      for (auto p = first; p < last; ++p) {
        const auto isSame = [&](std::uint32_t q) {
          return length(flat.pieces.centroid[p] - Vec3<double>{layer.pieces.centroid[q].x,
                                                               layer.pieces.centroid[q].y,
                                                               1.4 / 16}) < 1e-12 &&
                 std::abs(flat.pieces.volume[p] - layer.pieces.volume[q] / height) < 1e-14 &&
                 std::abs(flat.pieces.wallArea[p] - layer.pieces.wallArea[q] / height) < 1e-13;
        };
        bool isFound = false;
        for (auto q = first; q < last; ++q) isFound = isFound || isSame(q);
        EXPECT_TRUE(isFound) << n << ' ' << row;
      }
    }
    const auto across = std::ranges::count_if(layer.arcs.axis, [](auto axis) { return axis < 2; });
    EXPECT_EQ(flat.arcs.area.size(), static_cast<std::size_t>(across)) << n;
  }
  EXPECT_GT(multiple, 50U);
}

TEST(CutInPlaneTest, CoarserLevelsAndMergedCellsAreThoseOfThePlane) {
  std::mt19937 random(11);
  for (int n = 0; n < 10; ++n) {
    const auto solid = layerOfVoxels(random);
    if (solid.count() == 0) continue;
    const CellCutter cutter(Solid<double>(meshOf(solid)));
    const auto fine = cutter.cutInPlane(unitSquare(16), 1.5 / 16);
    const auto coarse = cutter.cutInPlane(unitSquare(8), 1.5 / 16);
    const auto joined = coarsened(fine, {2, 2, 1});
    expectSound(joined);
    EXPECT_EQ(joined.cells.index, coarse.cells.index);
    EXPECT_EQ(joined.cells.firstPiece, coarse.cells.firstPiece);
    EXPECT_NEAR(check(joined).bodyVolume, check(coarse).bodyVolume, 1e-14);
    const auto single = merged(coarse).cells;
    EXPECT_EQ(check(single).multiPieceCells, 0U);
    expectSound(single);
  }
}

TEST(CutInPlaneTest, AWallInALineOfTheGridBelongsToItsFluid) {
  // A square between lines: no film, and no slit beside it.
  const CellCutter cutter(
      Solid<double>(MeshSDF<double>(tessellation::box({0.25, 0.25, 0}, {0.75, 0.75, 1}))));
  for (const double z : {0.0, 0.5, 1.0}) {  // also in planes of its faces
    const auto cells = cutter.cutInPlane(unitSquare(8), z);
    expectSound(cells);
    const auto report = check(cells);
    EXPECT_EQ(report.bodyVolume, 0.25);
    EXPECT_EQ(report.wallArea, 2);
    EXPECT_EQ(report.cutCells, 16U);
    EXPECT_EQ(cells.classOf({2, 2, 0}), FluidClass::Body);
    EXPECT_EQ(cells.classOf({1, 1, 0}), FluidClass::Fluid);
    for (std::uint32_t p = 0; p < cells.pieceCount; ++p) EXPECT_EQ(cells.volumeFraction(p), 1);
  }
  EXPECT_EQ(check(cutter.cutInPlane(unitSquare(8), 1.001)).cutCells, 0U);
  EXPECT_EQ(check(cutter.cutInPlane(unitSquare(8), -1e-9)).cutCells, 0U);
}

TEST(CutInPlaneTest, CentroidsWeighAxiallySymmetricVolumes) {
  // A ring with a square section, about the y axis: by Pappus' theorem.
  const CellCutter cutter(
      Solid<double>(MeshSDF<double>(tessellation::box({0.3, 0.2, -1}, {0.7, 0.6, 1}))));
  const auto cells = cutter.cutInPlane(unitSquare(5), 0);
  double fluid = 0;
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) {
    fluid += 2 * std::numbers::pi * cells.pieces.centroid[p].x * cells.pieces.volume[p];
  }
  double whole = 0;
  for (int row = 0; row < 25; ++row) {
    const Index3 cell{row % 5, row / 5, 0};
    if (cells.classOf(cell) == FluidClass::Fluid) {
      whole += 2 * std::numbers::pi * cells.boxOf(cell).center().x * cells.cellVolume(cell);
    }
  }
  const double ring = std::numbers::pi * (0.49 - 0.09) * 0.4;
  EXPECT_NEAR(fluid + whole, std::numbers::pi - ring, 1e-13);
}

TEST(CutInPlaneTest, ThreadsAndBoxesGiveTheSameBits) {
  std::mt19937 random(3);
  const CellCutter cutter(Solid<double>(meshOf(randomVoxels(random))));
  const auto planes = evenly(37, 0.001, 0.9);
  const auto all = cutter.cutInPlane(cellsBetween({planes, planes, {0, 1}}), 0.31);
  const auto alone =
      cutter.cutInPlane(cellsBetween({planes, planes, {0, 1}}), 0.31, {.threads = 1});
  EXPECT_EQ(all.pieces.volume, alone.pieces.volume);
  const auto part =
      cutter.cutInPlane(cellsBetween({std::vector(planes.begin() + 5, planes.begin() + 22),
                                      std::vector(planes.begin() + 3, planes.begin() + 30),
                                      {0, 1}},
                                     {5, 3, 0}),
                        0.31);
  ASSERT_GT(part.cellCount, 50U);
  for (std::uint32_t row = 0; row < part.cellCount; ++row) {
    const auto same = all.rowOf(part.cells.index[row]);
    ASSERT_NE(same, CutCells::kNoRow);
    const auto p = part.cells.firstPiece[row];
    const auto q = all.cells.firstPiece[same];
    ASSERT_EQ(part.cells.firstPiece[row + 1] - p, all.cells.firstPiece[same + 1] - q);
    for (std::uint32_t n = 0; p + n < part.cells.firstPiece[row + 1]; ++n) {
      EXPECT_EQ(part.pieces.volume[p + n], all.pieces.volume[q + n]);
      EXPECT_EQ(part.pieces.centroid[p + n], all.pieces.centroid[q + n]);
    }
  }
}

TEST(CutInPlaneTest, RefusesWhatItCannotDo) {
  const CellCutter cutter(Solid<double>(MeshSDF<double>(tessellation::box({0, 0, 0}, {1, 1, 1}))));
  EXPECT_THROW((void)cutter.cutInPlane(unitSquare(4), 0.5, {.polygons = true}), Error);
  EXPECT_THROW((void)cutter.cutInPlane(unitSquare(4), 0.5, {.moments = 1}), Error);
  EXPECT_THROW((void)cutter.cutInPlane(unitSquare(4), 1e17), Error);
  EXPECT_THROW((void)cutter.cutInPlane(unitSquare(4), std::nan("")), Error);
}

}  // namespace
}  // namespace cutwater::test
