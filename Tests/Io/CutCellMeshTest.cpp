#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

PolygonSoup ball() {
  auto soup = tessellation::icosphere(0.31, 2);
  for (auto& p : soup.points) p += {0.52, 0.49, 0.5};
  soup.patchNames = {"lower", "upper"};
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    soup.patches[i] = soup.points[soup.polygon(i)[0]].z > 0.5 ? 1 : 0;
  }
  return soup;
}

CutCells cutBall(bool withPolygons) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(ball()))};
  return cutter.cut(
      GridPatch<double>{Level<double>({0, 0, 0}, {0.25, 0.25, 0.25}), IndexBox::ofSize(4, 4, 4)},
      {.polygons = withPolygons});
}

template <typename Number>
const std::vector<Number>& numbersOf(const PointData& data, const std::string& name) {
  const auto array = std::ranges::find(data.cellArrays, name, &DataArray::name);
  return std::get<std::vector<Number>>(array->numbers);
}

/// The volume within the faces of polyhedron `cell`, by the divergence theorem.
double volumeOf(const PointData& data, std::size_t cell) {
  const auto& faces = data.cells.faces;
  auto at = cell == 0 ? 0 : static_cast<std::size_t>(data.cells.faceEnds[cell - 1]);
  auto left = faces[at++];
  double volume = 0;
  std::set<std::uint64_t> corners;
  for (; left > 0; --left) {
    const auto size = faces[at++];
    const auto& a = data.points[faces[at]];
    for (std::uint64_t k = 0; k < size; ++k) corners.insert(faces[at + k]);
    for (std::uint64_t k = 2; k < size; ++k) {
      volume += dot(a, cross(data.points[faces[at + k - 1]], data.points[faces[at + k]])) / 6;
    }
    at += size;
  }
  EXPECT_EQ(at, static_cast<std::size_t>(data.cells.faceEnds[cell]));
  const auto listed = data.cells.cell(cell);
  EXPECT_TRUE(std::ranges::equal(corners, listed));
  return volume;
}

TEST(CutCellMeshTest, HasAPolyhedronForEachPiece) {
  const auto cells = cutBall(true);
  const auto mesh = cutCellMesh(cells);
  ASSERT_EQ(mesh.cells.count(), cells.pieceCount);
  ASSERT_GT(cells.pieceCount, 20U);
  const auto& volumes = numbersOf<double>(mesh, "volume");
  for (std::size_t i = 0; i < mesh.cells.count(); ++i) {
    EXPECT_EQ(mesh.cells.kinds[i], 42);
    EXPECT_EQ(volumes[i], cells.pieces.volume[i]);
    EXPECT_NEAR(volumeOf(mesh, i), volumes[i], 1e-15);
  }
  auto points = mesh.points;
  std::ranges::sort(points, {}, [](const auto& p) { return std::tuple(p.x, p.y, p.z); });
  EXPECT_EQ(std::ranges::adjacent_find(points), points.end());
}

TEST(CutCellMeshTest, WholeCellsComplementIt) {
  const auto cells = cutBall(true);
  const auto mesh = cutCellMesh(cells, true);
  const auto& volumes = numbersOf<double>(mesh, "volume");
  double sum = 0;
  for (const double volume : volumes) sum += volume;
  EXPECT_NEAR(sum, check(cells).fluidVolume, 1e-14);
  EXPECT_EQ(std::ranges::count(mesh.cells.kinds, 12), 64 - static_cast<int>(cells.cellCount));
  const auto& cell = numbersOf<std::int32_t>(mesh, "cell");
  for (std::size_t i = cells.pieceCount; i < mesh.cells.count(); ++i) {
    const auto box = cells.boxOf({cell[3 * i], cell[3 * i + 1], cell[3 * i + 2]});
    EXPECT_EQ(mesh.points[mesh.cells.cell(i)[0]], box.lower);
    EXPECT_EQ(mesh.points[mesh.cells.cell(i)[6]], box.upper);
    EXPECT_EQ(mesh.cells.faceEnds[i], -1);
  }
}

TEST(CutCellMeshTest, ComesBackFromAFile) {
  const TemporaryFolder folder;
  const auto mesh = cutCellMesh(cutBall(true), true);
  writePointData(folder.path() / "cells.vtu", mesh);
  const auto back = readPointData(folder.path() / "cells.vtu");
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.cells, mesh.cells);
  EXPECT_EQ(back.cellArrays, mesh.cellArrays);
  const auto& patch = numbersOf<std::int32_t>(mesh, "patch");
  for (const int wanted : {-1, 0, 1}) EXPECT_GT(std::ranges::count(patch, wanted), 4) << wanted;
  EXPECT_EQ(mesh.patchNames, (std::vector<std::string>{"lower", "upper"}));
}

Octree<double> treeAroundBall() {
  // The ball is finer below: faces between levels are in it.
  const Solid<double> lower(MeshSDF<double>(tessellation::icosphere(0.1, 1)));
  Solid<double> placed = lower;
  placed.translate({0.52, 0.49, 0.2});
  const OctreeDomain<double> domain({0, 0, 0}, 0.25, {4, 4, 4});
  Refinement<double> rules;
  rules.cut = 2;
  return Octree<double>(placed, domain, rules);
}

TEST(CutCellMeshTest, HasAPolyhedronForEachPieceOfALeaf) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(ball()))};
  const auto tree = treeAroundBall();
  const auto leaves = cutter.cut(tree, {.polygons = true});
  const auto mesh = cutCellMesh(leaves, tree, true);
  const auto pieces = leaves.pieces.cell.size();
  const auto& volumes = numbersOf<double>(mesh, "volume");
  const auto& levels = numbersOf<std::int32_t>(mesh, "level");
  const auto& leaf = numbersOf<std::int32_t>(mesh, "leaf");
  const auto& cell = numbersOf<std::int32_t>(mesh, "cell");
  double sum = 0;
  for (std::size_t i = 0; i < mesh.cells.count(); ++i) {
    sum += volumes[i];
    const auto& of = tree.cells()[static_cast<std::size_t>(leaf[i])];
    EXPECT_EQ(levels[i], of.level);
    EXPECT_EQ((Index3{cell[3 * i], cell[3 * i + 1], cell[3 * i + 2]}), of.index);
    EXPECT_EQ(mesh.cells.kinds[i], i < pieces ? 42 : 12);
    if (i < pieces) {
      EXPECT_NEAR(volumeOf(mesh, i), leaves.pieces.volume[i], 1e-15);
    } else {
      EXPECT_EQ(mesh.points[mesh.cells.cell(i)[0]], tree.box(of).lower);
      EXPECT_EQ(mesh.points[mesh.cells.cell(i)[6]], tree.box(of).upper);
    }
  }
  EXPECT_NEAR(sum, check(leaves).fluidVolume, 1e-14);
  const auto cut = std::span(levels).first(pieces);
  for (const int level : {0, 1, 2}) EXPECT_GT(std::ranges::count(cut, level), 4) << level;
  const Octree<double> other(Solid<double>(MeshSDF<double>(ball())), tree.domain(),
                             Refinement<double>{});
  EXPECT_THROW(static_cast<void>(cutCellMesh(leaves, other)), Error);
}

TEST(CutCellMeshTest, NeedsPolygons) {
  EXPECT_THROW(static_cast<void>(cutCellMesh(cutBall(false))), Error);
  EXPECT_EQ(cutCellMesh(CutCells{}).cells.count(), 0U);
}

}  // namespace
}  // namespace cutwater::test
