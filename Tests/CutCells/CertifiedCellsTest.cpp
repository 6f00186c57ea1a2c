// Intervals that certainly enclose what cells and faces have of the fluid, and what they found.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "Support/RandomTrees.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using std::numbers::pi;
constexpr double kRounding = 1e-12;

double widthOf(const Interval<double>& interval) {
  return interval.upper - interval.lower;
}
/// By how much a value lies beyond an interval.
double beyond(const Interval<double>& interval, double value) {
  return std::max({interval.lower - value, value - interval.upper, 0.0});
}
double fluidOf(const CutCells& cells, std::uint32_t row) {
  double sum = 0;
  for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
    sum += cells.volumeFraction(p);
  }
  return sum;
}

/// Whether an arc is one of the same face as the one before.
bool isOfFaceBefore(const CutCells& cells, std::uint32_t arc) {
  const auto& arcs = cells.arcs;
  return arc > 0 && arcs.cell[arc] == arcs.cell[arc - 1] && arcs.axis[arc] == arcs.axis[arc - 1];
}
/// The share of a face that is open, from its first arc on.
double openOf(const CutCells& cells, std::uint32_t arc) {
  double sum = cells.aperture(arc);
  while (++arc < cells.arcs.area.size() && isOfFaceBefore(cells, arc)) sum += cells.aperture(arc);
  return sum;
}

/// That intervals enclose the rows, where these have no error.
void expectEnclosed(const CutCells& cells, const CertifiedCells& certified, double error) {
  ASSERT_EQ(certified.volumeFraction.size(), cells.cellCount);
  ASSERT_EQ(certified.aperture.size(), cells.arcs.area.size());
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    EXPECT_LE(beyond(certified.volumeFraction[row], fluidOf(cells, row)), error) << row;
  }
  for (std::uint32_t arc = 0; arc < cells.arcs.area.size(); ++arc) {
    if (isOfFaceBefore(cells, arc)) {
      EXPECT_EQ(certified.aperture[arc], certified.aperture[arc - 1]);
    } else {
      EXPECT_LE(beyond(certified.aperture[arc], openOf(cells, arc)), error) << arc;
    }
  }
  for (const auto& [cell, share] : certified.doubtful) {
    EXPECT_EQ(cells.rowOf(cell), CutCells::kNoRow);
    EXPECT_LE(beyond(share, cells.classOf(cell) == FluidClass::Fluid ? 1 : 0), error);
  }
}

std::vector<Solid<double>> someSolids() {
  return {Sphere<double>({0.51, 0.49, 0.505}, 0.37),
          Torus<double>({0.513, 0.507, 0.489}, {1, 0.5, 0.3}, 0.29, 0.11),
          Cuboid<double>({0.2511, 0.2522, 0.50001}, {0.7513, 0.757, 0.50002}),
          Solid<double>(Sphere<double>({0.4, 0.5, 0.5}, 0.25)) |
              Sphere<double>({0.6, 0.52, 0.47}, 0.25),
          TpmsSolid<double>(TpmsField<double>(TpmsPattern::gyroid(), 1), TpmsPart::Wall, 0.3)};
}

