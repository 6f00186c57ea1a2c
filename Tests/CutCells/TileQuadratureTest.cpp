#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "CutCells/OpenCells.hpp"
#include "CutCells/PeriodicCells.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "CutCells/Sheets.hpp"
#include "CutCells/ShellCells.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

const CutOptions kBoth{.moments = 4, .quadrature = true};

/// Expects that the points of a row integrate monomials about a center as moments say, within
/// rounding of cells of this size.
void expectIntegrals(const CutCells::PointRows& rows, std::size_t row,
                     std::span<const double> moments, const Vec3<double>& center, double size,
                     int power) {
  for (std::size_t i = 0; i < moments.size(); ++i) {
    long double sum = 0;  // of thousands of points
    for (std::size_t n = 0; n < rows.pointsOf(row).size(); ++n) {
      sum += rows.weightsOf(row)[n] * monomial(rows.pointsOf(row)[n] - center, kOrder[i]);
    }
    ASSERT_NEAR(double(sum), moments[i], 1e-13 * std::pow(size, power + degreeOf(kOrder[i])))
        << "row " << row << ", moment " << i;
  }
}

/// Those of arcs are of the axes of their face.
void expectIntegralsOfArc(const CutCells::PointRows& rows, std::size_t arc, int axis,
                          std::span<const double> moments, const Vec3<double>& center,
                          double size) {
  for (const auto& powers : kOrder) {
    if (powers[static_cast<std::size_t>(axis)] != 0) continue;
    const auto first = static_cast<std::size_t>(powers[axis == 0 ? 1 : 0]);
    const auto second = static_cast<std::size_t>(powers[axis == 2 ? 1 : 2]);
    double sum = 0;
    for (std::size_t n = 0; n < rows.pointsOf(arc).size(); ++n) {
      const auto& p = rows.pointsOf(arc)[n];
      ASSERT_NEAR(p[axis], center[axis], 1e-15);
      sum += rows.weightsOf(arc)[n] * monomial(p - center, powers);
    }
    ASSERT_NEAR(sum, moments[CutCells::Moments::indexOf(first, second)],
                1e-13 * std::pow(size, 2 + degreeOf(powers)));
  }
}

/// Expects that quadrature and moments agree, which know nothing of each other; cells are cubes of
/// at most this size. Returns the number of pieces.
template <typename Cut>
std::size_t expectMomentsOfPoints(const Cut& cut, double size) {
  const auto& [volume, wall, normals, arc] = cut.quadrature;
  EXPECT_EQ(normals.size(), wall.points.size());
  for (const auto* rows : {&volume, &wall, &arc}) {
    EXPECT_TRUE(std::ranges::all_of(rows->weights, [](double w) { return w > 0; }));
  }
  for (const auto& normal : normals) EXPECT_NEAR(length(normal), 1, 1e-14);
  for (std::size_t p = 0; p < cut.pieces.volume.size() && !testing::Test::HasFailure(); ++p) {
    EXPECT_LE(volume.pointsOf(p).size(), 35U);
    expectIntegrals(volume, p, cut.moments.ofVolume(p), cut.pieces.centroid[p], size, 3);
    expectIntegrals(wall, p, cut.moments.ofWall(p), cut.pieces.wallCentroid[p], size, 2);
    Vec3<double> vector;
    for (auto i = wall.first[p]; i < wall.first[p + 1]; ++i) {
      vector += wall.weights[i] * normals[i];
    }
    EXPECT_LT(length(vector - cut.pieces.wallVector[p]), 1e-13 * size * size);
  }
  for (std::size_t a = 0; a < cut.arcs.area.size() && !testing::Test::HasFailure(); ++a) {
    EXPECT_LE(arc.pointsOf(a).size(), 25U);
    expectIntegralsOfArc(arc, a, cut.arcs.axis[a], cut.moments.ofArc(a), cut.arcs.centroid[a],
                         size);
  }
  return cut.pieces.volume.size();
}

