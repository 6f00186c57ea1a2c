// Volumes, areas and open parts of cells of shapes against closed forms.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Ellipsoid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "CutCells/ShellCells.hpp"

namespace cutwater::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-13;

struct Known {
  Solid<double> solid;
  double volume = 0;
  double area = 0;
};

Known ballOf(const Vec3<double>& center, double radius) {
  return {Sphere<double>(center, radius), 4 * kPi / 3 * std::pow(radius, 3),
          4 * kPi * radius * radius};
}
Known torusOf(const Vec3<double>& axis, double major, double minor) {
  return {Torus<double>({0.513, 0.507, 0.489}, axis, major, minor),
          2 * kPi * kPi * major * minor * minor, 4 * kPi * kPi * major * minor};
}
Known cylinderOf(const Vec3<double>& from, const Vec3<double>& to, double radius) {
  const double height = length(to - from);
  return {Cylinder<double>(from, to, radius), kPi * radius * radius * height,
          2 * kPi * radius * (radius + height)};
}
/// Two balls of one radius, this far apart: their union, or what they have in common.
Known ballsOf(double radius, double distance, bool isUnion) {
  const auto half = 0.5 * distance * normalized(Vec3<double>{1, 0.5, 0.3});
  const Vec3<double> middle{0.51, 0.49, 0.505};
  const Sphere<double> one(middle - half, radius);
  const Sphere<double> other(middle + half, radius);
  const double height = radius - 0.5 * distance;
  const double cap = kPi * height * height * (3 * radius - height) / 3;
  const double capArea = 2 * kPi * radius * height;
  if (!isUnion) return {one & other, 2 * cap, 2 * capArea};
  const auto ball = ballOf(middle, radius);
  return {one | other, 2 * (ball.volume - cap), 2 * (ball.area - capArea)};
}

struct Errors {
  double volume = 0;
  double area = 0;
};
Errors errorsOf(const Known& known, int cells, const SolidCutterOptions& options) {
  const auto report =
      check(SolidCutter(known.solid, FluidSide::Outside, options).cut(unitGrid(cells)));
  EXPECT_LT(report.worstClosure, 1e-14);
  EXPECT_EQ(report.lostPieces, 0U);
  EXPECT_EQ(report.outOfRange, 0U);
  return {std::abs(report.bodyVolume / known.volume - 1),
          std::abs(report.wallArea / known.area - 1)};
}

/// Errors fall as the width to the power of twice the points, or are rounding.
TEST(SolidCutterTest, ErrorsOfSmoothSolidsFallWithTwiceThePoints) {
  const std::vector<Known> solids{ballOf({0.513, 0.507, 0.489}, 0.37),
                                  torusOf({0, 0, 1}, 0.29, 0.11), torusOf({3, -2, 4}, 0.28, 0.13)};
  for (const auto& known : solids) {
    for (int points = 2; points <= 4; ++points) {
      const SolidCutterOptions options{.points = points, .tolerance = 1};
      const auto coarse = errorsOf(known, 24, options);
      const auto fine = errorsOf(known, 48, options);
      const double factor = std::pow(2, 2 * points - 1);
      EXPECT_LT(fine.volume, std::max(kRounding, coarse.volume / factor)) << points;
      EXPECT_LT(fine.area, std::max(kRounding, coarse.area / factor)) << points;
    }
  }
}

TEST(SolidCutterTest, ErrorsOfABallFallToRounding) {
  const auto ball = ballOf({0.513, 0.507, 0.489}, 0.37);
  const auto found = errorsOf(ball, 48, {.points = 6});
  EXPECT_LT(found.volume, 1e-14);
  EXPECT_LT(found.area, 1e-14);
}

TEST(SolidCutterTest, BoxesInPlanesOfTheGridAndBetweenThemAreExact) {
  const std::vector<Box<double>> boxes{{{0.25, 0.25, 0.375}, {0.75, 0.625, 0.75}},
                                       {{0.2, 0.28, 0.33}, {0.81, 0.7, 0.83}},
                                       {{0.25, 0.3, 0.33}, {0.26, 0.70, 0.83}}};
  for (const auto& box : boxes) {
    const auto size = box.size();
    const Known known{Cuboid<double>(box.lower, box.upper), size.x * size.y * size.z,
                      2 * (size.x * size.y + size.y * size.z + size.z * size.x)};
    const auto found = errorsOf(known, 16, {.points = 1});
    EXPECT_LT(found.volume, kRounding);
    EXPECT_LT(found.area, kRounding);
  }
}