TEST(CertifiedCellsTest, EncloseWhatIsFoundAsNarrowlyAsAsked) {
  for (const auto& solid : someSolids()) {
    SCOPED_TRACE(solid.describe());
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      const SolidCutter cutter(solid, side);
      const auto cells = cutter.cut(unitGrid(8));
      ASSERT_GT(cells.cellCount, 15U);
      const auto certified = cutter.certified(cells, {.width = 0.12, .boxes = 100'000});
      expectEnclosed(cells, certified, 1e-5);
      EXPECT_TRUE(certified.doubtful.empty());
      double widest = 0;
      for (const auto& share : certified.volumeFraction) widest = std::max(widest, widthOf(share));
      for (const auto& share : certified.aperture) widest = std::max(widest, widthOf(share));
      EXPECT_LE(widest, 0.12 * (1 + kRounding));
      EXPECT_GT(widest, 0.03);
    }
  }
}

TEST(CertifiedCellsTest, AreNarrowerForMoreBoxes) {
  const SolidCutter cutter(Solid<double>(Sphere<double>({0.51, 0.49, 0.505}, 0.37)));
  const auto cells = cutter.cut(unitGrid(6));
  double before = 1;
  for (const std::size_t boxes : {100, 1000, 10'000}) {
    const auto certified = cutter.certified(cells, {.width = 0, .boxes = boxes});
    double sum = 0;
    for (const auto& share : certified.volumeFraction) sum += widthOf(share);
    const double mean = sum / static_cast<double>(cells.cellCount);
    EXPECT_LT(mean, 0.6 * before) << boxes;
    before = mean;
  }
  EXPECT_LT(before, 0.05);
}

TEST(CertifiedCellsTest, DoNotDependOnThreadsAndOrder) {
  const SolidCutter cutter(someSolids()[3]);
  const auto cells = cutter.cut(unitGrid(7));
  const auto one = cutter.certified(cells, {.threads = 1});
  const auto four = cutter.certified(cells, {.threads = 4});
  EXPECT_EQ(one.volumeFraction, four.volumeFraction);
  EXPECT_EQ(one.aperture, four.aperture);
  // Coarser cells are those of the same planes.
  const auto fine = cutter.cut(unitGrid(8));
  const auto coarse = coarsened(fine, {2, 2, 2});
  expectEnclosed(coarse, cutter.certified(coarse), 1e-5);
}

TEST(CertifiedCellsTest, DoubtfulCellsAreThoseThatTheSurfaceTouches) {
  const SolidCutter cutter(Solid<double>(Cuboid<double>({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75})));
  const auto cells = cutter.cut(unitGrid(8));
  const auto certified = cutter.certified(cells);
  expectEnclosed(cells, certified, kRounding);
  // Of the cells at the box's sides, rows are those outside, where the fluid is: left are those
  // within, and those beside edges. Beside corners, all but 1e-12 of a cell is known.
  const std::size_t within = 4 * 4 * 4 - 2 * 2 * 2;
  const std::size_t beside = 12 * 4;
  EXPECT_EQ(certified.doubtful.size(), within + beside);
  const auto isBefore = [](const auto& a, const auto& b) {
    return std::tuple(a.cell.k, a.cell.j, a.cell.i) < std::tuple(b.cell.k, b.cell.j, b.cell.i);
  };
  EXPECT_TRUE(std::ranges::is_sorted(certified.doubtful, isBefore));
  for (const auto& [cell, share] : certified.doubtful) EXPECT_LT(widthOf(share), 0.1);
}

TEST(CertifiedCellsTest, SectionsAreEnclosedAsAreas) {
  const double r = 0.37;
  const double z = 0.6;
  const SolidCutter cutter(Solid<double>(Sphere<double>({0.513, 0.507, 0.49}, r)));
  const auto grid = planesOf(unitGrid(9));
  const auto cells = cutter.cutInPlane(cellsBetween({grid.planes[0], grid.planes[1], {0, 1}}), z);
  const auto certified = cutter.certifiedInPlane(cells, z, {.width = 0.01});
  expectEnclosed(cells, certified, 1e-6);
  Interval<double> body;
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    const double area = cells.cellVolume(cells.cells.index[row]);
    EXPECT_LE(widthOf(certified.volumeFraction[row]), 0.01 * (1 + kRounding));
    body.lower += area * (1 - certified.volumeFraction[row].upper);
    body.upper += area * (1 - certified.volumeFraction[row].lower);
  }
  double whole = check(cells).bodyVolume;
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    whole -= cells.cellVolume(cells.cells.index[row]) * (1 - fluidOf(cells, row));
  }
  EXPECT_TRUE(body.contains(pi * (r * r - 0.11 * 0.11) - whole));
}

TEST(CertifiedCellsTest, NothingIsCertainOfFunctionsWithoutAGuarantee) {
  const FunctionSDF<double, double (*)(const Vec3<double>&)> function(
      [](const Vec3<double>& p) {
        return 5 * (lengthSquared(p - Vec3<double>{0.5, 0.5, 0.5}) - 0.1369);
      },
      Guarantee<double>{.lipschitz = std::nullopt, .continuous = true, .size = 1});
  const SolidCutter cutter{Solid<double>(function)};
  const auto cells = cutter.cut(unitGrid(4));
  const auto certified = cutter.certified(cells);
  for (const auto& share : certified.volumeFraction) EXPECT_GE(widthOf(share), 1 - kRounding);
  EXPECT_EQ(certified.doubtful.size(), 64 - cells.cellCount);
}

TEST(CertifiedCellsTest, SinglePrecisionNeedsPlanesOfItsOwn) {
  const SolidCutter cutter{Solid<float>(Sphere<float>({0.5F, 0.5F, 0.5F}, 0.37F))};
  const auto cells = cutter.cut(unitGrid(8));  // eighths are numbers of both
  expectEnclosed(cells, cutter.certified(cells), 1e-5);
  EXPECT_THROW((void)cutter.certified(cutter.cut(unitGrid(10))), Error);
  const auto planes = planesOf(unitGrid(8));
  EXPECT_NO_THROW((void)cutter.certifiedInPlane(cutter.cutInPlane(planes, 0.5), 0.5));
  EXPECT_THROW((void)cutter.certifiedInPlane(cutter.cutInPlane(planes, 0.5), 0.1), Error);
}