TEST(TileQuadratureTest, IntegratesAsMomentsDo) {
  std::mt19937 random(5);
  std::size_t pieces = 0;
  auto plates = tessellation::box({-1, -1, 0.43}, {2, 2, 0.43 + 1e-6});
  plates = together(plates, tessellation::box({0.2, 0.3, 0.5}, {0.4, 0.7, 0.9}));
  std::vector<PolygonSoup> soups{placedTorus(), plates};
  for (int n = 0; n < scaled(3); ++n) soups.push_back(meshOf(randomVoxels(random)).soup());
  for (const auto& soup : soups) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      for (const int n : {1, 5}) {
        const CellCutter cutter(Solid<double>(MeshSDF<double>(soup)), side);
        pieces += expectMomentsOfPoints(cutter.cut(unitGrid(n), kBoth), 1.0 / n);
      }
    }
  }
  EXPECT_GT(pieces, 300U);
}

TEST(TileQuadratureTest, WhereTrianglesMeetAndAtBaffles) {
  const auto balls = joined({ball(0.3, {0.35, 0.4, 0.51}, 2), ball(0.27, {0.6, 0.62, 0.48}, 2)});
  const auto fins = beside(called("hull", ball(0.3, kMiddle, 2)),
                           sheet({0.1, 0.15, 0.42}, {0.7, 0.2, 0.1}, {0.1, 0.7, 0.05}));
  std::size_t meeting = 0;
  for (const int n : {1, 4}) {
    const auto cells = CellCutter(solidOf(balls)).cut(unitGrid(n), kBoth);
    meeting += check(cells).meetingCells;
    expectMomentsOfPoints(cells, 1.0 / n);
    const CellCutter cutter(solidOf(fins), FluidSide::Outside, {.baffles = {"fin"}});
    const auto cellsOfFins = cutter.cut(unitGrid(n), kBoth);
    meeting += check(cellsOfFins).meetingCells;
    expectMomentsOfPoints(cellsOfFins, 1.0 / n);
  }
  EXPECT_GT(meeting, 30U);
}

TEST(TileQuadratureTest, OfOpenPatches) {
  const auto duct = ductOf(tessellation::box({0.25, 0.2, 0.3}, {0.75, 0.9, 0.8}));
  const auto cells = CellCutter(duct, FluidSide::Inside, kEndsOpen).cut(unitGrid(4), kBoth);
  EXPECT_FALSE(cells.openArcs.arc.empty());
  EXPECT_GT(expectMomentsOfPoints(cells, 0.25), 10U);
}

TEST(TileQuadratureTest, OfPeriods) {
  const CellCutter cutter(solidOf(placedTorus()), FluidSide::Outside,
                          {.period = {0.75, 0.75, 0.75}});
  const auto planes = planesOfPeriod(5, 0, 0.75);
  const IndexBox box{{-7, 2, 1}, {-2, 6, 5}};
  const auto cells = cutter.cut(cutter.cellsOfPeriod({planes, planes, planes}, {}, box), kBoth);
  EXPECT_GT(expectMomentsOfPoints(cells, 0.15), 50U);
}

TEST(TileQuadratureTest, OfLeaves) {
  std::mt19937 random(22);
  const CellCutter cutter(turnedTorus());
  for (int n = 0; n < scaled(2); ++n) {
    const auto mesh = dividedMesh(random, 4, 0, 1, 80);
    const auto leaves = cutter.cut(mesh, kBoth);
    EXPECT_GT(expectMomentsOfPoints(leaves, 1), 20U);
  }
}

TEST(TileQuadratureTest, PointsLieInTheFluid) {
  const auto torus = solidOf(placedTorus());
  for (const int degree : {0, 2, 3}) {
    const auto cells = CellCutter(torus, FluidSide::Inside)
                           .cut(unitGrid(6), {.quadrature = true, .quadratureDegree = degree});
    const auto& [volume, wall, normals, arc] = cells.quadrature;
    for (std::size_t p = 0; p < cells.pieces.volume.size(); ++p) {
      const auto box = cells.boxOf(cells.cells.index[cells.pieces.cell[p]]);
      for (const auto& at : volume.pointsOf(p)) {
        ASSERT_LT(torus.signedDistance(at), 1e-15);
        ASSERT_TRUE(box.contains(at));
      }
      for (const auto& at : wall.pointsOf(p)) {
        ASSERT_LT(std::abs(torus.signedDistance(at)), 1e-15);
        ASSERT_TRUE(box.grown(1e-15).contains(at));
      }
    }
    for (const auto& at : arc.points) ASSERT_LT(torus.signedDistance(at), 1e-15);
  }
}

