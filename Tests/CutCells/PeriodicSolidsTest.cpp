// SolidCutterOptions::period.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "CutCells/PeriodicCells.hpp"
#include "Support/Refusal.hpp"

namespace cutwater::test {
namespace {

constexpr double kPiOfPeriods = std::numbers::pi;

Solid<double> turnedBox() {
  Solid<double> box(Cuboid<double>({-0.2, -0.3, -0.25}, {0.25, 0.2, 0.3}));
  box.rotate(33.0, Vec3<double>{1, 2, 3});
  return translated(box, Vec3<double>{0.9, 0.05, 0.5});
}
Solid<double> repeatedWall() {
  return TpmsSolid<double>(TpmsField<double>(TpmsPattern::gyroid(), 1), TpmsPart::Wall, 0.3);
}
CutCells unitPeriod(const SolidCutter& cutter, int n, const CutOptions& options = {}) {
  const double width = 1.0 / n;
  return cutter.cut(
      GridPatch<double>{Level<double>({0, 0, 0}, {width, width, width}), IndexBox::ofSize(n, n, n)},
      options);
}

TEST(PeriodicSolidsTest, BoxesRepeatToTheBit) {
  const Torus<double> torus({0.1, 0.4, 0.95}, {1, 2, 3}, 0.4, 0.17);
  const FunctionSDF function([](const Vec3<double>& p) { return length(p) - 0.45; },
                             Guarantee<double>{.lipschitz = 1, .continuous = true, .size = 1},
                             Box<double>{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
  const auto expectAlong = [](const Vec3<double>& period, FluidSide side,
                              const std::array<Solid<double>, 2>& solids) {
    for (const auto& solid : solids) {
      SCOPED_TRACE(solid.describe());
      const SolidCutter cutter(solid, side, {.points = 2, .tolerance = 1e-3, .period = period});
      expectRepeats(cutter, 5, 0.05, {.moments = 2});
      expectRepeats(cutter, 4, -0.3);
    }
  };
  expectAlong({1, 0, 0}, FluidSide::Outside, {turnedBox() | torus, Solid<double>(function)});
  expectAlong({0, 1.1, 0.9}, FluidSide::Inside, {turnedBox(), Solid<double>(torus)});
  expectAlong({1.3, 1.2, 1.25}, FluidSide::Outside, {turnedBox(), Solid<double>(function)});
}

TEST(PeriodicSolidsTest, WhatRepeatsItselfDoesSoToTheBit) {
  const SolidCutter walls(repeatedWall(), FluidSide::Outside, {.period = {1, 1, 1}});
  expectRepeats(walls, 4, 0.013);
  const SolidCutter floor(Solid<double>(Plane<double>({0, 0, 0.4}, {0, 0, 1})), FluidSide::Outside,
                          {.period = {1, 1, 0}});
  expectRepeats(floor, 4, 0);
  const Solid<double> waves(FunctionSDF(
      [](const Vec3<double>& p) {
        return 0.7 * (p.z - 0.5 - 0.1 * std::sin(2 * kPiOfPeriods * p.x));
      },
      Guarantee<double>{.lipschitz = 1, .continuous = true, .size = 1}));
  expectRepeats(SolidCutter(waves, FluidSide::Outside, {.period = {1, 0.5, 0}}), 5, 0.1);
}

TEST(PeriodicSolidsTest, BallsThatCrossTheBoundaryKeepTheirVolume) {
  // Also at the corners of the period, and across images of themselves.
  for (const auto& center : {Vec3<double>{0.01, 0.5, 0.97}, Vec3<double>{0, 0, 0}}) {
    for (const double radius : {0.3, 0.55}) {
      const SolidCutter cutter(Solid<double>(Sphere<double>(center, radius)), FluidSide::Outside,
                               {.points = 4, .period = {1, 1, 1}});
      const auto report = check(unitPeriod(cutter, 10));
      const double cap = std::max(0.0, radius - 0.5);
      const double overlap = 2 * kPiOfPeriods * cap * cap * (radius - cap / 3);
      EXPECT_NEAR(report.bodyVolume, 4 * kPiOfPeriods / 3 * std::pow(radius, 3) - 3 * overlap,
                  2e-7);
      const double lost = 6 * 2 * kPiOfPeriods * radius * cap;
      EXPECT_NEAR(report.wallArea, 4 * kPiOfPeriods * radius * radius - lost, 2e-6);
    }
  }
}

TEST(PeriodicSolidsTest, PatchesAreThoseOfTheSolid) {
  const auto solid =
      named(turnedBox(), "box") | named(Sphere<double>({0.1, 0.5, 0.9}, 0.3), "ball");
  const SolidCutter cutter(solid, FluidSide::Outside, {.period = {1, 1, 1}});
  const auto cells = unitPeriod(cutter, 8);
  EXPECT_EQ(cells.patchNames, (std::vector<std::string>{"box", "ball"}));
  std::array<double, 2> areas{};
  for (std::size_t n = 0; n < cells.wallParts.area.size(); ++n) {
    if (cells.wallParts.piece[n] < cells.pieceCount) {
      areas.at(cells.wallParts.patch[n]) += cells.wallParts.area[n];
    }
  }
  EXPECT_GT(areas[0], 0.8);
  EXPECT_GT(areas[1], 0.6);
  EXPECT_NEAR(areas[0] + areas[1], check(cells).wallArea, 1e-12);
}

TEST(PeriodicSolidsTest, PointsOfQuadratureLieInTheirCells) {
  const SolidCutter cutter(turnedBox(), FluidSide::Outside, {.period = {1, 1, 1}});
  std::array<std::vector<double>, 3> planes;
  planes.fill(planesOfPeriod(6, 0, 1));
  const IndexBox box{{-4, 3, 5}, {3, 9, 11}};
  const auto cells = cutter.cut(cutter.cellsOfPeriod(planes, {}, box), {.quadrature = true});
  const auto expectWithin = [](const Box<double>& where, std::span<const Vec3<double>> points) {
    for (const auto& point : points) EXPECT_TRUE(where.grown(1e-15).contains(point));
  };
  const auto& points = cells.quadrature;
  for (std::uint32_t p = 0; p < cells.pieces.cell.size(); ++p) {
    const auto where = cells.boxOf(cells.cells.index[cells.pieces.cell[p]]);
    expectWithin(where, points.volume.pointsOf(p));
    expectWithin(where, points.wall.pointsOf(p));
  }
  for (std::uint32_t a = 0; a < cells.arcs.area.size(); ++a) {
    auto where = cells.boxOf(cells.arcs.cell[a]);
    where.upper[cells.arcs.axis[a]] = where.lower[cells.arcs.axis[a]];
    expectWithin(where, points.arc.pointsOf(a));
  }
  EXPECT_GT(cells.arcs.area.size(), 200U);
}

/// Coarse cells are as wide as the period in the end.
TEST(PeriodicSolidsTest, CoarseCellsKeepWhatIsAcrossTheEnds) {
  const SolidCutter cutter(repeatedWall(), FluidSide::Outside, {.period = {1, 1, 1}});
  auto cells = unitPeriod(cutter, 8);
  const double volume = check(cells).fluidVolume;
  EXPECT_EQ(CutRegions(cells).regions().size(), 2U);
  for (int level = 0; level < 3; ++level) {
    const auto certified = cutter.certified(cells, {.width = 0.2});
    EXPECT_TRUE(certified.doubtful.empty());
    for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
      const auto& share = certified.volumeFraction[row];
      const double found =
          fluidIn(cells, cells.cells.index[row]) / cells.cellVolume(cells.cells.index[row]);
      EXPECT_GT(found, share.lower - 1e-6);
      EXPECT_LT(found, share.upper + 1e-6);
      EXPECT_LT(share.upper - share.lower, 0.21);
    }
    cells = coarsened(cells, {2, 2, 2});
    EXPECT_NEAR(check(cells).fluidVolume, volume, 1e-13);
  }
  EXPECT_EQ(cells.cellCount, 1U);
  EXPECT_EQ(cells.pieceCount, 2U);
  EXPECT_FALSE(cells.arcs.area.empty());
}

TEST(PeriodicSolidsTest, SinglePrecisionRepeatsToTheBit) {
  const SolidCutter cutter(Solid<float>(Sphere<float>({0.1F, 0.5F, 0.9F}, 0.4F)),
                           FluidSide::Outside, {.period = {1, 1, 1}});
  expectRepeats(cutter, 8, 0);
  EXPECT_NEAR(check(unitPeriod(cutter, 8)).bodyVolume, 4 * kPiOfPeriods / 3 * 0.064, 1e-6);
}

TEST(PeriodicSolidsTest, RefusesWhatDoesNotRepeat) {
  const auto refused = [](const Solid<double>& solid, const Vec3<double>& period) {
    return refusal([&] { (void)SolidCutter(solid, FluidSide::Outside, {.period = period}); });
  };
  const Solid<double> rod(InfiniteCylinder<double>({0.5, 0.5, 0.5}, {1, 0.1, 0}, 0.2));
  EXPECT_NE(refused(rod, {1, 0, 0}).find("a solid that has bounds, or that is the same a period"),
            std::string::npos);
  EXPECT_NE(refused(repeatedWall(), {1, 1.5, 1}).find("axis = 1"), std::string::npos);
  const Solid<double> floor(Plane<double>({0, 0, 0.4}, {0, 0, 1}));
  EXPECT_NE(refused(floor, {1, 1, 1}).find("axis = 2"), std::string::npos);
  EXPECT_NE(refused(turnedBox(), {-1, 0, 0}).find("not negative"), std::string::npos);
  const SolidCutter cutter(turnedBox(), FluidSide::Outside, {.period = {1, 0, 0}});
  const auto planes = cellsBetween({{{0, 0.5, 1}, {0, 0.5, 1}, {0, 0.5, 1}}});
  EXPECT_NE(refusal([&] { (void)cutter.cut(planes); }).find("cellsOfPeriod()"), std::string::npos);
  EXPECT_NE(refusal([&] { (void)cutter.cutInPlane(planes, 0.5); }).find("no periods in a plane"),
            std::string::npos);
}

}  // namespace
}  // namespace cutwater::test
