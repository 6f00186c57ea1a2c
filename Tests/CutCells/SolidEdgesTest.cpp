// Cells with edges and corners of solids, which are found from the surfaces that meet there,
// against closed forms and against the same solids as meshes.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/BoxFrame.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Polygon.hpp>
#include <Cutwater/Shapes/Revolution.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/MomentCells.hpp"
#include "CutCells/ShellCells.hpp"
#include "Support/CutIdentities.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

const Vec3<double> kAxis{1, 2, 3};
const Vec3<double> kMiddle{0.5, 0.5, 0.5};

/// The fluid of each cell that is cut.
std::map<std::tuple<int, int, int>, double> fluidByCell(const CutCells& cells) {
  std::map<std::tuple<int, int, int>, double> fluid;
  for (std::size_t row = 0; row < cells.cellCount; ++row) {
    const auto& index = cells.cells.index[row];
    for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
      fluid[{index.i, index.j, index.k}] += cells.pieces.volume[p];
    }
  }
  return fluid;
}

/// Unions of turned boxes, as meshes and as shapes: what no edge and no corner is cut off of has
/// the same volume in each cell, but for rounding.
TEST(SolidEdgesTest, TurnedBoxesAreThoseOfTheirMeshes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(0.15, 0.85);
  std::uniform_real_distribution<double> angle(0, 180);
  std::size_t compared = 0;
  for (int round = 0; round < scaled(12); ++round) {
    SCOPED_TRACE(round);
    std::vector<Box<double>> boxes;
    std::optional<Solid<double>> shapes;
    for (int i = 0; i <= round % 3; ++i) {
      const Vec3<double> a{at(random), at(random), at(random)};
      const Vec3<double> b{at(random), at(random), at(random)};
      boxes.push_back({min(a, b), max(a, b) + Vec3<double>{0.01, 0.01, 0.01}});
      const Solid<double> shape = Cuboid<double>(boxes.back());
      shapes = shapes ? *shapes | shape : shape;
    }
    auto mesh = solidOf(soupOf(boxes));
    const double degrees = angle(random);
    mesh.rotate(degrees, kAxis, kMiddle);
    shapes->rotate(degrees, kAxis, kMiddle);
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      const auto ofMesh = fluidByCell(CellCutter(mesh, side).cut(unitGrid(9)));
      const auto found = SolidCutter(*shapes, side).cut(unitGrid(9));
      const auto ofShapes = fluidByCell(found);
      constexpr double kNearShares = 1e-14;  // cells have a volume of 1.4e-3
      for (const auto& [cell, fluid] : ofShapes) {
        const auto other = ofMesh.find(cell);
        if (other == ofMesh.end()) continue;  // touched in one of them
        EXPECT_NEAR(fluid, other->second, kNearShares);
        ++compared;
      }
      for (const double error : found.cells.error) EXPECT_LT(error, 1e-10);
    }
  }
  EXPECT_GT(compared, 1500U);
}

/// A needle through cells, thinner than what values at any grid of points see.
TEST(SolidEdgesTest, NeedlesAreFound) {
  const double width = 1e-5;
  Solid<double> needle = Cuboid<double>({0.1, 0.513, 0.487}, {0.9, 0.513 + width, 0.487 + width});
  for (const double degrees : {0.0, 17.0}) {
    needle.rotate(degrees, kAxis, kMiddle);
    const auto report = check(SolidCutter(needle, FluidSide::Outside).cut(unitGrid(8)));
    EXPECT_NEAR(report.bodyVolume, 0.8 * width * width, 1e-15);
    EXPECT_NEAR(report.wallArea, 2 * width * width + 4 * 0.8 * width, 1e-14);
  }
}

/// A ball of radius R with a hole of radius r: its volume is 4/3 pi (R^2 - r^2)^(3/2), its surface
/// 4 pi (R + r) (R^2 - r^2)^(1/2).
TEST(SolidEdgesTest, ADrilledBallIsThatOfTheFormula) {
  constexpr double kPi = std::numbers::pi;
  const Vec3<double> middle{0.507, 0.493, 0.511};
  const double outer = 0.37;
  const double inner = 0.13;
  const auto solid = Solid<double>(Sphere<double>(middle, outer)) -
                     InfiniteCylinder<double>(middle, {3, 1, 2}, inner);
  const double half = std::sqrt(outer * outer - inner * inner);
  for (const int cells : {20, 40}) {
    const SolidCutterOptions options{.points = 5, .tolerance = 1e-9};
    const auto found = SolidCutter(solid, FluidSide::Outside, options).cut(unitGrid(cells));
    const auto report = check(found);
    const double off = std::abs(report.bodyVolume - 4 * kPi / 3 * std::pow(half, 3));
    EXPECT_LT(off, cells == 20 ? 3e-9 : 2e-10);
    EXPECT_NEAR(report.wallArea, 4 * kPi * (outer + inner) * half, cells == 20 ? 3e-10 : 3e-11);
    double stated = 0;
    for (const double error : found.cells.error) stated += error / (cells * cells * cells);
    EXPECT_LT(off, stated);
  }
}