TEST(CertifiedCellsTest, WrongArgumentsAreRefused) {
  const SolidCutter cutter(someSolids()[0]);
  const auto cells = cutter.cut(unitGrid(4));
  EXPECT_THROW((void)cutter.certified(cells, {.width = -0.1}), Error);
  EXPECT_THROW((void)cutter.certified(cells, {.width = 1.1}), Error);
  EXPECT_THROW((void)cutter.certified(cells, {.boxes = 0}), Error);
}

TEST(CertifiedCellsTest, WallsThatMeetNoEdgeAreFound) {
  // A wire of a quarter of a cell, which passes through faces; its volume in the unit cube.
  const double r = 0.12 / 8;
  const auto direction = normalized(Vec3<double>{1, 0.11, -0.07});
  const Vec3<double> middle{0.5, 0.5625, 0.5625};
  const Solid<double> wire = Cylinder<double>(middle - 2 * direction, middle + 2 * direction, r);
  const SolidCutter cutter(wire);
  const auto cells = cutter.cut(unitGrid(8));
  const auto report = check(cells);
  const double length = 1 / direction.x;
  EXPECT_NEAR(report.bodyVolume, pi * r * r * length, 1e-3 * pi * r * r * length);
  EXPECT_NEAR(report.wallArea, 2 * pi * r * length, 5e-2 * 2 * pi * r * length);
  EXPECT_GE(report.thinCells, 6U);
  expectEnclosed(cells, cutter.certified(cells, {.width = 0.01}), 1e-6);
  EXPECT_TRUE(cutter.certified(cells).doubtful.empty());
}

TEST(CertifiedCellsTest, SmallBallsAreFoundOrDoubtful) {
  std::mt19937 random(5);
  int doubtful = 0;
  int missed = 0;
  std::uniform_real_distribution<> within(0.1, 0.9);
  for (int round = 0; round < scaled(40); ++round) {
    const Vec3<double> center{within(random), within(random), within(random)};
    const double r = 0.0125 * within(random);
    const SolidCutter cutter(Solid<double>(Sphere<double>(center, r)));
    const auto cells = cutter.cut(unitGrid(8));
    const auto certified = cutter.certified(cells);
    const double volume = 4 * pi / 3 * r * r * r;
    double stated = 0;
    for (std::size_t row = 0; row < cells.cellCount; ++row) {
      stated += cells.cells.error[row] * cells.cellVolume(cells.cells.index[row]);
    }
    for (const auto& doubt : certified.doubtful) {
      ++doubtful;
      stated += widthOf(doubt.volumeFraction) * cells.cellVolume(doubt.cell);
    }
    const double error = std::abs(check(cells).bodyVolume - volume);
    EXPECT_LE(error, 2 * stated + 1e-9) << center << ' ' << r;
    missed += error > 1e-7 ? 1 : 0;
  }
  EXPECT_LE(doubtful, 2 + scaled(40) / 10);
  EXPECT_LE(missed, 2 + scaled(40) / 5);  // those in faces, by up to half of their volume
}

TEST(CertifiedCellsTest, RowsOfRandomCompositesLieWithinTheirErrors) {
  int cut = 0;
  int doubtful = 0;
  for (int round = 0; round < scaled(12); ++round) {
    RandomTrees<double> trees(static_cast<unsigned>(round) + 22);
    const auto solid = trees.tree(round % 3);
    SCOPED_TRACE(solid.describe());
    const SolidCutter cutter(solid);
    const auto cells = cutter.cut(unitGrid(4, -1.2, 1.2));
    const auto certified = cutter.certified(cells, {.width = 0.02});
    for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
      EXPECT_LE(beyond(certified.volumeFraction[row], fluidOf(cells, row)),
                cells.cells.error[row] + 1e-9)
          << row;
    }
    for (const auto& [cell, share] : certified.doubtful) {
      EXPECT_LE(beyond(share, cells.classOf(cell) == FluidClass::Fluid ? 1 : 0), 1e-9);
      ++doubtful;
    }
    cut += static_cast<int>(cells.cellCount);
  }
  EXPECT_GT(cut, scaled(12) * 5);
  EXPECT_LT(doubtful, cut / 10 + 5);
}

}  // namespace
}  // namespace cutwater::test