/// Walls with edges: orders of smooth ones, but for cells with corners and slivers.
TEST(SolidCutterTest, EdgesAreFollowed) {
  Cuboid<double> box({-0.3, -0.22, -0.17}, {0.31, 0.2, 0.33});
  box.rotate(17, {1, 2, 3});
  box.translate({0.5, 0.5, 0.5});
  const std::vector<Known> solids{
      {box, 0.61 * 0.42 * 0.5, 2 * (0.61 * 0.42 + 0.61 * 0.5 + 0.42 * 0.5)},
      cylinderOf({0.3, 0.35, 0.4}, {0.7, 0.67, 0.63}, 0.21),
      cylinderOf({0.5, 0.52, 0.2}, {0.5, 0.52, 0.81}, 0.27),
      ballsOf(0.2, 0.21, true),
      ballsOf(0.4, 0.5, false)};
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const auto found = errorsOf(solids[i], 24, {});
    EXPECT_LT(found.volume, 3e-6) << i;
    EXPECT_LT(found.area, 5e-5) << i;
  }
}

TEST(SolidCutterTest, SectionsAreThoseOfTheFormula) {
  const auto grid =
      cellsBetween({planesOf(unitGrid(16)).planes[0], planesOf(unitGrid(16)).planes[1], {0, 1}});
  const double r = 0.37;
  const double z = 0.6;
  const auto ring = std::sqrt(r * r - 0.11 * 0.11);
  const SolidCutter ball(Solid<double>(Sphere<double>({0.513, 0.507, 0.49}, r)));
  const auto disc = check(ball.cutInPlane(grid, z));
  EXPECT_NEAR(disc.bodyVolume, kPi * ring * ring, 1e-8);
  EXPECT_NEAR(disc.wallArea, 2 * kPi * ring, 1e-6);
  EXPECT_LT(disc.worstClosure, 1e-14);
  EXPECT_EQ(disc.lostPieces, 0U);
  const Solid<double> torus = Torus<double>({0.513, 0.507, 0.5}, {0, 0, 1}, 0.29, 0.11);
  const auto annulus = check(SolidCutter(torus).cutInPlane(grid, 0.5));
  EXPECT_NEAR(annulus.bodyVolume, kPi * (0.4 * 0.4 - 0.18 * 0.18), 1e-6);
  EXPECT_NEAR(annulus.wallArea, 2 * kPi * (0.4 + 0.18), 1e-5);
  // A box, in planes of the grid and between them.
  const SolidCutter box(Solid<double>(Cuboid<double>({0.25, 0.3, 0.1}, {0.75, 0.7, 0.9})));
  EXPECT_NEAR(check(box.cutInPlane(grid, z)).bodyVolume, 0.5 * 0.4, 1e-14);
  EXPECT_NEAR(check(box.cutInPlane(grid, z)).wallArea, 1.8, 1e-13);
  EXPECT_EQ(box.cutInPlane(grid, 0.95).cellCount, 0U);
}

TEST(SolidCutterTest, FluidOnBothSidesFillsTheCells) {
  const std::vector<Solid<double>> solids{
      ballOf({0.5, 0.5, 0.5}, 0.37).solid, ballsOf(0.3, 0.2, true).solid,
      Cuboid<double>({0.25, 0.25, 0.25}, {0.5, 0.5, 0.75}),
      TpmsSolid<double>(TpmsField<double>(TpmsPattern::gyroid(), 1), TpmsPart::Wall, 0.3)};
  for (const auto& solid : solids) {
    std::array<CutCellsReport, 2> reports;
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      const auto cells = SolidCutter(solid, side).cut(unitGrid(8));
      reports[side == FluidSide::Outside ? 0 : 1] = check(cells);
    }
    EXPECT_NEAR(reports[0].fluidVolume + reports[1].fluidVolume, 1, 1e-7);
    EXPECT_NEAR(reports[0].wallArea, reports[1].wallArea, 1e-6);
  }
}