/// Balls that overlap by pairs: of a bed, whose tree gives those near a cell, and of a union.
TEST(SolidEdgesTest, BedsAreUnionsOfTheirBalls) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(0.15, 0.85);
  std::vector<Ball<double>> balls;
  Solid<double> all = Sphere<double>({0.5, 0.5, 0.5}, 0.12);
  balls.push_back({{0.5, 0.5, 0.5}, 0.12});
  for (int i = 0; i < 40; ++i) {
    balls.push_back({{at(random), at(random), at(random)}, 0.12});
    all = all | Sphere<double>(balls.back().center, balls.back().radius);
  }
  const SolidCutterOptions options{.tolerance = 1e-3};
  const auto ofBed =
      SolidCutter(Solid<double>(PackedBed<double>(balls)), FluidSide::Outside, options)
          .cut(unitGrid(16));
  const auto ofUnion = SolidCutter(all, FluidSide::Outside, options).cut(unitGrid(16));
  ASSERT_EQ(ofBed.pieces.volume.size(), ofUnion.pieces.volume.size());
  for (std::size_t p = 0; p < ofBed.pieces.volume.size(); ++p) {
    EXPECT_NEAR(ofBed.pieces.volume[p], ofUnion.pieces.volume[p], 1e-13);
  }
  const auto report = check(ofBed);
  EXPECT_LT(report.worstClosure, 1e-14);
  EXPECT_EQ(report.lostPieces, 0U);
}

/// Boxes turned about one of their edges, which lies in edges of cells and ends within them: no
/// cell states an error, though faces are touched along a part of a side.
TEST(SolidEdgesTest, EdgesInEdgesOfCellsStateNoErrors) {
  for (const double length : {0.4, 0.5}) {
    for (const double angle : {20.0, 45.0, 135.0, -60.0}) {
      for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
        SCOPED_TRACE(angle);
        Cuboid<double> box({0.5 - 0.5 * length, 0, 0}, {0.5 + 0.5 * length, 0.2, 0.2});
        box.rotate(angle, 0);
        box.translate({0, 0.5, 0.5});
        const auto cells = SolidCutter(Solid<double>(box), side).cut(unitGrid(8));
        EXPECT_NEAR(check(cells).bodyVolume,
                    side == FluidSide::Outside ? 0.04 * length : 1 - 0.04 * length, 1e-14);
        EXPECT_LT(std::ranges::max(cells.cells.error), 1e-13);
      }
    }
  }
}

void expectSameVolumes(const Solid<double>& one, const Solid<double>& other) {
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto cells = SolidCutter(one, side).cut(unitGrid(12));
    const auto others = fluidByCell(SolidCutter(other, side).cut(unitGrid(12)));
    EXPECT_LT(std::ranges::max(cells.cells.error), 1e-12);
    const auto fluid = fluidByCell(cells);
    ASSERT_EQ(fluid.size(), others.size());
    for (const auto& [cell, volume] : fluid) EXPECT_NEAR(volume, others.at(cell), 1e-15);
  }
}

TEST(SolidEdgesTest, AFrameIsTheUnionOfItsBars) {
  const Box<double> box{{0.2, 0.25, 0.3}, {0.8, 0.75, 0.7}};
  constexpr double kThickness = 0.12;
  std::vector<Solid<double>> bars;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int end : {0, 1, 2, 3}) {
      auto bar = box;
      const int one = (axis + 1) % 3;
      const int other = (axis + 2) % 3;
      ((end & 1) == 0 ? bar.upper : bar.lower)[one] =
          (end & 1) == 0 ? box.lower[one] + kThickness : box.upper[one] - kThickness;
      ((end & 2) == 0 ? bar.upper : bar.lower)[other] =
          (end & 2) == 0 ? box.lower[other] + kThickness : box.upper[other] - kThickness;
      bars.push_back(Cuboid<double>(bar.lower, bar.upper));
    }
  }
  Solid<double> frame = BoxFrame<double>(box, kThickness);
  auto all = unionOf(bars);
  for (auto* solid : {&frame, &all}) solid->rotate(27, kAxis, kMiddle);
  expectSameVolumes(frame, all);
}

