#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "CutCells/RandomVoxels.hpp"
#include "Support/PolygonMoments.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

using Powers = std::array<int, 3>;

/// In the order that CutCells::Moments states.
const std::vector<Powers> kOrder{
    {0, 0, 0},                                                                    //
    {1, 0, 0}, {0, 1, 0}, {0, 0, 1},                                              //
    {2, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 2, 0}, {0, 1, 1}, {0, 0, 2},             //
    {3, 0, 0}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {1, 1, 1}, {1, 0, 2}, {0, 3, 0},  //
    {0, 2, 1}, {0, 1, 2}, {0, 0, 3},                                              //
    {4, 0, 0}, {3, 1, 0}, {3, 0, 1}, {2, 2, 0}, {2, 1, 1}, {2, 0, 2}, {1, 3, 0},  //
    {1, 2, 1}, {1, 1, 2}, {1, 0, 3}, {0, 4, 0}, {0, 3, 1}, {0, 2, 2}, {0, 1, 3},  //
    {0, 0, 4}};

int degreeOf(const Powers& powers) {
  return powers[0] + powers[1] + powers[2];
}

GridPatch<double> unitGrid(int n, double lower = 0, double upper = 1) {
  const double h = (upper - lower) / n;
  return {Level<double>({lower, lower, lower}, {h, h, h}), IndexBox::ofSize(n, n, n)};
}

CutCells cellsOf(const PolygonSoup& soup, const GridPatch<double>& grid,
                 FluidSide side = FluidSide::Inside, int degree = 4) {
  return CellCutter(Solid<double>(MeshSDF<double>(soup)), side)
      .cut(grid, {.polygons = true, .moments = degree});
}

PolygonSoup placedTorus() {
  auto soup = tessellation::torus(0.3, 0.1, 40, 20);
  RigidTransform<double> motion;
  motion.rotate(33.0, Vec3<double>{1, 2, 3});
  motion.translate({0.51, 0.49, 0.47});
  for (auto& p : soup.points) p = motion.toWorld(p);
  return soup;
}

std::vector<double> volumeAbout(const CutCells& cells, std::size_t piece, const Vec3<double>& to) {
  return shifted(cells.moments.ofVolume(piece), cells.pieces.centroid[piece], to);
}
std::vector<double> wallAbout(const CutCells& cells, std::size_t piece, const Vec3<double>& to) {
  return shifted(cells.moments.ofWall(piece), cells.pieces.wallCentroid[piece], to);
}
std::vector<Vec3<double>> wallVectorAbout(const CutCells& cells, std::size_t piece,
                                          const Vec3<double>& to) {
  return shifted(cells.moments.ofWallVector(piece), cells.pieces.wallCentroid[piece], to);
}

/// The integral of x^power from `lower` to `upper`.
double ofPower(int power, double lower, double upper) {
  return (std::pow(upper, power + 1) - std::pow(lower, power + 1)) / (power + 1);
}
/// Of a box, or of its face across an axis, on which all have this coordinate.
double ofBox(const Powers& powers, const Box<double>& box, int across = -1, double at = 0) {
  double result = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int power = powers[static_cast<std::size_t>(axis)];
    result *=
        axis == across ? std::pow(at, power) : ofPower(power, box.lower[axis], box.upper[axis]);
  }
  return result;
}

TEST(CutCellsMomentsTest, AreInTheOrderOfTheirDegrees) {
  ASSERT_EQ(kOrder.size(), 35U);
  for (std::size_t i = 0; i < kOrder.size(); ++i) {
    const auto n = [&](std::size_t axis) { return static_cast<std::size_t>(kOrder[i][axis]); };
    EXPECT_EQ(CutCells::Moments::indexOf(n(0), n(1), n(2)), i);
  }
  std::size_t number = 0;
  for (std::size_t degree = 0; degree <= 4; ++degree) {
    for (std::size_t second = 0; second <= degree; ++second) {
      EXPECT_EQ(CutCells::Moments::indexOf(degree - second, second), number++);
    }
  }
}