TEST(SolidCutterTest, StatedErrorsCoverTheErrors) {
  const auto known = ballsOf(0.2, 0.21, true);
  for (const int points : {1, 2, 3}) {
    const auto cells =
        SolidCutter(known.solid, FluidSide::Outside, {.points = points, .tolerance = 1})
            .cut(unitGrid(16));
    double stated = 0;
    for (std::size_t row = 0; row < cells.cellCount; ++row) {
      stated += cells.cells.error[row] * cells.cellVolume(cells.cells.index[row]);
    }
    const double error = std::abs(check(cells).bodyVolume - known.volume);
    EXPECT_LT(error, stated) << points;
    EXPECT_GT(error, 1e-6 * stated) << points;
  }
}

TEST(SolidCutterTest, AMeshAgreesWithItsSolidWithinItsOwnError) {
  const Vec3<double> center{0.51, 0.49, 0.505};
  const auto mesh = CellCutter(solidOf(ball(0.37, center, 5))).cut(unitGrid(16));
  const auto exact = SolidCutter(Solid<double>(Sphere<double>(center, 0.37))).cut(unitGrid(16));
  ASSERT_EQ(exact.cellCount, mesh.cellCount);
  const double chord = 3e-5 * 16;  // of the mesh: by how much its triangles lie within the ball
  double largest = 0;
  for (std::uint32_t row = 0; row < mesh.cellCount; ++row) {
    ASSERT_EQ(exact.cells.index[row], mesh.cells.index[row]);
    EXPECT_EQ(exact.cells.fluidCorners[row], mesh.cells.fluidCorners[row]);
    largest = std::max(largest, std::abs(exact.volumeFraction(row) - mesh.volumeFraction(row)));
  }
  EXPECT_LT(largest, 4 * chord);
  EXPECT_GT(largest, 0.1 * chord);
}

TEST(SolidCutterTest, SinglePrecisionIsAsGoodAsItsValues) {
  const Solid<float> ball = Sphere<float>({0.5F, 0.5F, 0.5F}, 0.37F);
  const auto report = check(SolidCutter(ball).cut(unitGrid(16)));
  EXPECT_NEAR(report.bodyVolume, ballOf({}, 0.37F).volume, 1e-6);
  EXPECT_LT(report.worstClosure, 1e-14);
}

TEST(SolidCutterTest, FunctionsWithoutALipschitzConstantAreCutByTheirSigns) {
  const FunctionSDF<double, double (*)(const Vec3<double>&)> function(
      [](const Vec3<double>& p) {
        return 5 * (lengthSquared(p - Vec3<double>{0.5, 0.5, 0.5}) - 0.1369);
      },
      Guarantee<double>{.lipschitz = std::nullopt, .continuous = true, .size = 1});
  const auto report = check(SolidCutter(Solid<double>(function)).cut(unitGrid(16)));
  const auto known = ballOf({}, 0.37);
  EXPECT_NEAR(report.bodyVolume, known.volume, 1e-4);
  EXPECT_NEAR(report.wallArea, known.area, 1e-3);
}

TEST(SolidCutterTest, WrongArgumentsAreRefused) {
  const Solid<double> ball = Sphere<double>({0.5, 0.5, 0.5}, 0.3);
  EXPECT_THROW(SolidCutter(ball, FluidSide::Outside, {.points = 0}), Error);
  EXPECT_THROW(SolidCutter(ball, FluidSide::Outside, {.points = 7}), Error);
  EXPECT_THROW(SolidCutter(ball, FluidSide::Outside, {.tolerance = 0}), Error);
  const SolidCutter cutter(ball);
  EXPECT_THROW((void)cutter.cutInPlane(planesOf(unitGrid(4)), 0.5, {.polygons = true}), Error);
  EXPECT_THROW((void)cutter.cut(unitGrid(4), {.moments = 5}), Error);
  EXPECT_THROW((void)cutter.cutInPlane(planesOf(unitGrid(4)), 0.5, {.moments = 0}), Error);
  EXPECT_THROW((void)cutter.cutInPlane(planesOf(unitGrid(4)), 0.5, {.quadrature = true}), Error);
  auto planes = planesOf(unitGrid(4));
  planes.planes[1][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)cutter.cut(planes), Error);
}

}  // namespace
}  // namespace cutwater::test
