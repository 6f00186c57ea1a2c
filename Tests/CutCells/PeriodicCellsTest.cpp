// CutterOptions::period.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/PeriodicCells.hpp"
#include "CutCells/RowFiles.hpp"
#include "CutCells/Sheets.hpp"
#include "CutCells/ShellCells.hpp"
#include "CutCells/Tetrahedra.hpp"
#include "Support/Refusal.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

TEST(PeriodicCellsTest, BoxesOfATurnedTorusRepeatToTheBit) {
  Solid<double> solid(MeshSDF<double>(tessellation::torus(0.4, 0.2, 30, 16)));
  solid.rotate(33.0, Vec3<double>{1, 2, 3});
  for (const auto& period :
       {Vec3<double>{1, 0, 0}, Vec3<double>{0, 1.1, 0.9}, Vec3<double>{1.3, 1.2, 1.25}}) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      const CellCutter cutter(solid, side, {.period = period});
      expectRepeats(cutter, 9, -0.3, {.polygons = true});
      expectRepeats(cutter, 7, 0.05, {.moments = 2});
    }
  }
}

TEST(PeriodicCellsTest, BallsThatCrossTheBoundaryKeepTheirVolume) {
  // Also at the corners of the period, and across images of themselves.
  for (const auto& center : {Vec3<double>{0.01, 0.5, 0.97}, Vec3<double>{0, 0, 0}}) {
    for (const double radius : {0.3, 0.55}) {
      const auto solid = solidOf(ball(radius, center));
      const CellCutter cutter(solid, FluidSide::Outside, {.period = {1, 1, 1}});
      const auto cells = cutter.cut(GridPatch<double>{Level<double>({0, 0, 0}, {0.1, 0.1, 0.1}),
                                                      IndexBox::ofSize(10, 10, 10)});
      const auto report = check(cells);
      expectIdentities(cells, 1e-13);
      EXPECT_EQ(report.meetingCells > 0, radius > 0.5);
      const CellCutter alone(solid);
      const auto box = alone.cut(GridPatch<double>{Level<double>({-1, -1, -1}, {0.25, 0.25, 0.25}),
                                                   IndexBox::ofSize(12, 12, 12)});
      if (radius < 0.5) {
        EXPECT_NEAR(report.bodyVolume, check(box).bodyVolume, 1e-13);
        EXPECT_NEAR(report.wallArea, check(box).wallArea, 1e-12);
      } else {
        EXPECT_LT(report.bodyVolume, check(box).bodyVolume - 0.001);
      }
      expectRepeats(cutter, 6, 0, {.polygons = true});
    }
  }
}

/// With corners in planes of the grid, up to one and a half periods apart: long edges lie in
/// planes, too, and images touch or overlap.
TEST(PeriodicCellsTest, TetrahedraOnNodesAreTheMiddleOfMany) {
  std::mt19937 random(5);
  constexpr int kCells = 4;
  const auto across = planesOfPeriod(kCells, 0, 1);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(40) && !HasFailure(); ++round) {
    const unsigned widest = round % 2 == 0 ? kCells : 6;
    const auto coordinate = [&] { return 0.25 * static_cast<double>(random() % (widest + 1)); };
    const auto one = tetrahedraOf(1, [&] {
      const double x = coordinate();
      const double y = coordinate();
      return Vec3<double>{x, y, coordinate()};
    });
    const auto& p = one.points;
    if (dot(p[3] - p[0], cross(p[1] - p[0], p[2] - p[0])) == 0) continue;
    PolygonSoup many;
    for (int image = 0; image < 216; ++image) {
      const Vec3<double> shift(image % 6 - 3, image / 6 % 6 - 3, image / 36 - 3);
      many = together(many, withPoints(one, [&](const Vec3<double>& at) { return at + shift; }));
    }
    const CellCutter cutter(solidOf(one), FluidSide::Outside, {.period = {1, 1, 1}});
    const auto cells = cutter.cut(cutter.cellsOfPeriod({across, across, across}, {},
                                                       IndexBox::ofSize(kCells, kCells, kCells)));
    const auto expected = CellCutter(solidOf(many)).cut(cellsBetween({across, across, across}));
    for (int c = 0; c < kCells * kCells * kCells; ++c) {
      ASSERT_NO_FATAL_FAILURE(
          expectSameCell(cells, expected, {c % kCells, c / kCells % kCells, c / kCells / kCells}))
          << round;
    }
    meeting += check(cells).meetingCells > 0 ? 1 : 0;
    expectRepeats(cutter, kCells, 0, {.polygons = true});
    expectRepeats(cutter, 3, 0.25);
  }
  EXPECT_GT(meeting, 3U);
}