/// Copies that overlap, and copies that do not.
TEST(SolidEdgesTest, CopiesAreTheUnionOfEach) {
  for (const double period : {0.11, 0.27}) {
    SCOPED_TRACE(period);
    Cuboid<double> turned({0, 0, 0}, {0.15, 0.1, 0.2});
    turned.rotate(31, kAxis);
    turned.translate({0.2, 0.25, 0.3});
    std::vector<Solid<double>> copies;
    for (const int i : {0, 1, 2}) {
      for (const int j : {0, 1}) {
        copies.push_back(turned);
        copies.back().translate({i * period, 0, j * period});
      }
    }
    const Repeats<double> repeats{.period = {period, 0, period}, .count = {3, 1, 2}};
    expectSameVolumes(repeated(turned, repeats), unionOf(copies));
  }
}

/// Few enough in the box that is cut, but not in all that surfaces are looked for in around a cell.
TEST(SolidEdgesTest, CellsAmongEndlessCopiesAreCut) {
  constexpr double kHalf = 0.3;
  Cuboid<double> turned({-kHalf, -kHalf, -kHalf}, {kHalf, kHalf, kHalf});
  turned.rotate(27, kAxis);
  const auto cubes = repeated(turned, {.period = {1, 1, 1}});
  const GridPatch<double> grid{Level<double>({0, 0, 0}, {1, 1, 1}), IndexBox::ofSize(2, 2, 2)};
  const auto cells = SolidCutter(cubes).cut(grid);
  ASSERT_EQ(cells.cellCount, 8U);
  const double fluid = 1 - std::pow(2 * kHalf, 3);
  for (std::uint32_t row = 0; row < 8; ++row) {
    EXPECT_NEAR(cells.volumeFraction(cells.cells.firstPiece[row]), fluid, 1e-4);
  }
}

/// More balls in a cell than it can be divided for: each part of it is divided as far as others.
TEST(SolidEdgesTest, ManyBodiesInACellAreFound) {
  constexpr double kRadius = 0.4;
  const auto balls = repeated(Sphere<double>({0.1, 0.2, 0.3}, kRadius), {.period = {1, 1, 1}});
  const GridPatch<double> cell{Level<double>({0, 0, 0}, {2, 2, 2}), IndexBox::ofSize(1, 1, 1)};
  const auto cells = SolidCutter(balls).cut(cell);
  ASSERT_EQ(cells.pieceCount, 1U);
  const double fluid = 1 - 4 * std::numbers::pi / 3 * std::pow(kRadius, 3);
  EXPECT_NEAR(cells.volumeFraction(0), fluid, 2e-3);
}

/// An elongated block, whose gradient along an axis is zero in the gap, reaches into a cell from
/// one side. Beside another body its surface is one of several.
TEST(SolidEdgesTest, ASurfaceThatNoCornerSuspectsIsCut) {
  const auto block = elongated(RoundedBox<double>({0.25, 0.12, 0.35}, {1.2, 0.5, 1.45}, 0.05),
                               Vec3<double>{0.46, 0.01, 0.4});
  const GridPatch<double> cell{Level<double>({0, 0, 0}, {1.2, 1.2, 1.2}),
                               IndexBox::ofSize(1, 1, 1)};
  const auto alone = SolidCutter(block).cut(cell);
  const auto beside = SolidCutter(block | Sphere<double>({30, 0, 0}, 1)).cut(cell);
  ASSERT_EQ(alone.cellCount, 1U);
  ASSERT_EQ(beside.cellCount, 1U);
  EXPECT_NEAR(beside.volumeFraction(0), alone.volumeFraction(0), 1e-5);
}

/// A difference within a union: whether its planes are near must not depend on the tile.
TEST(SolidEdgesTest, FacesBetweenTilesAreTheSameOnBothSides) {
  const Polygon<double> outline({{1.02, -0.1}, {1.12, -0.1}, {1.12, 2.1}, {1.02, 2.1}});
  const auto tube = Revolution<double>(outline) - Cuboid<double>({-2, -2, 0.2}, {2, 0, 3});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-0.7, 0.7);
  std::vector<Ball<double>> balls;
  for (int n = 0; n < 60; ++n) {
    const double x = place(random);
    const double y = place(random);
    balls.push_back({{x, y, 1 + place(random)}, 0.2});
  }
  constexpr int kCells = 20;
  std::array<std::vector<double>, 3> planes;
  for (int n = 0; n <= kCells; ++n) {
    const double at = -1.15 + 2.3 * n / kCells;
    planes[0].push_back(at);
    planes[1].push_back(at);
    planes[2].push_back(at + 1);
  }
  const SolidCutter cutter(Solid<double>(PackedBed<double>(balls)) | tube, FluidSide::Outside,
                           {.tolerance = 1e-3});
  expectIdentities(cutter.cut(cellsBetween(planes)), 1e-14);
}

}  // namespace
}  // namespace cutwater::test
