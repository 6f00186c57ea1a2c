#include <Cutwater/Polyhedra/Detail/CellChange.hpp>
#include <Cutwater/Polyhedra/Detail/CellDivision.hpp>
#include <Cutwater/Polyhedra/Detail/EditedMesh.hpp>

#include <gtest/gtest.h>

#include "Bricks.hpp"

namespace cutwater::test {
namespace {

TEST(EditedMeshTest, TwoCellsBecomeTheFirst) {
  EditedMesh mesh(brick({3, 1, 1}));
  EXPECT_EQ(mesh.join(2, 1), 1U);
  const auto joined = std::move(mesh).take();
  expectClosed(joined);
  EXPECT_EQ(joined.cells.volume, (std::vector<double>{1, 2}));
  EXPECT_EQ(joined.joinedPieces, 1U);
  EXPECT_EQ(joined.faces.neighbour.size(), 1U);
}

TEST(EditedMeshTest, WhatIsTriedCanBeUndone) {
  const auto before = brick({3, 2, 1});
  EditedMesh mesh(before);
  for (const bool divides : {false, true}) {
    mesh.begin();
    const auto both = mesh.join(0, 1);
    if (divides) {
      ASSERT_TRUE(divideCell(mesh, both, {.point = {0.5, 0, 0}, .normal = {1, 0, 0}}));
    }
    EXPECT_TRUE(mesh.isChangedCell(both));
    EXPECT_TRUE(mesh.isChangedCell(1));
    EXPECT_FALSE(mesh.isChangedCell(5));
    mesh.undo();
    EXPECT_FALSE(mesh.isChangedCell(both));
  }
  mesh.begin();
  const auto third = divideCell(mesh, 5, {.point = {2.5, 0, 0}, .normal = {1, 0, 0}});
  mesh.keep();
  EXPECT_EQ(third, 6U);
  mesh.begin();
  static_cast<void>(mesh.join(5, 6));
  mesh.undo();
  EXPECT_EQ(mesh.facesOf(6).size(), 6U);
  expectSame(EditedMesh(before).take(), before);
}

/// Two faces of a cell to the same neighbour, and two walls.
TEST(EditedMeshTest, FacesOfOneCellBecomeOne) {
  EditedMesh mesh(brick({2, 2, 1}));
  const auto column = mesh.join(1, 3);
  const auto other = mesh.join(0, 2);
  std::vector<std::uint32_t> between;
  for (const auto face : mesh.facesOf(column)) {
    if (mesh.face(face).across(column) == other) between.push_back(face);
  }
  ASSERT_EQ(between.size(), 2U);
  EXPECT_TRUE(mesh.joinFaces(between[0], between[1]));
  EXPECT_EQ(mesh.face(between[0]).loop.size(), 6U);
  const auto joined = std::move(mesh).take();
  expectClosed(joined);
  EXPECT_EQ(joined.faces.neighbour.size(), 1U);
}

/// A line between two corners makes two of a wall, but not where an edge is.
TEST(EditedMeshTest, AWallBecomesTwo) {
  EditedMesh mesh(brick({1, 1, 1}));
  const auto wall = mesh.facesOf(0).front();
  const auto loop = mesh.face(wall).loop;
  CellChange change{.kind = CellChange::Kind::DivideWall,
                    .cell = 0,
                    .other = wall,
                    .corners = {loop[0], loop[2]}};
  EXPECT_EQ(apply(change, mesh), std::vector<std::uint32_t>{0});
  EXPECT_EQ(mesh.facesOf(0).size(), 7U);
  change.other = mesh.facesOf(0)[1];
  EXPECT_TRUE(apply(change, mesh).empty());
  const auto divided = std::move(mesh).take();
  expectClosed(divided);
  EXPECT_EQ(check(divided).meshVolume, 1);
}

/// A fin without volume: a cell has a face to another one, and a wall that is the same face seen
/// from the other side. Without them, the wall is the other cell's.
TEST(EditedMeshTest, AFoldBetweenACellAndAWall) {
  auto mesh = EditedMesh(brick({3, 1, 1}));
  const auto wallOfLast = [&] {
    for (const auto face : mesh.facesOf(2)) {
      if (mesh.face(face).other == EditedMesh::kNone && mesh.face(face).patch == 1) return face;
    }
    return EditedMesh::kNone;
  };
  const auto wall = wallOfLast();
  ASSERT_NE(wall, EditedMesh::kNone);
  auto front = mesh.face(wall);
  auto back = front;
  // The wall was beyond a fin of cell 0 that covers it.
  mesh.removeFace(wall);
  front.other = 0;
  back.cell = 0;
  const auto numbers = static_cast<std::uint32_t>(mesh.mesh().faces.count());
  mesh.addFace(front);
  mesh.addFace(back);
  EXPECT_FALSE(mesh.closeFold(0, numbers, mesh.facesOf(0).front()));
  EXPECT_TRUE(mesh.closeFold(0, numbers, numbers + 1));
  expectSame(std::move(mesh).take(), brick({3, 1, 1}));
}

}  // namespace
}  // namespace cutwater::test
