#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

using Polygon = std::span<const Vec3<double>>;

Vec3<double> areaVector(Polygon polygon) {
  Vec3<double> area;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    area += 0.5 * cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  }
  return area;
}

/// Polygons that should be the boundary of a polyhedron.
class Boundary {
 public:
  /// `sign`: 1 if the polygon's normal points out of the polyhedron.
  void add(Polygon polygon, int sign) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto& a = polygon[k];
      const auto& b = polygon[(k + 1) % polygon.size()];
      if (a == b) continue;
      const bool goesUp = std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
      edges_[goesUp ? keyOf(a, b) : keyOf(b, a)] += goesUp ? sign : -sign;
    }
    if (polygon.empty()) return;
    if (isEmpty_) origin_ = polygon[0];
    isEmpty_ = false;
    volume_ += sign * dot(polygon[0] - origin_, areaVector(polygon)) / 3;
  }
  [[nodiscard]] double volume() const { return volume_; }
  [[nodiscard]] std::size_t openEdges() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(edges_, [](const auto& edge) { return edge.second != 0; }));
  }

 private:
  using Key = std::array<double, 6>;
  static Key keyOf(const Vec3<double>& a, const Vec3<double>& b) {
    return {a.x, a.y, a.z, b.x, b.y, b.z};
  }

  std::map<Key, int> edges_;
  Vec3<double> origin_;
  double volume_ = 0;
  bool isEmpty_ = true;
};

double planeBelow(const CutCells& cells, const Index3& cell, int axis) {
  const auto& first = cells.grid.first;
  const int n = axis == 0 ? cell.i - first.i : axis == 1 ? cell.j - first.j : cell.k - first.k;
  return cells.grid.planes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(n + 1)];
}

/// That polygons are those of the arcs and walls, and close every piece, to the bit.
void expectPolygonsOf(const CutCells& cells) {
  const double unit = cells.cellVolume(cells.grid.first);
  ASSERT_EQ(cells.arcPolygons.count(), cells.arcs.area.size());
  ASSERT_EQ(cells.firstWallPolygon.size(), cells.wallParts.area.size() + 1);
  ASSERT_EQ(cells.firstWallPolygon.back(), cells.wallPolygons.count());
  std::vector<Boundary> boundaries(cells.pieceCount);
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto outline = cells.arcPolygons.of(a);
    const int axis = cells.arcs.axis[a];
    const double plane = planeBelow(cells, cells.arcs.cell[a], axis);
    for (const auto& p : outline) ASSERT_EQ(p[axis], plane);
    const auto area = areaVector(outline);
    EXPECT_NEAR(area[axis], cells.arcs.area[a], 1e-13 * cells.faceArea(cells.arcs.cell[a], axis));
    if (cells.arcs.below[a] < cells.pieceCount) boundaries[cells.arcs.below[a]].add(outline, 1);
    if (cells.arcs.above[a] < cells.pieceCount) boundaries[cells.arcs.above[a]].add(outline, -1);
  }
  for (std::size_t w = 0; w < cells.wallParts.area.size(); ++w) {
    double area = 0;
    for (auto n = cells.firstWallPolygon[w]; n < cells.firstWallPolygon[w + 1]; ++n) {
      const auto polygon = cells.wallPolygons.of(n);
      area += length(areaVector(polygon));
      const auto piece = cells.wallParts.piece[w];
      if (piece < cells.pieceCount) boundaries[piece].add(polygon, -1);
    }
    EXPECT_NEAR(area, cells.wallParts.area[w], 1e-12 * std::cbrt(unit) * std::cbrt(unit));
  }
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) {
    EXPECT_EQ(boundaries[p].openEdges(), 0U) << "piece " << p;
    EXPECT_NEAR(boundaries[p].volume(), cells.pieces.volume[p], 1e-12 * unit) << "piece " << p;
  }
}

CutCells cut(const PolygonSoup& soup, int n, FluidSide side = FluidSide::Outside) {
  const double h = 1.0 / n;
  return CellCutter(Solid<double>(MeshSDF<double>(soup)), side)
      .cut(GridPatch<double>{Level<double>({0, 0, 0}, {h, h, h}), IndexBox::ofSize(n, n, n)},
           {.polygons = true});
}

PolygonSoup moved(PolygonSoup soup, const Vec3<double>& by) {
  for (auto& p : soup.points) p += by;
  return soup;
}

TEST(CutPolygonsTest, CloseEveryPiece) {
  auto soup = tessellation::torus(0.3, 0.1, 40, 20);
  RigidTransform<double> motion;
  motion.rotate(33.0, Vec3<double>{1, 2, 3});
  motion.translate({0.51, 0.49, 0.47});
  for (auto& p : soup.points) p = motion.toWorld(p);
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    for (const int n : {1, 2, 7, 16}) expectPolygonsOf(cut(soup, n, side));
  }
}

TEST(CutPolygonsTest, OfSurfacesAlignedWithTheGrid) {
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    expectPolygonsOf(cut(tessellation::box({0.25, 0.25, 0.25}, {0.5, 0.75, 0.625}), 8, side));
    expectPolygonsOf(cut(moved(tessellation::icosphere(0.25, 2), {0.5, 0.5, 0.5}), 8, side));
    expectPolygonsOf(cut(moved(lPrism(), {-1, -1, 0.25}), 4, side));
  }
}

TEST(CutPolygonsTest, CutOpenTheHolesOfAFace) {
  // Balls and rings about the plane z = 1/2, all within the faces of eight cells.
  auto soup = moved(tessellation::icosphere(0.05, 2), {0.25, 0.25, 0.503});
  for (const Vec3<double>& at :
       {Vec3<double>{0.1, 0.12, 0.51}, {0.26, 0.1, 0.49}, {0.4, 0.41, 0.5}}) {
    soup = together(soup, moved(tessellation::icosphere(0.03, 2), at));
  }
  soup = together(soup, moved(tessellation::torus(0.15, 0.04, 30, 12), {0.75, 0.75, 0.501}));
  soup = together(soup, moved(tessellation::icosphere(0.06, 2), {0.75, 0.75, 0.49}));
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto cells = cut(soup, 2, side);
    expectPolygonsOf(cells);
    const auto found = check(cells);
    // Outside: within the ring about the ball the fluid is one with that above and below it.
    EXPECT_EQ(found.multiPieceCells, side == FluidSide::Outside ? 0U : 4U);
  }
}

TEST(CutPolygonsTest, OfAPlateAndABubbleInOneCell) {
  auto soup = tessellation::box({-1, -1, 0.4}, {2, 2, 0.4 + 1e-6});
  soup = together(soup, moved(tessellation::icosphere(0.1, 1), {0.5, 0.5, 0.7}));
  expectPolygonsOf(cut(soup, 1));
  EXPECT_EQ(check(cut(soup, 1)).multiPieceCells, 1U);
}

TEST(CutPolygonsTest, AreLeftOutUnlessAskedFor) {
  const CellCutter cutter(Solid<double>(MeshSDF<double>(tessellation::icosphere(0.3, 1))));
  const auto cells = cutter.cut(cellsBetween({{{-1, 0.1, 1}, {-1, 0.1, 1}, {-1, 0.1, 1}}}));
  EXPECT_EQ(cells.cellCount, 8U);
  EXPECT_EQ(cells.arcPolygons.count(), 0U);
  EXPECT_EQ(cells.wallPolygons.count(), 0U);
  EXPECT_TRUE(cells.firstWallPolygon.empty());
}

}  // namespace
}  // namespace cutwater::test