/// A ball, and a parallelogram as a baffle.
Solid<double> ballAndFin(const Vec3<double>& corner, const Vec3<double>& u, const Vec3<double>& v) {
  return solidOf(beside(called("ball", ball(0.2, {0.5, 0.55, 0.52})), sheet(corner, u, v)));
}

TEST(PeriodicCellsTest, BafflesThatCrossTheBoundaryRepeatToTheBit) {
  for (const auto& [corner, u, v] : {
           std::array<Vec3<double>, 3>{{{0.8, 0.1, 0.2}, {0.3, 0.1, 0.05}, {0.1, 0.5, 0.4}}},
           std::array<Vec3<double>, 3>{{{0.7, 0.25, 0.25}, {0.5, 0, 0}, {0, 0, 0.5}}},
           std::array<Vec3<double>, 3>{{{1, 0.25, 0.25}, {0, 0.5, 0}, {0, 0, 0.5}}},  // in the end
       }) {
    for (const auto& period : {Vec3<double>{1, 0, 0}, Vec3<double>{1, 1, 1}}) {
      const CellCutter cutter(ballAndFin(corner, u, v), FluidSide::Outside,
                              {.baffles = {"fin"}, .period = period});
      expectRepeats(cutter, 4, 0, {.polygons = true});
      expectRepeats(cutter, 7, 0.05, {.moments = 2});
      const auto cells = cutter.cut(GridPatch<double>{Level<double>({0, 0, 0}, {0.25, 0.25, 0.25}),
                                                      IndexBox::ofSize(4, 4, 4)});
      EXPECT_NEAR(check(cells).wallArea, areaOf(ball(0.2, {})) + 2 * length(cross(u, v)), 1e-13);
    }
  }
}

/// All across the period, so that its images are one sheet.
TEST(PeriodicCellsTest, ABaffleAllAcrossDividesTheFluid) {
  for (const double height : {0.25, 0.9, 1.0}) {
    const CellCutter cutter(ballAndFin({0, 0, height}, {1, 0, 0}, {0, 1, 0}), FluidSide::Outside,
                            {.baffles = {"fin"}, .period = {1, 1, 0}});
    const auto cells = cutter.cut(
        GridPatch<double>{Level<double>({0, 0, 0}, {0.25, 0.25, 0.25}), IndexBox::ofSize(4, 4, 6)});
    expectIdentities(cells, 1e-13);
    EXPECT_EQ(CutRegions(cells).regions().size(), 2U) << height;
    expectRepeats(cutter, 4, 0, {.polygons = true});
  }
}

/// One that goes on through the ends of the period, whose ends cancel each other.
TEST(PeriodicCellsTest, TheFluxThroughATubeIsTheSameAtBothEnds) {
  for (const double turn : {0.0, 0.4}) {
    std::vector<std::pair<double, double>> outline;
    for (int n = 0; n < 24; ++n) {
      const double angle = turn + n * 3.14159265358979323846 / 12;
      outline.emplace_back(0.5 + 0.4 * std::cos(angle), 0.5 + 0.3 * std::sin(angle));
    }
    const auto solid = solidOf(prism(outline, 1.5));
    const CellCutter cutter(solid, FluidSide::Inside, {.period = {0, 0, 1.5}});
    const auto cells = cutter.cut(
        GridPatch<double>{Level<double>({0, 0, 0}, {0.125, 0.125, 0.1}), {{0, 0, 0}, {7, 7, 14}}});
    expectIdentities(cells, 1e-13);
    EXPECT_EQ(check(cells).meetingCells, 0U);
    std::array<double, 2> flux{};
    for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
      if (cells.arcs.axis[a] != 2) continue;
      if (cells.arcs.cell[a].k == 0) flux[0] += cells.arcs.area[a];
      if (cells.arcs.cell[a].k == 15) flux[1] += cells.arcs.area[a];
      EXPECT_LT(cells.arcs.below[a], CutCells::kBeyond);
    }
    EXPECT_GT(flux[0], 0.1);
    EXPECT_EQ(flux[0], flux[1]);
    const auto& names = cells.patchNames;
    EXPECT_EQ(names.size(), 1U);
    // All walls are sides: none is across the tube.
    for (const auto& v : cells.pieces.wallVector) EXPECT_NEAR(v.z, 0, 1e-15);
    const CutRegions fluid(cells);
    ASSERT_EQ(fluid.regions().size(), 1U);
    EXPECT_FALSE(fluid.regions()[0].goesOn);
    EXPECT_NEAR(fluid.regions()[0].volume, check(cells).fluidVolume, 1e-13);
    expectRepeats(cutter, 8, 0, {.polygons = true});
  }
}

