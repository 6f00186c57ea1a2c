#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

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

/// Of all the fluid in a box and all its wall, about a point.
struct AllMoments {
  std::vector<double> volume = std::vector<double>(kOrder.size());
  std::vector<double> wall = std::vector<double>(kOrder.size());
  std::vector<Vec3<double>> wallVector = std::vector<Vec3<double>>(kOrder.size());

  AllMoments(const CutCells& cells, const Vec3<double>& about) {
    for (std::size_t p = 0; p < cells.pieceCount; ++p) addPiece(cells, p, about);
    const auto [lo, hi] = cells.grid.indices();
    for (int k = lo.k; k <= hi.k; ++k) {
      for (int j = lo.j; j <= hi.j; ++j) {
        for (int i = lo.i; i <= hi.i; ++i) addWhole(cells, {i, j, k}, about);
      }
    }
  }

 private:
  void addPiece(const CutCells& cells, std::size_t piece, const Vec3<double>& about) {
    const auto ofPiece = volumeAbout(cells, piece, about);
    const auto ofWall = wallAbout(cells, piece, about);
    const auto ofVector = wallVectorAbout(cells, piece, about);
    for (std::size_t m = 0; m < kOrder.size(); ++m) {
      volume[m] += ofPiece[m];
      wall[m] += ofWall[m];
      wallVector[m] += ofVector[m];
    }
  }
  void addWhole(const CutCells& cells, const Index3& cell, const Vec3<double>& about) {
    if (cells.classOf(cell) != FluidClass::Fluid) return;
    const auto box = cells.boxOf(cell);
    for (std::size_t m = 0; m < kOrder.size(); ++m) {
      volume[m] += ofBox(kOrder[m], {box.lower - about, box.upper - about});
    }
  }
};

TEST(CutCellsMomentsTest, OfAnOctahedronInCellsThatAreAddedUp) {
  const OctahedronMoments octahedron(0.3);
  for (const Vec3<double>& center : {Vec3<double>{0.5, 0.5, 0.5}, {0.48, 0.53, 0.5}}) {
    for (const int n : {1, 2, 3, 8}) {
      const AllMoments found(cellsOf(octahedron.soup(center), unitGrid(n)), center);
      for (std::size_t m = 0; m < kOrder.size(); ++m) {
        EXPECT_NEAR(found.volume[m], octahedron.volume(kOrder[m]), 1e-16) << n << ' ' << m;
        EXPECT_NEAR(found.wall[m], octahedron.wall(kOrder[m]), 1e-15) << n << ' ' << m;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          EXPECT_NEAR(found.wallVector[m][static_cast<int>(axis)],
                      octahedron.wallVector(kOrder[m], axis), 1e-15);
        }
      }
    }
  }
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
