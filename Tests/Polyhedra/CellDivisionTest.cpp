#include <Cutwater/Polyhedra/Detail/CellDivision.hpp>

#include <gtest/gtest.h>

#include "Bricks.hpp"

namespace cutwater::test {
namespace {

TEST(CellDivisionTest, APlaneDividesACellInTwo) {
  EditedMesh mesh(brick({2, 1, 1}));
  const auto behind = divideCell(mesh, 0, {.point = {0.25, 0, 0}, .normal = {1, 0, 0}});
  ASSERT_EQ(behind, 2U);
  const auto divided = std::move(mesh).take();
  expectClosed(divided);
  EXPECT_EQ(divided.cells.volume, (std::vector<double>{0.25, 0.75, 1}));
  EXPECT_EQ(check(divided).meshVolume, 2);
  EXPECT_EQ(divided.faces.neighbour.size(), 2U);
}

/// What the normal looks into is behind; neighbours' faces get the points on edges.
TEST(CellDivisionTest, EdgesGoThroughNewPointsInAllCells) {
  EditedMesh mesh(brick({2, 2, 1}));
  const auto behind = divideCell(mesh, 0, {.point = {0, 0, 0.75}, .normal = {0, 0, 1}});
  ASSERT_TRUE(behind);
  const auto divided = std::move(mesh).take();
  expectClosed(divided);
  EXPECT_EQ(check(divided).openCells, 0U);
  EXPECT_EQ(divided.cells.volume[0], 0.75);
  EXPECT_EQ(divided.points.size(), 18U + 4);
}

TEST(CellDivisionTest, WhatDoesNotDivideItLeavesTheMesh) {
  const auto before = brick({2, 1, 1});
  EditedMesh mesh(before);
  EXPECT_FALSE(divideCell(mesh, 0, {.point = {1, 0, 0}, .normal = {1, 0, 0}}));
  EXPECT_FALSE(divideCell(mesh, 0, {.point = {0.00005, 0, 0}, .normal = {1, 0, 0}, .near = 0}));
  EXPECT_FALSE(divideCell(mesh, 0, {.point = {5, 0, 0}, .normal = {0, 1, 1}}));
  expectSame(std::move(mesh).take(), before);
}

/// Corners near the plane are in it: no slivers beside them.
TEST(CellDivisionTest, CornersNearThePlaneAreInIt) {
  EditedMesh mesh(brick({1, 1, 1}));
  const DividingPlane plane{.point = {0.5, 0.5, 0.5}, .normal = {1, -0.98, 0}, .near = 0.05};
  ASSERT_TRUE(divideCell(mesh, 0, plane));
  const auto divided = std::move(mesh).take();
  EXPECT_EQ(divided.points.size(), 8U);
  EXPECT_EQ(divided.cells.volume, (std::vector<double>{0.5, 0.5}));
}

/// The plane of one wall of a corner takes the other one apart from it.
TEST(CellDivisionTest, PlanesOfWallsMakeConvexParts) {
  EditedMesh mesh(brick({2, 2, 1}));
  const auto both = mesh.join(mesh.join(0, 1), 2);  // around the edge of the last cell
  std::size_t good = 0;
  for (const auto& plane : dividingPlanes(mesh, both)) {
    mesh.begin();
    if (const auto behind = divideCell(mesh, both, plane)) {
      const double volume = mesh.mesh().cells.volume[*behind];
      good += std::abs(volume - 1) < 1e-12 || std::abs(volume - 2) < 1e-12 ? 1 : 0;
    }
    mesh.undo();
  }
  EXPECT_GE(good, 2U);
}

}  // namespace
}  // namespace cutwater::test