/// In fractions of 2 that rounding leaves alone, so that what differs is the moments'.
TEST(CutCellsMomentsTest, OfABoxInACell) {
  const Box<double> box{{0.25, 0.375, 0.125}, {0.5, 0.875, 0.75}};
  const auto cells = cellsOf(tessellation::box(box.lower, box.upper), unitGrid(1));
  ASSERT_EQ(cells.pieceCount, 1U);
  ASSERT_EQ(cells.arcs.area.size(), 0U);
  const auto volume = volumeAbout(cells, 0, {});
  const auto wall = wallAbout(cells, 0, {});
  const auto vector = wallVectorAbout(cells, 0, {});
  ASSERT_EQ(volume.size(), kOrder.size());
  for (std::size_t i = 0; i < kOrder.size(); ++i) {
    double area = 0;
    Vec3<double> normal;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = ofBox(kOrder[i], box, axis, box.lower[axis]);
      const double high = ofBox(kOrder[i], box, axis, box.upper[axis]);
      area += low + high;
      normal[axis] = high - low;
    }
    EXPECT_NEAR(volume[i], ofBox(kOrder[i], box), 1e-16);
    EXPECT_NEAR(wall[i], area, 1e-15);
    EXPECT_LT(length(vector[i] - normal), 1e-15);
  }
}

TEST(CutCellsMomentsTest, OfWhatABoxLeavesOfCellsAndFaces) {
  // Cells are [0, 1/2] and [1/2, 1] along each axis: the lowest loses its upper corner.
  const Box<double> box{{0.125, 0.25, 0.375}, {2, 2, 2}};
  const auto cells =
      cellsOf(tessellation::box(box.lower, box.upper), unitGrid(2), FluidSide::Outside);
  const auto row = cells.rowOf({0, 0, 0});
  ASSERT_NE(row, CutCells::kNoRow);
  const auto piece = cells.cells.firstPiece[row];
  ASSERT_EQ(cells.cells.firstPiece[row + 1], piece + 1);
  const Box<double> cell{{0, 0, 0}, {0.5, 0.5, 0.5}};
  const Box<double> body{box.lower, cell.upper};
  const auto volume = volumeAbout(cells, piece, {});
  for (std::size_t i = 0; i < kOrder.size(); ++i) {
    EXPECT_NEAR(volume[i], ofBox(kOrder[i], cell) - ofBox(kOrder[i], body), 1e-16);
  }
  std::size_t found = 0;
  for (std::size_t arc = 0; arc < cells.arcs.area.size(); ++arc) {
    if (cells.arcs.below[arc] != piece && cells.arcs.above[arc] != piece) continue;
    ++found;
    const int axis = cells.arcs.axis[arc];
    const bool isHigh = cells.arcs.below[arc] == piece;
    const auto moments = shifted(cells.moments.ofArc(arc), axis, cells.arcs.centroid[arc], {});
    ASSERT_EQ(moments.size(), 15U);
    for (const auto& powers : kOrder) {
      if (powers[static_cast<std::size_t>(axis)] != 0) continue;
      const auto first = static_cast<std::size_t>(powers[axis == 0 ? 1 : 0]);
      const auto second = static_cast<std::size_t>(powers[axis == 2 ? 1 : 2]);
      const double expected = ofBox(powers, cell, axis) - (isHigh ? ofBox(powers, body, axis) : 0);
      EXPECT_NEAR(moments[CutCells::Moments::indexOf(first, second)], expected, 1e-16);
    }
  }
  EXPECT_EQ(found, 6U);
}

/// Relative to each moment, of which the smallest are 1e-30.
TEST(CutCellsMomentsTest, ThinPlatesLoseNoDigits) {
  const double thickness = 0x1p-20;
  const Box<double> plate{{0, 0, 0.40625}, {1, 1, 0.40625 + thickness}};
  const auto cells =
      cellsOf(tessellation::box({-1, -1, plate.lower.z}, {2, 2, plate.upper.z}), unitGrid(1));
  ASSERT_EQ(cells.pieceCount, 1U);
  const auto moments = cells.moments.ofVolume(0);
  const Box<double> centered{{-0.5, -0.5, -thickness / 2}, {0.5, 0.5, thickness / 2}};
  double smallest = 1;
  for (std::size_t i = 0; i < kOrder.size(); ++i) {
    const double expected = ofBox(kOrder[i], centered);
    // Odd ones are 0 but for rounding of what even ones are made of.
    const double unit = std::pow(thickness, 1 + kOrder[i][2]);
    EXPECT_NEAR(moments[i], expected, 1e-15 * unit) << i;
    if (expected != 0) smallest = std::min(smallest, std::abs(expected));
  }
  EXPECT_LT(smallest, 1e-30);
}

