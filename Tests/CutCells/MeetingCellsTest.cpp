// Surfaces whose shells overlap, repeat or pass through themselves.

#include <chrono>
#include <limits>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/ShellCells.hpp"
#include "CutCells/Tetrahedra.hpp"
#include "Support/CutIdentities.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// Compares the volume of each cell and the open area of each face with inclusion and exclusion.
void expectUnion(const std::vector<Box<double>>& boxes, int n, std::size_t& meeting) {
  const auto cells = cellsOfShells(soupOf(boxes), n);
  expectClosed(cells);
  meeting += check(cells).meetingCells;
  std::map<std::pair<std::array<int, 3>, int>, double> open;
  const auto key = [](const Index3& index, int axis) {
    return std::pair(std::array<int, 3>{index.i, index.j, index.k}, axis);
  };
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    open[key(cells.arcs.cell[a], cells.arcs.axis[a])] += cells.arcs.area[a];
  }
  for (int number = 0; number < n * n * n; ++number) {
    const Index3 cell{number % n, number / n % n, number / n / n};
    const auto box = cells.boxOf(cell);
    const auto row = cells.rowOf(cell);
    double fluid = cells.classOf(cell) == FluidClass::Fluid ? cells.cellVolume(cell) : 0;
    if (row != CutCells::kNoRow) {
      for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
        fluid += cells.pieces.volume[p];
      }
    }
    ASSERT_NEAR(fluid, cells.cellVolume(cell) - covered(box, boxes), 1e-14);
    if (row == CutCells::kNoRow) continue;
    for (int axis = 0; axis < 3; ++axis) {
      // Walls in the face's plane close it, whatever side they bound.
      auto face = box;
      face.upper[axis] = face.lower[axis];
      EXPECT_NEAR(open[key(cell, axis)], cells.faceArea(cell, axis) - covered(face, boxes, axis),
                  1e-14);
    }
  }
}

TEST(MeetingCellsTest, UnionsOfBoxesAreThoseOfInclusionAndExclusion) {
  std::mt19937 random(3);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(60) && !HasFailure(); ++round) {
    expectUnion(randomBoxes(random, 2 + round % 3), 1 + round % 5, meeting);
  }
  EXPECT_GT(meeting, 100U);
}

/// Faces lie on one another and in planes of the grid.
TEST(MeetingCellsTest, UnionsOfBoxesInPlanesOfTheGridAreThoseOfInclusionAndExclusion) {
  std::mt19937 random(4);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(200) && !HasFailure(); ++round) {
    expectUnion(randomBoxesInPlanes(random, 2 + round % 3, 9),
                std::array{1, 2, 3, 9}[static_cast<std::size_t>(round) % 4], meeting);
  }
  EXPECT_GT(meeting, 100U);
}

/// A plate through a cell, of two boxes that overlap in its middle, parts it; patches keep their
/// walls.
TEST(MeetingCellsTest, PiecesAndPatchesAreThoseOfTheUnion) {
  const auto left = tessellation::box({-0.5, -0.5, 0.4}, {0.7, 1.5, 0.5});
  const auto right = tessellation::box({0.3, -0.5, 0.35}, {1.5, 1.5, 0.45});
  auto both = joined({left, right});
  both.patchNames = {"left", "right"};
  for (std::size_t i = left.polygonCount(); i < both.polygonCount(); ++i) both.patches[i] = 1;
  const auto cells = cellsOfShells(both, 1);
  expectClosed(cells);
  ASSERT_EQ(cells.pieceCount, 2U);
  EXPECT_EQ(check(cells).meetingCells, 1U);
  const auto [below, above] = std::minmax(cells.pieces.volume[0], cells.pieces.volume[1]);
  EXPECT_NEAR(below, 0.3 * 0.4 + 0.7 * 0.35, 1e-15);
  EXPECT_NEAR(above, 0.7 * 0.5 + 0.3 * 0.55, 1e-15);
  std::array<double, 2> areas{};
  for (std::size_t w = 0; w < cells.wallParts.area.size(); ++w) {
    if (cells.wallParts.piece[w] >= cells.pieceCount) continue;
    areas[cells.wallParts.patch[w]] += cells.wallParts.area[w];
  }
  EXPECT_NEAR(areas[0], 0.7 + 0.05 + 0.3, 1e-15);  // top, end, and bottom beside the right one
  EXPECT_NEAR(areas[1], 0.7 + 0.05 + 0.3, 1e-15);
  EXPECT_EQ(cells.arcs.area.size(), 2U + 4 * 2);
}

