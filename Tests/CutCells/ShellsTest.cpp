// Surfaces of several shells that do not overlap, and caps.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <set>

#include <gtest/gtest.h>

#include "CutCells/ShellCells.hpp"

namespace cutwater::test {
namespace {

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
  const auto cavity = insideOut(ball(0.3, kMiddle));
  const auto inner = ball(0.2, kMiddle);
  const auto cells = cellsOfShells(joined({outer, cavity, inner}), 9);
  expectClosed(cells);
  EXPECT_NEAR(check(cells).bodyVolume, volumeOf(outer) + volumeOf(cavity) + volumeOf(inner), 1e-14);
  EXPECT_NEAR(check(cells).wallArea, areaOf(outer) + areaOf(cavity) + areaOf(inner), 1e-12);
}

TEST(ShellsTest, ShellsInsideOutAreTurned) {
  const auto one = ball(0.2, {0.25, 0.26, 0.27});
  const auto other = ball(0.2, {0.73, 0.74, 0.75});
  const auto found = cellsOfShells(joined({insideOut(one), other}), 8);
  expectClosed(found);
  expectSame(found, cellsOfShells(joined({one, other}), 8));
  EXPECT_NEAR(check(found).bodyVolume, volumeOf(one) + volumeOf(other), 1e-14);
}

/// Whole faces of triangles that both have cancel, and the boxes are one.
TEST(ShellsTest, BoxesWithAFaceInCommonAreOne) {
  const auto one = triangulated(tessellation::box({0.21, 0.2, 0.2}, {0.5, 0.8, 0.7}));
  auto other = insideOut(one);
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
  auto both = joined({one, insideOut(one)});
  weldExactly(both);
  EXPECT_THROW(CellCutter(solidOf(both)), Error);
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