double factorial(int n) {
  return n < 2 ? 1 : n * factorial(n - 1);
}

/// Of |x| + |y| + |z| < radius: eight times those of a corner (Dirichlet's integrals).
class OctahedronMoments {
 public:
  explicit OctahedronMoments(double radius) : radius_(radius) {}

  [[nodiscard]] PolygonSoup soup(const Vec3<double>& center) const {
    auto soup = bipyramid(4);
    for (auto& p : soup.points) p = center + (radius_ / length(p)) * p;
    return soup;
  }
  [[nodiscard]] double volume(const Powers& powers) const {
    return isEven(powers) ? 8 * ofCorner(powers, 3) : 0;
  }
  [[nodiscard]] double wall(const Powers& powers) const {
    return isEven(powers) ? 8 * std::sqrt(3.0) * ofCorner(powers, 2) : 0;
  }
  [[nodiscard]] double wallVector(Powers powers, std::size_t axis) const {
    const double corner = 8 * ofCorner(powers, 2);
    ++powers[axis];
    return isEven(powers) ? corner : 0;
  }

 private:
  static bool isEven(const Powers& powers) {
    return powers[0] % 2 == 0 && powers[1] % 2 == 0 && powers[2] % 2 == 0;
  }
  [[nodiscard]] double ofCorner(const Powers& powers, int more) const {
    const int k = degreeOf(powers) + more;
    return std::pow(radius_, k) * factorial(powers[0]) * factorial(powers[1]) *
           factorial(powers[2]) / factorial(k);
  }

  double radius_;
};

TEST(CutCellsMomentsTest, OfAnOctahedronInCellsThatAreAddedUp) {
  const OctahedronMoments octahedron(0.3);
  for (const Vec3<double>& center : {Vec3<double>{0.5, 0.5, 0.5}, {0.48, 0.53, 0.5}}) {
    for (const int n : {1, 2, 3, 8}) {
      const auto cells = cellsOf(octahedron.soup(center), unitGrid(n));
      std::vector<double> volume(kOrder.size());
      std::vector<double> wall(kOrder.size());
      std::vector<Vec3<double>> vector(kOrder.size());
      const auto box = cells.grid.indices();
      for (int k = 0; k < n; ++k) {
        for (int j = 0; j < n; ++j) {
          for (int i = 0; i < n; ++i) {
            if (cells.classOf({i, j, k}) != FluidClass::Fluid) continue;
            const auto whole = cells.boxOf({i, j, k});
            const Box<double> about{whole.lower - center, whole.upper - center};
            for (std::size_t m = 0; m < kOrder.size(); ++m) volume[m] += ofBox(kOrder[m], about);
          }
        }
      }
      ASSERT_EQ(box.count(), static_cast<std::size_t>(n) * n * n);
      for (std::size_t p = 0; p < cells.pieceCount; ++p) {
        const auto ofPiece = volumeAbout(cells, p, center);
        const auto ofWall = wallAbout(cells, p, center);
        const auto ofVector = wallVectorAbout(cells, p, center);
        for (std::size_t m = 0; m < kOrder.size(); ++m) {
          volume[m] += ofPiece[m];
          wall[m] += ofWall[m];
          vector[m] += ofVector[m];
        }
      }
      for (std::size_t m = 0; m < kOrder.size(); ++m) {
        EXPECT_NEAR(volume[m], octahedron.volume(kOrder[m]), 1e-16) << n << ' ' << m;
        EXPECT_NEAR(wall[m], octahedron.wall(kOrder[m]), 1e-15) << n << ' ' << m;
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_NEAR(vector[m][axis],
                      octahedron.wallVector(kOrder[m], static_cast<std::size_t>(axis)), 1e-15);
        }
      }
    }
  }
}

TEST(CutCellsMomentsTest, AreThoseOfThePolygonsByQuadrature) {
  auto plates = tessellation::box({-1, -1, 0.43}, {2, 2, 0.43 + 1e-6});
  plates = together(plates, tessellation::box({0.2, 0.3, 0.5}, {0.4, 0.7, 0.9}));
  std::mt19937 random(4);
  for (const auto& soup : {placedTorus(), plates, meshOf(randomVoxels(random)).soup()}) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      for (const int n : {1, 5}) expectMomentsOfPolygons(cellsOf(soup, unitGrid(n), side));
    }
  }
}

