// One shell that touches itself: along parts of edges, which its triangles do not share, or in a
// point.

#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <gtest/gtest.h>

#include "CutCells/ShellCells.hpp"

namespace cutwater::test {
namespace {

using Section = std::array<Vec3<double>, 4>;

/// A square of this width across the z axis, from a corner on.
Section level(double x, double y, double z, double width) {
  return {{{x, y, z}, {x + width, y, z}, {x + width, y + width, z}, {x, y + width, z}}};
}

/// The sides of a bar through these sections, and the end at the first of them.
PolygonSoup sidesThrough(const std::vector<Section>& sections) {
  PolygonSoup soup;
  for (const auto& section : sections) {
    soup.points.insert(soup.points.end(), section.begin(), section.end());
  }
  soup.addPolygon(std::array{3U, 2U, 1U, 0U});
  for (std::uint32_t s = 0; s + 1 < sections.size(); ++s) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto next = 4 * s + (i + 1) % 4;
      const auto here = 4 * s + i;
      soup.addPolygon(std::array{here, next, next + 4});
      soup.addPolygon(std::array{here, next + 4, here + 4});
    }
  }
  return soup;
}

/// Of a bar that goes up on one side and comes down on the other.
std::vector<Section> upAndAround() {
  return {level(0, 0, 0, 1),
          level(0, 0, 1, 1),
          level(0, 0, 3, 0.5),
          {{{1.25, 1.25, 6}, {2, 0.5, 5}, {1.25, 1.25, 4}, {0.5, 2, 5}}},
          {{{2.5, 2.5, 3}, {2.5, 2, 3}, {2, 2, 3}, {2, 2.5, 3}}}};
}

/// A bent bar whose ends stand side by side. Both have an edge at x = y = 1: one from z = 0 to 1,
/// the other one from 0.5 to 1.5.
PolygonSoup bentBar() {
  auto sections = upAndAround();
  // On the way down, the bar's inner edge is still that of third corners.
  for (const double z : {1.5, 0.5}) {
    sections.push_back({{{2, 2, z}, {2, 1, z}, {1, 1, z}, {1, 2, z}}});
  }
  auto soup = sidesThrough(sections);
  const auto last = static_cast<std::uint32_t>(soup.points.size());
  soup.addPolygon(std::array{last - 4, last - 3, last - 2, last - 1});
  return triangulated(soup);
}

/// A bent bar that comes down to this point, somewhere on the sides of its other end: x = 1 or
/// y = 1.
PolygonSoup pointedBar(const Vec3<double>& tip) {
  auto sections = upAndAround();
  sections.push_back({{{3, 3, 1.5}, {3, 2.2, 1.5}, {2.2, 2.2, 1.5}, {2.2, 3, 1.5}}});
  auto soup = sidesThrough(sections);
  const auto last = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back(tip);
  for (std::uint32_t i = 0; i < 4; ++i) {
    soup.addPolygon(std::array{last - 4 + i, last - 4 + (i + 1) % 4, last});
  }
  return triangulated(soup);
}

CutCells cellsOfBar(const std::array<std::vector<double>, 3>& planes, FluidSide side,
                    const CutOptions& options = {}) {
  return CellCutter(solidOf(bentBar()), side).cut(cellsBetween(planes), options);
}

TEST(TouchingShellTest, IsOneShellThatIsSoundAndTouchesItself) {
  const MeshSDF<double> bar(bentBar());
  const auto& signs = bar.signReport();
  EXPECT_EQ(signs.shells, 1U);
  EXPECT_TRUE(signs.isProven);
  EXPECT_GT(signs.touchingEdges, 0U);
}

TEST(TouchingShellTest, FluidOnBothSidesIsApart) {
  const auto cells = cellsOfBar({{{0.75, 1.25}, {0.75, 1.25}, {0.5, 0.75, 1}}}, FluidSide::Outside);
  expectClosed(cells);
  ASSERT_EQ(cells.cellCount, 2U);
  ASSERT_EQ(cells.pieceCount, 4U);
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_DOUBLE_EQ(cells.pieces.volume[p], 0.25 * 0.25 * 0.25) << p;
  }
  const auto inside = cellsOfBar({{{0.75, 1.25}, {0.75, 1.25}, {0.5, 0.75, 1}}}, FluidSide::Inside);
  expectClosed(inside);
  EXPECT_EQ(inside.pieceCount, 4U);
}

TEST(TouchingShellTest, FluidIsOnePieceWhereOnlyOneEndIs) {
  const auto cells =
      cellsOfBar({{{0.75, 1.25}, {0.75, 1.25}, {0.25, 0.75, 1.25}}}, FluidSide::Outside);
  expectClosed(cells);
  EXPECT_EQ(cells.pieceCount, 2U);  // each of them goes around an end
}