TEST(PeriodicCellsTest, FilesKnowThePeriod) {
  const CellCutter cutter(solidOf(ball(0.3, {0, 0, 0}, 2)), FluidSide::Outside,
                          {.period = {1, 0, 0}});
  const auto cells = cutter.cut(
      GridPatch<double>{Level<double>({0, -1, -1}, {0.25, 0.25, 0.25}), {{2, 0, 0}, {5, 7, 7}}});
  EXPECT_EQ(cells.grid.period, (std::array<std::int32_t, 3>{4, 0, 0}));
  const auto loaded = cutCellsFrom(toBytes(cells));
  EXPECT_EQ(loaded.grid.period, cells.grid.period);
  EXPECT_EQ(toBytes(loaded), toBytes(cells));
  EXPECT_EQ(CutRegions(loaded).regions().size(), 1U);
  // Whatever is in them, as long as it is taken: all that can be asked is safe.
  expectForgeriesAreSafe(toBytes(cells), scaled(1000), cutCellsFrom, [](const CutCells& forged) {
    static_cast<void>(check(forged));
    static_cast<void>(CutRegions(forged));
    static_cast<void>(coarsened(forged, {1, 1, 1}));
    static_cast<void>(merged(forged, {.smallest = 0.5}));
  });
}

TEST(PeriodicCellsTest, RefusesWhatDoesNotRepeat) {
  const auto solid = solidOf(ball(0.3, {0.5, 0.5, 0.5}, 1));
  const auto with = [&](const Vec3<double>& period) {
    return CellCutter(solid, FluidSide::Outside, {.period = period});
  };
  EXPECT_NE(refusal([&] { return with({-1, 0, 0}); }).find("period = -1"), std::string::npos);
  EXPECT_NE(refusal([&] { return with({0, INFINITY, 0}); }).find("axis = 1"), std::string::npos);
  EXPECT_NE(refusal([&] { return with({0, 0, 1e-4}); }).find("so short"), std::string::npos);
  const auto cutter = with({1, 0, 0});
  const auto cells = [&](double h, const IndexBox& box) {
    return GridPatch<double>{Level<double>({0, 0, 0}, {h, h, h}), box};
  };
  const auto says = [&](const auto& act, const std::string& what) {
    const auto message = refusal(act);
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  says([&] { return cutter.cut(cells(0.15, IndexBox::ofSize(3, 3, 3))); }, "as long as the period");
  says([&] { return cutter.cut(cells(1, IndexBox::ofSize(1, 3, 3))); }, "two cells or more");
  says([&] { return cutter.cut(cells(0.25, {{4000, 0, 0}, {4001, 1, 1}})); }, "less far away");
  says(
      [&] {
        return cutter.cut(cellsBetween({{{0, 0.5, 1}, {0, 1}, {0, 1}}}));
      },
      "cells of a period");
  says(
      [&] {
        return with({}).cut(
            cutter.cellsOfPeriod({{{0, 0.5, 1}, {0, 1}, {0, 1}}}, {}, IndexBox::ofSize(2, 1, 1)));
      },
      "cells of a period");
  says(
      [&] {
        return cutter.cellsOfPeriod({{{0, 0.5, 1}, {0, 1}, {0, 1}}}, {}, IndexBox::ofSize(2, 2, 1));
      },
      "between the planes");
  says(
      [&] {
        return cutter.cut(cutter.cellsOfPeriod({{{0.8, 1.55, 1.8}, {0, 1}, {0, 1}}}, {},
                                               IndexBox::ofSize(2, 1, 1)));
      },
      "half a period");
  auto wrong = cutter.cellsOfPeriod({{{0, 0.5, 1}, {0, 1}, {0, 1}}}, {}, IndexBox::ofSize(2, 1, 1));
  wrong.planes[0][1] = 0.01;
  says([&] { return cutter.cut(wrong); }, "cellsOfPeriod");
  says([&] { return cutter.cutInPlane(planesOf(cells(0.25, IndexBox::ofSize(4, 4, 1))), 0.5); },
       "period");
  const OctreeCells<double> mesh(OctreeDomain<double>({0, 0, 0}, 1, {1, 1, 1}), 0,
                                 {{.index = {}, .level = 0}});
  says([&] { return cutter.cut(mesh); }, "no periods in an octree");
}

}  // namespace
}  // namespace cutwater::test