/// A shell twice, and one that passes through itself.
TEST(MeetingCellsTest, ShellsThatRepeatOrCrossThemselvesCount) {
  const auto one = ball(0.4, kMiddle, 1);
  for (const int n : {1, 4}) {
    const auto cells = cellsOfShells(joined({one, one}), n);
    expectClosed(cells);
    EXPECT_NEAR(check(cells).bodyVolume, volumeOf(one), 1e-14);
    EXPECT_NEAR(check(cells).wallArea, areaOf(one), 1e-13);
  }
  // A prism over a figure of eight: one loop has the winding number 1, the other -1.
  PolygonSoup eight;
  for (const double z : {0.3, 0.7}) {
    for (const auto& [x, y] : {std::pair(0.2, 0.2), {0.8, 0.8}, {0.8, 0.2}, {0.2, 0.8}}) {
      eight.points.push_back({x, y, z});
    }
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto next = (i + 1) % 4;
    eight.addPolygon(std::array{i, next, next + 4});
    eight.addPolygon(std::array{i, next + 4, i + 4});
  }
  for (std::uint32_t i = 1; i < 3; ++i) {
    eight.addPolygon(std::array{0U, i + 1, i});
    eight.addPolygon(std::array{4U, i + 4, i + 5});
  }
  const auto cells = cellsOfShells(eight, 3);
  expectClosed(cells);
  EXPECT_NEAR(check(cells).bodyVolume, 0.09 * 0.4, 1e-15);
}

TEST(MeetingCellsTest, CoarserCellsAreThoseOfTheUnion) {
  const auto both = joined({ball(0.3, {0.35, 0.4, 0.5}, 2), ball(0.3, {0.6, 0.6, 0.5}, 2)});
  const auto fine = cellsOfShells(both, 16);
  const auto coarse = coarsened(fine, {4, 4, 4});
  const auto expected = cellsOfShells(both, 4);
  expectClosed(coarse);
  EXPECT_EQ(coarse.cells.index, expected.cells.index);
  EXPECT_EQ(coarse.cells.firstPiece, expected.cells.firstPiece);
  EXPECT_EQ(coarse.cells.meets, expected.cells.meets);
  EXPECT_NEAR(check(coarse).wallArea, check(expected).wallArea, 1e-13);
  const auto single = merged(fine);
  double lost = 0;
  for (const auto& piece : single.lost) lost += piece.volume;
  EXPECT_NEAR(check(single.cells).bodyVolume, check(fine).bodyVolume + lost, 1e-14);
}

/// No piece without volume has an open part of a face.
void expectNoFilms(const CutCells& cells) {
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    if (cells.arcs.area[a] < 1e-9) continue;
    for (const auto piece : {cells.arcs.below[a], cells.arcs.above[a]}) {
      if (piece >= cells.pieceCount) continue;
      EXPECT_GT(cells.pieces.volume[piece], 1e-12);
    }
  }
}

/// Corners are nodes of the grid or halfway between these, so edges and triangles lie in its planes
/// and lines, and touch there. All tetrahedra have a corner in common.
TEST(MeetingCellsTest, BothSidesOfTetrahedraFillAllCells) {
  std::mt19937 random(5);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(100) && !HasFailure(); ++round) {
    const auto corner = [&] { return 0.5 + 0.5 * static_cast<double>(random() % 7); };
    const auto point = [&] { return Vec3<double>{corner(), corner(), corner()}; };
    const auto common = point();
    PolygonSoup soup;
    for (int left = 1 + round % 3; left > 0;) {
      const auto one = tetrahedronOf({common, point(), point(), point()});
      if (volumeOf(one) == 0) continue;
      soup = joined({soup, one});
      --left;
    }
    const double width = std::array{0.5, 1.0, 2.0}[static_cast<std::size_t>(round) / 3 % 3];
    std::vector<double> planes;
    for (int n = 0; n * width <= 4.5; ++n) planes.push_back(n * width);
    const auto grid = cellsBetween({planes, planes, planes});
    const auto solid = solidOf(soup);
    const auto outside = CellCutter(solid).cut(grid, {.moments = 1});
    const auto inside = CellCutter(solid, FluidSide::Inside).cut(grid, {.moments = 1});
    for (const auto& cells : {outside, inside}) {
      expectClosed(cells);
      expectNoFilms(cells);
      EXPECT_LT(check(cells).worstMoments, 1e-12);
    }
    meeting += check(outside).meetingCells;
    const auto box = grid.indices();
    for (std::uint32_t n = 0; n < box.count(); ++n) {
      const auto side = static_cast<std::uint32_t>(planes.size() - 1);
      const auto cell = box.at(n % side, n / side % side, n / side / side);
      ASSERT_NEAR(fluidIn(outside, cell) + fluidIn(inside, cell), outside.cellVolume(cell), 1e-13);
    }
  }
  EXPECT_GT(meeting, 500U);
}

/// The least of some times that one cell around two balls takes.
double secondsOfOneCell(int level, int times) {
  const CellCutter cutter(
      solidOf(joined({ball(0.3, {0.35, 0.4, 0.51}, level), ball(0.27, {0.6, 0.62, 0.48}, level)})));
  const GridPatch<double> cell{Level<double>({0, 0, 0}, {1, 1, 1}), IndexBox::ofSize(1, 1, 1)};
  double least = std::numeric_limits<double>::infinity();
  for (int n = 0; n < times; ++n) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(check(cutter.cut(cell)).meetingCells, 1U);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    least = std::min(least, time.count());
  }
  return least;
}

/// 16 times the triangles take about 16 times as long; if all of them were looked at from each part
/// of the cell, 100 times.
TEST(MeetingCellsTest, CrowdedCellsTakeATimeInProportion) {
  EXPECT_LT(secondsOfOneCell(4, 3), 40 * secondsOfOneCell(2, 8));
}

}  // namespace
}  // namespace cutwater::test