TEST(TouchingShellTest, IsClosedInPlanesAndBesideThem) {
  for (const double shift : {0.0, 0.1, 0.125}) {
    for (const int n : {2, 7, 8}) {
      std::array<std::vector<double>, 3> planes;
      for (int i = 0; i <= 2 * n; ++i) {
        const double at = -1 + 4.0 * i / (2 * n);
        planes[0].push_back(at + shift);
        planes[1].push_back(at);
      }
      for (int i = 0; i <= 3 * n; ++i) planes[2].push_back(-1 + 8.0 * i / (3 * n));
      for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
        const auto cells = cellsOfBar(planes, side, {.polygons = true, .moments = 1});
        expectClosed(cells);
        const auto report = check(cells);
        const double inBar = side == FluidSide::Outside ? report.bodyVolume : report.fluidVolume;
        EXPECT_NEAR(inBar, volumeOf(bentBar()), 1e-12) << n << ' ' << shift;
      }
    }
  }
}

TEST(TouchingShellTest, LeavesAreClosed) {
  const CellCutter cutter(solidOf(bentBar()));
  const OctreeDomain<double> domain({-1, -1, -1}, 4, {1, 1, 2});
  for (const int level : {2, 3, 4}) {
    const auto leaves =
        cutter.cut(Octree<double>(solidOf(bentBar()), domain, {.cut = level}), CutOptions{});
    const auto report = check(leaves);
    EXPECT_LT(report.worstClosure, 1e-13) << level;
    EXPECT_NEAR(report.bodyVolume, volumeOf(bentBar()), 1e-12) << level;
  }
}

TEST(TouchingShellTest, LeavesAroundTheEdgeHaveFluidOnBothSides) {
  // One leaf, and the ends fill half of it.
  const OctreeDomain<double> domain({0.75, 0.75, 0.5}, 0.5, {1, 1, 1});
  const Octree<double> one(solidOf(bentBar()), domain, {});
  const auto leaves = CellCutter(solidOf(bentBar())).cut(one);
  ASSERT_EQ(one.cells().size(), 1U);
  EXPECT_LT(check(leaves).worstClosure, 1e-13);
  ASSERT_EQ(leaves.pieces.volume.size(), 2U);
  for (const double volume : leaves.pieces.volume) EXPECT_DOUBLE_EQ(volume, 0.25 * 0.25 * 0.5);
}

/// Within a face, within an edge, and at a corner of the other end.
constexpr std::array<Vec3<double>, 3> kTips{{{1, 0.5, 0.5}, {1, 1, 0.5}, {1, 1, 1}}};

TEST(TouchingShellTest, InAPointFluidIsNotDivided) {
  for (const auto& tip : kTips) {
    const auto bar = pointedBar(tip);
    const CellCutter outside(solidOf(bar));
    const CellCutter inside(solidOf(bar), FluidSide::Inside);
    std::array<std::vector<double>, 3> around;
    std::array<std::vector<double>, 3> beside;
    for (int axis = 0; axis < 3; ++axis) {
      around[axis] = {tip[axis] - 0.125, tip[axis] + 0.25};
      beside[axis] = {tip[axis], tip[axis] + 0.25};
    }
    const auto whole = outside.cut(cellsBetween(around));
    expectClosed(whole);
    EXPECT_EQ(whole.pieceCount, 1U) << tip;
    const auto solid = inside.cut(cellsBetween(around));
    expectClosed(solid);
    EXPECT_EQ(solid.pieceCount, 2U) << tip;
    EXPECT_NEAR(check(whole).fluidVolume + check(solid).fluidVolume, 0.375 * 0.375 * 0.375, 1e-15);
    // The tip is a node.
    const auto corner = outside.cut(cellsBetween(beside));
    expectClosed(corner);
    EXPECT_EQ(corner.pieceCount, 1U) << tip;
  }
}

TEST(TouchingShellTest, InAPointItIsClosedInPlanesAndBesideThem) {
  for (const auto& tip : kTips) {
    const auto bar = pointedBar(tip);
    for (const double shift : {0.0, 0.1}) {
      for (const int n : {2, 7, 8}) {
        std::array<std::vector<double>, 3> planes;
        for (int i = 0; i <= 2 * n; ++i) {
          planes[0].push_back(-1 + 5.0 * i / (2 * n) + shift);
          planes[1].push_back(-1 + 5.0 * i / (2 * n));
        }
        for (int i = 0; i <= 4 * n; ++i) planes[2].push_back(-1 + 8.0 * i / (4 * n));
        for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
          const auto cells = CellCutter(solidOf(bar), side).cut(cellsBetween(planes));
          expectClosed(cells);
          const auto report = check(cells);
          const double inBar = side == FluidSide::Outside ? report.bodyVolume : report.fluidVolume;
          EXPECT_NEAR(inBar, volumeOf(bar), 1e-12) << tip << ' ' << n << ' ' << shift;
        }
      }
    }
  }
}

}  // namespace
}  // namespace cutwater::test
