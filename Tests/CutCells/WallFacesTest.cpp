// CutCells::Cells::wallFaces and CutLeaves::Leaves::wallFaces.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/Grid/Octree.hpp>

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "CutCells/ShellCells.hpp"
#include "Support/Clipping.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// Whether a body of voxels with indices from 0 on has one.
using IsBody = std::function<bool(int x, int y, int z)>;

/// The faces of a box of voxels within which fluid lies, with body across.
unsigned facesOfVoxels(const Index3& first, int width, const IsBody& isBody) {
  unsigned faces = 0;
  const std::array lo{first.i, first.j, first.k};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      for (int n = 0; n < width * width; ++n) {
        std::array<int, 3> in = lo;
        in[axis] += side * (width - 1);
        in[(axis + 1) % 3] += n % width;
        in[(axis + 2) % 3] += n / width;
        auto across = in;
        across[axis] += side == 1 ? 1 : -1;
        if (!isBody(in[0], in[1], in[2]) && isBody(across[0], across[1], across[2])) {
          faces |= 1U << (2 * axis + static_cast<std::size_t>(side));
        }
      }
    }
  }
  return faces;
}

/// Cells of `width` voxels each.
void expectFacesOfVoxels(const CutCells& cells, int width, const IsBody& isBody) {
  const auto box = cells.grid.indices();
  for (int k = box.lo.k; k <= box.hi.k; ++k) {
    for (int j = box.lo.j; j <= box.hi.j; ++j) {
      for (int i = box.lo.i; i <= box.hi.i; ++i) {
        const auto row = cells.rowOf({i, j, k});
        const unsigned found = row == CutCells::kNoRow ? 0 : cells.cells.wallFaces[row];
        ASSERT_EQ(found, facesOfVoxels({i * width, j * width, k * width}, width, isBody))
            << i << " " << j << " " << k;
      }
    }
  }
  static_cast<void>(toBytes(cells));  // pieces have those of their cells
}

TEST(WallFacesTest, OfVoxelsAreWhereBodyIsAcross) {
  std::mt19937 random(5);
  for (int n = 0; n < scaled(10) && !HasFailure(); ++n) {
    const auto solid = randomVoxels(random);
    const CellCutter cutter{Solid<double>(meshOf(solid))};
    const auto isBody = [&](int x, int y, int z) { return solid.has({x, y, z}); };
    const double h = 1.0 / 16;
    const auto cells = cutter.cut(
        GridPatch<double>{Level<double>({0, 0, 0}, {h, h, h}), IndexBox::ofSize(12, 12, 12)});
    expectFacesOfVoxels(cells, 1, isBody);
    EXPECT_GT(check(cells).planeCells, 100U);
    for (const int ratio : {2, 3}) {
      const GridPatch<double> patch{Level<double>({0, 0, 0}, {ratio * h, ratio * h, ratio * h}),
                                    IndexBox::ofSize(12 / ratio, 12 / ratio, 12 / ratio)};
      expectFacesOfVoxels(cutter.cut(patch), ratio, isBody);
      expectFacesOfVoxels(coarsened(cells, {ratio, ratio, ratio}), ratio, isBody);
    }
    // Between planes of the grid, there are none.
    const auto beside = cutter.cut(GridPatch<double>{Level<double>({0.01, 0.01, 0.01}, {h, h, h}),
                                                     IndexBox::ofSize(11, 11, 11)});
    EXPECT_EQ(check(beside).planeCells, 0U);
  }
}

TEST(WallFacesTest, OfLeavesAreThoseOfTheirLevels) {
  std::mt19937 random(6);
  for (int n = 0; n < scaled(10) && !HasFailure(); ++n) {
    const auto solid = randomVoxels(random);
    const CellCutter cutter{Solid<double>(meshOf(solid))};
    const auto isBody = [&](int x, int y, int z) { return solid.has({x, y, z}); };
    const auto mesh = dividedMesh(random, 4, 0, 1);
    const auto leaves = cutter.cut(mesh);
    for (std::uint32_t leaf = 0; leaf < mesh.cells().size(); ++leaf) {
      const auto& index = mesh.cells()[leaf].index;
      const int level = mesh.cells()[leaf].level;
      const int width = 1 << (4 - level);
      const auto row = leaves.rowOf(leaf);
      const unsigned found = row == CutLeaves::kNoRow ? 0 : leaves.cut.wallFaces[row];
      ASSERT_EQ(found,
                facesOfVoxels({index.i * width, index.j * width, index.k * width}, width, isBody));
    }
    EXPECT_GT(check(leaves).planeCells, 10U);
  }
}

