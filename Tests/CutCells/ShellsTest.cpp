// Surfaces of several shells: nested, touching, inside out and overlapping.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "Support/Scale.hpp"
#include "Support/Shells.hpp"

namespace cutwater::test {
namespace {

Solid<double> solidOf(const PolygonSoup& soup) {
  return Solid<double>(MeshSDF<double>(soup));
}

CutCells cellsOfShells(const PolygonSoup& soup, int n, FluidSide side = FluidSide::Outside,
                       const CutOptions& options = {}) {
  return CellCutter(solidOf(soup), side)
      .cut(GridPatch<double>{Level<double>({0, 0, 0}, {1.0 / n, 1.0 / n, 1.0 / n}),
                             IndexBox::ofSize(n, n, n)},
           options);
}

void expectClosed(const CutCells& cells) {
  const auto report = check(cells);
  EXPECT_EQ(report.outOfRange, 0U);
  EXPECT_EQ(report.lostPieces, 0U);
  EXPECT_LT(report.worstClosure, 1e-13);
}

/// The same cells, pieces and arcs, but for rounding.
void expectSame(const CutCells& found, const CutCells& expected) {
  EXPECT_EQ(found.cells.index, expected.cells.index);
  EXPECT_EQ(found.cells.firstPiece, expected.cells.firstPiece);
  EXPECT_EQ(found.cells.fluidCorners, expected.cells.fluidCorners);
  EXPECT_EQ(found.bodyRuns, expected.bodyRuns);
  EXPECT_EQ(found.arcs.below, expected.arcs.below);
  EXPECT_EQ(found.arcs.above, expected.arcs.above);
  const auto expectNear = [](const auto& some, const auto& others) {
    ASSERT_EQ(some.size(), others.size());
    for (std::size_t i = 0; i < some.size(); ++i) EXPECT_NEAR(some[i], others[i], 1e-15) << i;
  };
  expectNear(found.pieces.volume, expected.pieces.volume);
  expectNear(found.pieces.wallArea, expected.pieces.wallArea);
  expectNear(found.arcs.area, expected.arcs.area);
  expectNear(found.wallParts.area, expected.wallParts.area);
  expectNear(found.moments.volume, expected.moments.volume);
  expectNear(found.moments.arc, expected.moments.arc);
}

PolygonSoup ball(double radius, const Vec3<double>& center, int level = 3) {
  return moved(tessellation::icosphere(radius, level), center);
}
constexpr Vec3<double> kMiddle{0.51, 0.49, 0.47};

/// What is inside of a solid does not matter at all.
TEST(ShellsTest, ABallInABallIsTheOuterOne) {
  const auto outer = ball(0.4, kMiddle);
  const auto both = joined({ball(0.3, {0.53, 0.5, 0.5}), outer, ball(0.1, {0.5, 0.5, 0.5})});
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    for (const int n : {1, 3, 16}) {
      const CutOptions options{.polygons = true, .moments = 2};
      const auto expected = cellsOfShells(outer, n, side, options);
      const auto found = cellsOfShells(both, n, side, options);
      expectClosed(found);
      expectSame(found, expected);
      EXPECT_EQ(found.wallPolygons.count(), expected.wallPolygons.count());
    }
  }
}

TEST(ShellsTest, ABallInABallIsTheOuterOneInAPlaneAndInAnOctree) {
  const auto outer = ball(0.4, kMiddle);
  const auto both = joined({outer, ball(0.3, {0.53, 0.5, 0.5})});
  const CellCutter ofOuter(solidOf(outer));
  const CellCutter ofBoth(solidOf(both));
  const std::vector<double> planes{0, 0.1, 0.25, 0.5, 0.6, 0.8, 1};
  const auto grid = cellsBetween({planes, planes, planes});
  expectSame(ofBoth.cutInPlane(grid, 0.45), ofOuter.cutInPlane(grid, 0.45));
  const Octree<double> mesh(solidOf(outer), OctreeDomain<double>({0, 0, 0}, 1, {1, 1, 1}),
                            {.cut = 4});
  const auto expected = ofOuter.cut(mesh);
  const auto found = ofBoth.cut(mesh);
  ASSERT_EQ(found.pieces.volume.size(), expected.pieces.volume.size());
  for (std::size_t p = 0; p < expected.pieces.volume.size(); ++p) {
    EXPECT_NEAR(found.pieces.volume[p], expected.pieces.volume[p], 1e-15);
  }
  EXPECT_EQ(found.arcs.below, expected.arcs.below);
  EXPECT_EQ(found.classes, expected.classes);
  EXPECT_EQ(found.wholeBody, expected.wholeBody);
  EXPECT_LT(check(found).worstClosure, 1e-13);
}

TEST(ShellsTest, ABallInACavityIsSolid) {
  const auto outer = ball(0.4, kMiddle);
  const auto cavity = turned(ball(0.3, kMiddle));
  const auto inner = ball(0.2, kMiddle);
  const auto cells = cellsOfShells(joined({outer, cavity, inner}), 9);
  expectClosed(cells);
  EXPECT_NEAR(check(cells).bodyVolume, volumeOf(outer) + volumeOf(cavity) + volumeOf(inner), 1e-14);
  EXPECT_NEAR(check(cells).wallArea, areaOf(outer) + areaOf(cavity) + areaOf(inner), 1e-12);
}

TEST(ShellsTest, ShellsInsideOutAreTurned) {
  const auto one = ball(0.2, {0.25, 0.26, 0.27});
  const auto other = ball(0.2, {0.73, 0.74, 0.75});
  const auto found = cellsOfShells(joined({turned(one), other}), 8);
  expectClosed(found);
  expectSame(found, cellsOfShells(joined({one, other}), 8));
  EXPECT_NEAR(check(found).bodyVolume, volumeOf(one) + volumeOf(other), 1e-14);
}

/// Whole faces of triangles that both have cancel, and the boxes are one.
TEST(ShellsTest, BoxesWithAFaceInCommonAreOne) {
  const auto one = triangulated(tessellation::box({0.21, 0.2, 0.2}, {0.5, 0.8, 0.7}));
  auto other = turned(one);
  for (auto& p : other.points) p.x = 1 - p.x;
  const auto whole = tessellation::box({0.21, 0.2, 0.2}, {0.79, 0.8, 0.7});
  for (const int n : {1, 2, 5, 8}) {  // with the face in a plane of the grid, and not
    const auto cells = cellsOfShells(joined({one, other}), n);
    const auto report = check(cells);
    expectClosed(cells);
    EXPECT_NEAR(report.bodyVolume, volumeOf(whole), 1e-15);
    EXPECT_NEAR(report.wallArea, areaOf(whole), 1e-14);
    EXPECT_EQ(report.multiPieceCells, 0U);
    EXPECT_EQ(report.cutCells, check(cellsOfShells(whole, n)).cutCells);
  }
}

TEST(ShellsTest, BoxesThatTouchAlongAnEdgeOrInACornerAreBoth) {
  const auto one = tessellation::box({0.2, 0.2, 0.2}, {0.5, 0.5, 0.5});
  for (const Vec3<double>& by : {Vec3<double>{0.3, 0.3, 0}, {0.3, 0.3, 0.3}}) {
    for (const double off : {0.0, 0.0123}) {
      const auto both = moved(joined({one, moved(one, by)}), {off, off, off});
      for (const int n : {1, 4, 7}) {
        const auto cells = cellsOfShells(both, n);
        expectClosed(cells);
        EXPECT_NEAR(check(cells).bodyVolume, 2 * 0.027, 1e-15);
        EXPECT_NEAR(check(cells).wallArea, 12 * 0.09, 1e-14);
      }
    }
  }
}

TEST(ShellsTest, ASurfaceThatCancelsItselfBoundsNothing) {
  const auto one = ball(0.4, kMiddle, 1);
  auto both = joined({one, turned(one)});
  weldExactly(both);
  EXPECT_THROW(CellCutter(solidOf(both)), Error);
}

/// The volume or, between equal planes, the area of what boxes cover of a box: by inclusion and
/// exclusion.
double covered(const Box<double>& within, const std::vector<Box<double>>& boxes, int across = -1) {
  double sum = 0;
  for (unsigned some = 1; some < 1U << boxes.size(); ++some) {
    auto common = within;
    int sign = -1;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if ((some >> i & 1U) == 0) continue;
      common = common.intersection(boxes[i]);
      sign = -sign;
    }
    if (common.empty()) continue;
    double size = sign;
    for (int axis = 0; axis < 3; ++axis) size *= axis == across ? 1 : common.size()[axis];
    sum += size;
  }
  return sum;
}