TEST(CutCellsMomentsTest, KeepTheIdentitiesOfTheDivergenceTheorem) {
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    for (const int n : {1, 2, 7, 16}) {
      for (const int degree : {0, 1, 2, 3, 4}) {
        EXPECT_LT(check(cellsOf(placedTorus(), unitGrid(n), side, degree)).worstMoments, 1e-14);
      }
    }
  }
}

TEST(CutCellsMomentsTest, ChecksFindWhatIsWrong) {
  const auto cells = cellsOf(placedTorus(), unitGrid(7));
  const auto worstWith = [&](auto change) {
    auto changed = cells;
    change(changed);
    return check(changed).worstMoments;
  };
  const std::size_t xx = CutCells::Moments::indexOf(2, 0, 0);
  const double unit = std::pow(1.0 / 7, 4);
  EXPECT_LT(worstWith([](CutCells&) {}), 1e-15);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.volume[35 + xx] += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.volume[35] += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.wallVector[35 + xx].x += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.wall[35] += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([&](CutCells& c) { c.moments.arc[15 + 3] += 1e-9 * unit; }), 1e-11);
  EXPECT_GT(worstWith([](CutCells& c) { c.moments.arc[15] = std::nan(""); }), 1e-11);
}

TEST(CutCellsMomentsTest, OfLowDegreesAreThoseOfTheRows) {
  const auto cells = cellsOf(placedTorus(), unitGrid(7), FluidSide::Outside);
  const double h = 1.0 / 7;
  for (std::size_t p = 0; p < cells.pieces.volume.size(); ++p) {
    const auto volume = cells.moments.ofVolume(p);
    const auto wall = cells.moments.ofWall(p);
    EXPECT_NEAR(volume[0], cells.pieces.volume[p], 1e-15 * h * h * h);
    EXPECT_NEAR(wall[0], cells.pieces.wallArea[p], 1e-15 * h * h);
    EXPECT_LT(length(cells.moments.ofWallVector(p)[0] - cells.pieces.wallVector[p]), 1e-15 * h * h);
    for (std::size_t i = 1; i < 4; ++i) {  // about centroids
      EXPECT_NEAR(volume[i], 0, 1e-15 * volume[0]);
      EXPECT_NEAR(wall[i], 0, 1e-15 * wall[0]);
    }
  }
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto arc = cells.moments.ofArc(a);
    EXPECT_NEAR(arc[0], cells.arcs.area[a], 1e-15 * h * h);
    for (std::size_t i = 1; i < 3; ++i) EXPECT_NEAR(arc[i], 0, 1e-15 * arc[0]);
  }
}

TEST(CutCellsMomentsTest, HigherDegreesChangeNoLowerOnes) {
  const auto all = cellsOf(placedTorus(), unitGrid(7));
  for (int degree = 0; degree < 4; ++degree) {
    const auto some = cellsOf(placedTorus(), unitGrid(7), FluidSide::Inside, degree);
    for (std::size_t p = 0; p < all.pieceCount; ++p) {
      for (std::size_t i = 0; i < some.moments.perPiece(); ++i) {
        ASSERT_EQ(some.moments.ofVolume(p)[i], all.moments.ofVolume(p)[i]);
        ASSERT_EQ(some.moments.ofWall(p)[i], all.moments.ofWall(p)[i]);
        ASSERT_EQ(some.moments.ofWallVector(p)[i], all.moments.ofWallVector(p)[i]);
      }
    }
    for (std::size_t a = 0; a < all.arcs.area.size(); ++a) {
      for (std::size_t i = 0; i < some.moments.perArc(); ++i) {
        ASSERT_EQ(some.moments.ofArc(a)[i], all.moments.ofArc(a)[i]);
      }
    }
  }
}