/// Boxes in planes half a cell apart, with fluid in small cells where none of them is.
TEST(WallFacesTest, OfBoxesThatMeetAreThoseOfTheirUnion) {
  std::mt19937 random(7);
  std::size_t meeting = 0;
  for (int n = 0; n < scaled(60) && !HasFailure(); ++n) {
    const auto boxes = randomBoxesInPlanes(random, 3, 8);
    const auto cells = cellsOfShells(soupOf(boxes), 4);
    meeting += check(cells).meetingCells;
    expectFacesOfVoxels(cells, 2, [&](int x, int y, int z) {
      const Vec3<double> p{(x + 0.5) / 8, (y + 0.5) / 8, (z + 0.5) / 8};
      return std::ranges::any_of(boxes, [&](const auto& box) { return box.contains(p); });
    });
  }
  EXPECT_GT(meeting, 100U);
}

/// The area that a triangle has in a cell of the plane, by clipping.
double areaIn(const std::vector<Vec3<double>>& triangle, int i, int j) {
  std::vector<std::array<double, 3>> part;
  for (const auto& p : triangle) part.push_back({p.x, p.y, p.z});
  for (const std::size_t axis : {0, 1}) {
    const double low = axis == 0 ? i : j;
    part = clipped(clipped(part, axis, low, 1), axis, low + 1, -1);
  }
  std::vector<Vec3<double>> polygon;
  for (const auto& [x, y, z] : part) polygon.push_back({x, y, z});
  return areaVector(polygon).z;
}

std::vector<Vec3<double>> randomTriangle(std::mt19937& random) {
  while (true) {
    std::vector<Vec3<double>> t;
    for (int i = 0; i < 3; ++i) {
      t.push_back(
          {0.5 * static_cast<double>(random() % 9), 0.5 * static_cast<double>(random() % 9), 0});
    }
    const double area = cross(t[1] - t[0], t[2] - t[0]).z;
    if (area < 0) std::swap(t[1], t[2]);
    if (area != 0) return t;
  }
}

CellPlanes unitCells() {
  return cellsBetween({{{-1, 0, 1, 2, 3, 4, 5}, {-1, 0, 1, 2, 3, 4, 5}, {-1, 0, 1, 2, 3}}},
                      {-1, -1, -1});
}

/// Corners and edges of the triangles are in planes, lines and nodes of the grid: cells that they
/// merely touch have no part of them.
TEST(WallFacesTest, BasesOfPrismsAreInTheFacesThatHaveAnAreaOfThem) {
  std::mt19937 random(8);
  for (int n = 0; n < scaled(200) && !HasFailure(); ++n) {
    const auto t = randomTriangle(random);
    const auto soup = prism({{t[0].x, t[0].y}, {t[1].x, t[1].y}, {t[2].x, t[2].y}}, 2);
    const CellCutter cutter(solidOf(soup));
    const auto cells = cutter.cut(unitCells());
    const auto wallIn = [&](const Index3& cell, unsigned bit) {
      const auto row = cells.rowOf(cell);
      return row != CutCells::kNoRow && (cells.cells.wallFaces[row] >> bit & 1U) != 0;
    };
    for (int number = 0; number < 36; ++number) {
      const int i = number % 6 - 1;
      const int j = number / 6 - 1;
      const bool isCovered = areaIn(t, i, j) > 1e-9;
      ASSERT_EQ(wallIn({i, j, -1}, 5), isCovered) << i << " " << j;
      ASSERT_EQ(wallIn({i, j, 2}, 4), isCovered) << i << " " << j;
    }
    // The section has the sides of the prism, whether it lies in a plane of the grid or not.
    for (const double z : {0.5, 1.0}) {
      const auto flat = cutter.cutInPlane(unitCells(), z);
      for (std::uint32_t row = 0; row < flat.cellCount; ++row) {
        auto cell = flat.cells.index[row];
        cell.k = 0;
        const auto same = cells.rowOf(cell);
        ASSERT_NE(same, CutCells::kNoRow);
        ASSERT_EQ(flat.cells.wallFaces[row], cells.cells.wallFaces[same] & 0xfU);
      }
    }
  }
}