/// Compares the volume of each cell and the open area of each face with inclusion and exclusion.
void expectUnion(const std::vector<Box<double>>& boxes, int n, std::size_t& meeting) {
  PolygonSoup soup;
  for (const auto& box : boxes) {
    soup = joined({soup, tessellation::box(box.lower, box.upper)});
  }
  const auto cells = cellsOfShells(soup, n);
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

TEST(ShellsTest, UnionsOfBoxesAreThoseOfInclusionAndExclusion) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0.03, 0.97);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(60) && !HasFailure(); ++round) {
    std::vector<Box<double>> boxes;
    for (int k = 0; k < 2 + round % 3; ++k) {
      const auto corner = [&] {
        return Vec3<double>{number(random), number(random), number(random)};
      };
      const auto p = corner();
      const auto q = corner();
      boxes.push_back({min(p, q), max(p, q)});
    }
    expectUnion(boxes, 1 + round % 5, meeting);
  }
  EXPECT_GT(meeting, 100U);
}

/// Faces lie on one another and in planes of the grid.
TEST(ShellsTest, UnionsOfBoxesInPlanesOfTheGridAreThoseOfInclusionAndExclusion) {
  std::mt19937 random(4);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(200) && !HasFailure(); ++round) {
    std::vector<Box<double>> boxes;
    for (int k = 0; k < 2 + round % 3; ++k) {
      Box<double> box;
      for (int axis = 0; axis < 3; ++axis) {
        const int lower = static_cast<int>(random() % 7) + 1;
        const int upper = lower + 1 + static_cast<int>(random() % static_cast<unsigned>(8 - lower));
        box.lower[axis] = lower / 9.0;
        box.upper[axis] = upper / 9.0;
      }
      boxes.push_back(box);
    }
    expectUnion(boxes, std::array{1, 2, 3, 9}[static_cast<std::size_t>(round) % 4], meeting);
  }
  EXPECT_GT(meeting, 100U);
}