/// A million cells from the origin.
TEST(CutCellsMomentsTest, FarAwayAreAsGoodAsHere) {
  auto soup = placedTorus();
  for (auto& p : soup.points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * 0x1p20) * 0x1p-20;
  }
  const auto here = cellsOf(soup, unitGrid(16), FluidSide::Outside);
  const Vec3<double> far{0x1p18, -0x1p19, 0x1p17};
  for (auto& p : soup.points) p += far;
  const auto there = cellsOf(
      soup, {Level<double>(far, {1.0 / 16, 1.0 / 16, 1.0 / 16}), IndexBox::ofSize(16, 16, 16)},
      FluidSide::Outside);
  EXPECT_LT(check(there).worstMoments, 1e-14);
  ASSERT_EQ(here.pieceCount, there.pieceCount);
  for (std::size_t p = 0; p < here.pieceCount; ++p) {
    const auto corner = here.boxOf(here.cells.index[here.pieces.cell[p]]).lower;
    const auto expected = volumeAbout(here, p, corner);
    const auto found = volumeAbout(there, p, corner + far);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double unit = std::pow(1.0 / 16, degreeOf(kOrder[i]) + 3);
      EXPECT_NEAR(found[i], expected[i], 1e-14 * unit);
    }
  }
}

using Row = std::vector<double>;

/// The moments of each cell's pieces and of the arcs above and below each cell.
std::map<std::tuple<int, int, int, int>, std::vector<Row>> rowsByPlace(const CutCells& cells) {
  std::map<std::tuple<int, int, int, int>, std::vector<Row>> rows;
  const auto box = cells.grid.indices();
  for (std::size_t p = 0; p < cells.pieceCount; ++p) {
    const auto& index = cells.cells.index[cells.pieces.cell[p]];
    Row row(cells.moments.ofVolume(p).begin(), cells.moments.ofVolume(p).end());
    row.insert(row.end(), cells.moments.ofWall(p).begin(), cells.moments.ofWall(p).end());
    for (const auto& v : cells.moments.ofWallVector(p)) row.insert(row.end(), {v.x, v.y, v.z});
    rows[{index.i, index.j, index.k, -1}].push_back(row);
  }
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto& index = cells.arcs.cell[a];
    if (!box.contains(index) || !box.contains(cells.arcs.cellBelow(a))) continue;
    rows[{index.i, index.j, index.k, cells.arcs.axis[a]}].emplace_back(
        cells.moments.ofArc(a).begin(), cells.moments.ofArc(a).end());
  }
  return rows;
}

TEST(CutCellsMomentsTest, AreTheSameInEveryBoxAndWithAnyNumberOfThreads) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(placedTorus()))};
  const auto patch = unitGrid(29);
  const auto whole = rowsByPlace(cutter.cut(patch, {.moments = 4, .threads = 1}));
  EXPECT_EQ(whole, rowsByPlace(cutter.cut(patch, {.moments = 4, .threads = 4})));
  std::mt19937 random(1);
  std::size_t compared = 0;
  for (int n = 0; n < scaled(20); ++n) {
    std::array<int, 3> lo{};
    std::array<int, 3> hi{};
    for (std::size_t a = 0; a < 3; ++a) {
      lo[a] = static_cast<int>(random() % 29);
      hi[a] = lo[a] + static_cast<int>(random() % static_cast<unsigned>(29 - lo[a]));
    }
    const IndexBox box{{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
    for (const auto& [place, rows] :
         rowsByPlace(cutter.cut(GridPatch<double>{patch.level, box}, {.moments = 4}))) {
      ASSERT_EQ(rows, whole.at(place));
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000U);
}

TEST(CutCellsMomentsTest, ShiftThereAndBack) {
  const Box<double> box{{-1, -2, -3}, {1, 2, 3}};
  std::vector<double> moments;
  for (const auto& powers : kOrder) moments.push_back(ofBox(powers, box));
  const Vec3<double> from{0.5, 1.5, -2};
  const Vec3<double> to{2, -0.25, 1};
  const auto found = shifted(moments, from, to);
  const Box<double> about{box.lower + from - to, box.upper + from - to};
  for (std::size_t i = 0; i < kOrder.size(); ++i) {
    EXPECT_NEAR(found[i], ofBox(kOrder[i], about), 1e-12 * std::abs(ofBox(kOrder[i], about)));
    EXPECT_NEAR(shifted(found, to, from)[i], moments[i], 1e-10);
  }
  // A face across y: its y does not matter.
  std::vector<double> ofFace;
  for (const auto& powers : kOrder) {
    if (powers[1] == 0) ofFace.push_back(ofBox(powers, box, 1));
  }
  const auto moved = shifted(ofFace, 1, from, to);
  for (const auto& powers : kOrder) {
    if (powers[1] != 0) continue;
    const auto first = static_cast<std::size_t>(powers[0]);
    const auto second = static_cast<std::size_t>(powers[2]);
    const double expected = ofBox(powers, about, 1);
    EXPECT_NEAR(moved[CutCells::Moments::indexOf(first, second)], expected,
                1e-12 * std::abs(expected));
  }
}

TEST(CutCellsMomentsTest, OfCoarserCellsAreTheirOwn) {
  std::mt19937 random(8);
  for (const auto& soup : {placedTorus(), meshOf(randomVoxels(random)).soup()}) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      const auto coarse = coarsened(cellsOf(soup, unitGrid(12), side), {2, 3, 4});
      EXPECT_EQ(coarse.moments.degree, 4);
      EXPECT_EQ(coarse.moments.volume.size(), 35 * coarse.pieceCount);
      EXPECT_EQ(coarse.moments.arc.size(), 15 * coarse.arcs.area.size());
      EXPECT_LT(check(coarse).worstMoments, 1e-14);
      // All moments of a cell's fluid are those of cutting it.
      const Level<double> level({0, 0, 0}, {1.0 / 6, 1.0 / 4, 1.0 / 3});
      const auto direct = cellsOf(soup, {level, IndexBox::ofSize(6, 4, 3)}, side);
      ASSERT_EQ(coarse.cellCount, direct.cellCount);
      for (std::size_t row = 0; row < coarse.cellCount; ++row) {
        const auto center = coarse.boxOf(coarse.cells.index[row]).center();
        const auto sum = [&](const CutCells& cells) {
          std::vector<double> result(2 * kOrder.size());
          for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
            const auto volume = volumeAbout(cells, p, center);
            const auto wall = wallAbout(cells, p, center);
            for (std::size_t i = 0; i < kOrder.size(); ++i) {
              result[i] += volume[i];
              result[kOrder.size() + i] += wall[i];
            }
          }
          return result;
        };
        const auto found = sum(coarse);
        const auto expected = sum(direct);
        for (std::size_t i = 0; i < kOrder.size(); ++i) {
          EXPECT_NEAR(found[i], expected[i], 1e-16);
          EXPECT_NEAR(found[kOrder.size() + i], expected[kOrder.size() + i], 1e-14);
        }
      }
    }
  }
}