/// Those across the faces of a box; not those at its edges and corners.
TEST(WallFacesTest, CellsAroundABoxInPlanesAreTouchedOnly) {
  const std::vector<double> planes{-0.3, 0.1, 0.4, 0.77, 1.3, 1.9};
  const auto grid = cellsBetween({planes, planes, planes});
  const auto soup = tessellation::box({0.1, 0.1, 0.1}, {0.77, 0.77, 0.77});
  const CellCutter cutter(solidOf(soup));
  const auto cells = cutter.cut(grid);
  ASSERT_EQ(cells.cellCount, 24U);
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    const auto [i, j, k] = cells.cells.index[row];
    int beside = 0;
    for (const int n : {i, j, k}) beside += n == 0 || n == 3 ? 1 : 0;
    EXPECT_EQ(beside, 1);
    EXPECT_TRUE(cells.isTouchedOnly(row));
  }
  EXPECT_EQ(check(cells).touchedCells, 24U);
  for (const Index3& edge : {Index3{0, 0, 1}, Index3{3, 3, 3}}) {
    EXPECT_EQ(cells.rowOf(edge), CutCells::kNoRow);
    EXPECT_EQ(cells.classOf(edge), FluidClass::Fluid);
  }
  // From within, each cell of the box is.
  EXPECT_EQ(check(CellCutter(solidOf(soup), FluidSide::Inside).cut(grid)).touchedCells, 8U);
  // Not with a body in the cell as well, nor with a wall between planes; but beside that.
  const auto pin = tessellation::box({0.3, 0.8, 0.3}, {0.35, 0.9, 0.35});
  EXPECT_EQ(check(CellCutter(solidOf(joined({soup, pin}))).cut(grid)).touchedCells, 23U);
  const auto high = tessellation::box({0.1, 0.1, 0.1}, {0.77, 0.77, 0.8});
  EXPECT_EQ(check(CellCutter(solidOf(high)).cut(grid)).touchedCells, 24U - 4U + 8U);
  const auto ulp = tessellation::box({0.1, 0.1, 0.1}, {0.77, 0.77, std::nextafter(0.77, 1.0)});
  const auto above = CellCutter(solidOf(ulp)).cut(grid);
  ASSERT_NE(above.rowOf({1, 1, 3}), CutCells::kNoRow);
  EXPECT_FALSE(above.isTouchedOnly(above.rowOf({1, 1, 3})));
}

TEST(WallFacesTest, LeavesAroundABoxInPlanesAreTouchedOnly) {
  const auto soup = tessellation::box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
  const Octree<double> mesh(solidOf(soup), OctreeDomain<double>({0, 0, 0}, 0.25, {4, 4, 4}),
                            {.cut = 0});
  const auto leaves = CellCutter(solidOf(soup)).cut(mesh);
  EXPECT_EQ(check(leaves).touchedCells, 24U);
  for (std::uint32_t row = 0; row < leaves.cut.leaf.size(); ++row) {
    EXPECT_TRUE(leaves.isTouchedOnly(row));
  }
}

TEST(WallFacesTest, OneUlpOffThePlaneIsNotInIt) {
  for (const double x : {1.0, std::nextafter(1.0, 2.0), std::nextafter(1.0, 0.0)}) {
    const CellCutter cutter(solidOf(tessellation::box({0.25, 0.25, 0.25}, {x, 1.75, 1.75})));
    const auto cells = cutter.cut(cellsBetween({{{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}}));
    const auto row = cells.rowOf({1, 0, 0});
    const auto faces = row == CutCells::kNoRow ? 0 : cells.cells.wallFaces[row];
    EXPECT_EQ(faces, x == 1.0 ? 1 : 0);
    EXPECT_EQ(check(cells).planeCells, x == 1.0 ? 4U : 0U);
    // An open patch is no wall.
    if (x != 1.0) continue;
    auto soup = tessellation::box({0.25, 0.25, 0.25}, {x, 1.75, 1.75});
    soup.patchNames = {"walls", "outlet"};
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      const auto p = soup.polygon(i);
      const bool isLast = std::ranges::all_of(p, [&](auto c) { return soup.points[c].x == x; });
      soup.patches[i] = isLast ? 1 : 0;
    }
    const CellCutter open(solidOf(soup), FluidSide::Outside, {.openPatches = {"outlet"}});
    EXPECT_EQ(check(open.cut(cells.grid)).planeCells, 0U);
  }
}

TEST(WallFacesTest, OfMergedCellsAreThoseOfThePiecesThatAreLeftAndOfClosedFaces) {
  // A plate across all cells, and a box below it, with a side in a plane of the grid.
  const CellCutter cutter(solidOf(joined({tessellation::box({-2, -2, 0.375}, {3, 3, 0.5}),
                                          tessellation::box({1, -1, 0.0625}, {2, 2, 0.25})})));
  const auto cells =
      cutter.cut(cellsBetween({{{-1, 0, 1, 2}, {-1, 0, 1, 2}, {-1, 0, 1, 2}}}, {-1, -1, -1}));
  const auto own = cells.cells.wallFaces[cells.rowOf({0, 0, 0})];
  EXPECT_EQ(own, 0b10);
  const auto single = merged(cells).cells;
  const auto facesOf = [&](const Index3& cell) {
    return int{single.cells.wallFaces[single.rowOf(cell)]};
  };
  EXPECT_EQ(facesOf({0, 0, 0}), 0);            // the half above the plate is left
  EXPECT_EQ(facesOf({0, 0, -1}), 0b10'00'00);  // that below it was closed
  EXPECT_EQ(check(single).planeCells, 9U);
  static_cast<void>(toBytes(single));
}

}  // namespace
}  // namespace cutwater::test