/// A plate through a cell, of two boxes that overlap in its middle, parts it; patches keep their
/// walls.
TEST(ShellsTest, PiecesAndPatchesAreThoseOfTheUnion) {
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
TEST(ShellsTest, ShellsThatRepeatOrCrossThemselvesCount) {
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

TEST(ShellsTest, CoarserCellsAreThoseOfTheUnion) {
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

TEST(ShellsTest, WhatNeedsASimpleSurfaceIsRefused) {
  const auto one = tessellation::box({0.2, 0.2, 0.2}, {0.6, 0.6, 0.6});
  const Solid<double> solid = solidOf(joined({one, moved(one, {0.1, 0.1, 0.1})}));
  const CellCutter cutter(solid);
  const GridPatch<double> grid{Level<double>({0, 0, 0}, {1, 1, 1}), IndexBox::ofSize(1, 1, 1)};
  EXPECT_NO_THROW(static_cast<void>(cutter.cut(grid)));
  EXPECT_THROW(static_cast<void>(cutter.cut(grid, {.polygons = true})), Error);
  EXPECT_THROW(static_cast<void>(cutter.cut(grid, {.moments = 0})), Error);
  EXPECT_THROW(static_cast<void>(cutter.cutInPlane(planesOf(grid), 0.5)), Error);
  const Octree<double> mesh(solid, OctreeDomain<double>({0, 0, 0}, 1, {1, 1, 1}), {.cut = 1});
  EXPECT_THROW(static_cast<void>(cutter.cut(mesh)), Error);
}

PolygonSoup without(const PolygonSoup& soup, const std::set<std::size_t>& polygons) {
  PolygonSoup rest;
  rest.points = soup.points;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    if (!polygons.contains(i)) rest.addPolygon(soup.polygon(i));
  }
  return rest;
}

CellCutter cappedCutter(const PolygonSoup& soup) {
  return CellCutter(solidOf(soup), FluidSide::Outside, {.capHoles = true});
}

GridPatch<double> unitPatch(int n) {
  return {Level<double>({0, 0, 0}, {1.0 / n, 1.0 / n, 1.0 / n}), IndexBox::ofSize(n, n, n)};
}

TEST(ShellsTest, CapsCloseHolesAndAreAPatch) {
  // The two ends of a box: rims in a plane, closed as they were.
  const auto whole = tessellation::box({0.2, 0.25, 0.3}, {0.7, 0.75, 0.8}, 4);
  std::set<std::size_t> ends;
  for (std::size_t i = 0; i < whole.polygonCount(); ++i) {
    std::set<double> x;
    for (const auto corner : whole.polygon(i)) x.insert(whole.points[corner].x);
    if (x.size() == 1) ends.insert(i);
  }
  ASSERT_GT(ends.size(), 0U);
  const auto open = without(whole, ends);
  EXPECT_THROW(CellCutter{solidOf(open)}, Error);
  for (const int n : {1, 5, 20}) {
    const auto cells = cappedCutter(open).cut(unitPatch(n));
    expectClosed(cells);
    EXPECT_NEAR(check(cells).bodyVolume, 0.125, 1e-15);
    ASSERT_EQ(cells.patchNames.size(), 2U);
    EXPECT_EQ(cells.patchNames.back(), "cap");
    double caps = 0;
    for (std::size_t w = 0; w < cells.wallParts.area.size(); ++w) {
      if (cells.wallParts.patch[w] == 1) caps += cells.wallParts.area[w];
    }
    EXPECT_NEAR(caps, 2 * 0.25, 1e-14);
  }
}

TEST(ShellsTest, ACapOfOneTriangleIsTheTriangle) {
  const auto whole = ball(0.4, kMiddle, 2);
  const auto cells = cappedCutter(without(whole, {7, 100})).cut(unitPatch(9));
  const auto expected = cellsOfShells(whole, 9);
  expectClosed(cells);
  ASSERT_EQ(cells.pieceCount, expected.pieceCount);
  for (std::size_t p = 0; p < cells.pieceCount; ++p) {
    EXPECT_NEAR(cells.pieces.volume[p], expected.pieces.volume[p], 1e-15);
  }
  EXPECT_EQ(cappedCutter(whole).cut(unitPatch(9)).patchNames.size(), 1U);  // nothing to close
}

/// A cap that passes through what is in the opening: both are body.
TEST(ShellsTest, CapsMayPassThroughTheSurface) {
  const auto whole = tessellation::box({0.2, 0.2, 0.2}, {0.6, 0.6, 0.6});
  std::set<std::size_t> end;
  for (std::size_t i = 0; i < whole.polygonCount(); ++i) {
    bool isHigh = true;
    for (const auto corner : whole.polygon(i)) isHigh = isHigh && whole.points[corner].x == 0.6;
    if (isHigh) end.insert(i);
  }
  const auto bar = tessellation::box({0.5, 0.3, 0.3}, {0.8, 0.4, 0.4});
  for (const int n : {1, 3, 8}) {
    const auto cells = cappedCutter(joined({without(whole, end), bar})).cut(unitPatch(n));
    expectClosed(cells);
    EXPECT_NEAR(check(cells).bodyVolume, 0.064 + 0.2 * 0.01, 1e-15);
    EXPECT_NEAR(check(cells).wallArea, 6 * 0.16 + 4 * 0.2 * 0.1, 1e-14);
  }
}

}  // namespace
}  // namespace cutwater::test
