// Polygons of cells and leaves around surfaces whose shells overlap.

#include <random>

#include <gtest/gtest.h>

#include "CutCells/BoxUnions.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "CutCells/ShellCells.hpp"
#include "CutCells/Tetrahedra.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/PolygonMoments.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

const PolygonSoup& balls() {
  static const auto soup =
      joined({ball(0.3, {0.35, 0.4, 0.51}, 2), ball(0.27, {0.6, 0.62, 0.48}, 2)});
  return soup;
}
/// Plates that cross, and a rod: faces with several parts and holes.
const PolygonSoup& plates() {
  static const auto soup = joined({tessellation::box({-1, -1, 0.37}, {2, 2, 0.38}),
                                   tessellation::box({0.61, -1, -1}, {0.62, 2, 2}),
                                   tessellation::box({-1, 0.403, -1}, {0.7, 0.409, 2}),
                                   tessellation::box({0.3, 0.6, 0.1}, {0.4, 0.7, 0.9})});
  return soup;
}

void expectPolygonsInGrids(const PolygonSoup& soup, std::initializer_list<int> grids) {
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    for (const int n : grids) expectPolygonsOf(cellsOfShells(soup, n, side, {.polygons = true}));
  }
}

TEST(MeetingPolygonsTest, CloseEveryPieceOfBalls) {
  expectPolygonsInGrids(balls(), {1, 2, 5, 16});
  expectPolygonsInGrids(joined({ball(0.4, kMiddle, 1), ball(0.4, kMiddle, 1)}), {1, 4});
}

TEST(MeetingPolygonsTest, CloseEveryPieceOfPlatesThatCross) {
  expectPolygonsInGrids(plates(), {1, 2, 3, 7});
}

TEST(MeetingPolygonsTest, CloseEveryPieceOfUnionsOfBoxes) {
  std::mt19937 random(51);
  for (int round = 0; round < scaled(40) && !HasFailure(); ++round) {
    expectPolygonsInGrids(soupOf(randomBoxes(random, 2 + round % 3)), {1 + round % 4});
    const auto boxes = randomBoxesInPlanes(random, 2 + round % 3, 8);
    expectPolygonsInGrids(soupOf(boxes), {1, 2, 8});
  }
}

/// Where their planes are nearly parallel, corners on their common line are not the same in all
/// polygons, and areas of what lies between these are far more than rounding.
TEST(MeetingPolygonsTest, CloseEveryPieceOfTetrahedra) {
  constexpr double kRounding = 100;
  std::mt19937 random(53);
  std::uniform_real_distribution<double> number(0, 1);
  for (int round = 0; round < scaled(600) && !HasFailure(); ++round) {
    const auto soup = tetrahedraOf(2 + round % 2, [&] {
      return Vec3<double>{number(random), number(random), number(random)};
    });
    const auto side = round / 10 % 2 == 0 ? FluidSide::Outside : FluidSide::Inside;
    expectPolygonsOf(cellsOfShells(soup, 1 + round / 2 % 5, side, {.polygons = true}), kRounding);
  }
}

/// The moments of the polygons, by quadrature, are those of the pieces.
TEST(MeetingPolygonsTest, AreThoseOfTheMoments) {
  for (const auto& soup : {balls(), plates()}) {
    for (const int n : {1, 5}) {
      expectMomentsOfPolygons(
          cellsOfShells(soup, n, FluidSide::Outside, {.polygons = true, .moments = 4}));
    }
  }
}

TEST(MeetingPolygonsTest, CloseEveryPieceOfLeaves) {
  std::mt19937 random(52);
  for (int n = 0; n < scaled(8) && !HasFailure(); ++n) {
    const auto boxes = n % 2 == 0 ? randomBoxes(random, 3) : randomBoxesInPlanes(random, 3, 8);
    for (const auto& soup : {balls(), plates(), soupOf(boxes)}) {
      const CellCutter cutter(solidOf(soup));
      expectPolygonsOf(cutter.cut(randomMesh(random, 3 + n % 2, 0, 1, 70), {.polygons = true}));
    }
  }
}

}  // namespace
}  // namespace cutwater::test