/// A plate of 2^-30 between two cells' planes: relative to its own moments.
TEST(TileQuadratureTest, ThinPlatesLoseNoDigits) {
  const double thickness = 0x1p-30;
  const Box<double> plate{{0, 0, 0.40625}, {1, 1, 0.40625 + thickness}};
  const auto soup = tessellation::box({-1, -1, plate.lower.z}, {2, 2, plate.upper.z});
  const auto cells = CellCutter(solidOf(soup), FluidSide::Inside).cut(unitGrid(1), kBoth);
  ASSERT_EQ(cells.pieceCount, 1U);
  const auto& rows = cells.quadrature.volume;
  const auto center = plate.center();
  for (const auto& powers : kOrder) {
    double sum = 0;
    for (std::size_t n = 0; n < rows.pointsOf(0).size(); ++n) {
      sum += rows.weightsOf(0)[n] * monomial(rows.pointsOf(0)[n] - center, powers);
    }
    const Box<double> centered{plate.lower - center, plate.upper - center};
    EXPECT_NEAR(sum, ofBox(powers, centered), 1e-6 * std::pow(thickness, 1 + powers[2]));
  }
}

/// Of the box that is cut, and of threads, nothing depends.
TEST(TileQuadratureTest, TheSameBitsOfOtherBoxes) {
  const CellCutter cutter(turnedTorus());
  const Level<double> level({0, 0, 0}, {0.07, 0.07, 0.07});
  const auto whole = cutter.cut(GridPatch<double>{level, IndexBox::ofSize(15, 15, 15)},
                                {.quadrature = true, .threads = 1});
  const auto part = cutter.cut(GridPatch<double>{level, {{3, 2, 1}, {11, 12, 13}}},
                               {.polygons = true, .quadrature = true, .threads = 2});
  std::size_t same = 0;
  for (std::uint32_t row = 0; row < part.cellCount; ++row) {
    const auto other = whole.rowOf(part.cells.index[row]);
    ASSERT_NE(other, CutCells::kNoRow);
    const auto shift = whole.cells.firstPiece[other] - part.cells.firstPiece[row];
    for (auto p = part.cells.firstPiece[row]; p < part.cells.firstPiece[row + 1]; ++p, ++same) {
      const auto& [volume, wall, normals, arc] = part.quadrature;
      const auto& [otherVolume, otherWall, otherNormals, otherArc] = whole.quadrature;
      EXPECT_TRUE(std::ranges::equal(volume.pointsOf(p), otherVolume.pointsOf(p + shift)));
      EXPECT_TRUE(std::ranges::equal(volume.weightsOf(p), otherVolume.weightsOf(p + shift)));
      EXPECT_TRUE(std::ranges::equal(wall.pointsOf(p), otherWall.pointsOf(p + shift)));
      EXPECT_TRUE(std::ranges::equal(wall.weightsOf(p), otherWall.weightsOf(p + shift)));
    }
  }
  EXPECT_GT(same, 100U);
  EXPECT_TRUE(whole.arcPolygons.points.empty());
  EXPECT_FALSE(part.arcPolygons.points.empty());
}

TEST(TileQuadratureTest, DegreesFromZeroToFour) {
  const CellCutter cutter(turnedTorus());
  for (const int degree : {-1, 5}) {
    EXPECT_THROW((void)cutter.cut(unitGrid(2), {.quadratureDegree = degree}), Error);
  }
  EXPECT_THROW((void)cutter.cutInPlane(planesOf(unitGrid(2)), 0.5, {.quadrature = true}), Error);
  EXPECT_TRUE(cutter.cut(unitGrid(2)).quadrature.volume.first.empty());
}

}  // namespace
}  // namespace cutwater::test