TEST(CutCellsMomentsTest, OfMergedCellsCountWhatWasClosed) {
  const auto plate = tessellation::box({-1, -1, 0.43}, {2, 2, 0.43 + 1e-6});
  std::mt19937 random(8);
  for (const auto& soup : {plate, placedTorus(), meshOf(randomVoxels(random)).soup()}) {
    const auto cells = cellsOf(soup, unitGrid(8), FluidSide::Outside);
    for (const double smallest : {0.0, 0.3}) {
      const auto result = merged(cells, {.smallest = smallest});
      EXPECT_GT(result.lost.size(), 0U);
      EXPECT_EQ(result.cells.moments.volume.size(), 35 * result.cells.pieceCount);
      EXPECT_EQ(result.cells.moments.arc.size(), 15 * result.cells.arcs.area.size());
      EXPECT_LT(check(result.cells).worstMoments, 1e-14);
    }
  }
}

TEST(CutCellsMomentsTest, AreThereOnlyOnRequestAndToDegreeFour) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(placedTorus()))};
  const auto without = cutter.cut(unitGrid(3));
  EXPECT_EQ(without.moments.degree, -1);
  EXPECT_TRUE(without.moments.volume.empty() && without.moments.wall.empty() &&
              without.moments.wallVector.empty() && without.moments.arc.empty());
  EXPECT_EQ(check(without).worstMoments, 0);
  EXPECT_TRUE(coarsened(without, {3, 3, 3}).moments.arc.empty());
  EXPECT_TRUE(merged(without).cells.moments.arc.empty());
  EXPECT_THROW(static_cast<void>(cutter.cut(unitGrid(3), {.moments = 5})), Error);
  EXPECT_THROW(static_cast<void>(cutter.cut(unitGrid(3), {.moments = -2})), Error);
  EXPECT_THROW(static_cast<void>(shifted(std::vector<double>(5), {}, {})), Error);
  EXPECT_THROW(static_cast<void>(shifted(std::vector<double>(3), 3, {}, {})), Error);
}

}  // namespace
}  // namespace cutwater::test
