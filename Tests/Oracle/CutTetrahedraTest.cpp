// Cells of tetrahedra whose corners are nodes of the grid, against rational numbers: volumes from
// integrals over triangles as seen along z, walls from their parts in cells, open parts of faces
// from sections. Tetrahedra may touch, but have no volume in common.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "Oracle/RationalTetrahedra.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test::rational {
namespace {

/// The integral over a polygon, as seen along z, of its height above z.
Number volumeBelow(const Polygon& polygon, const Number& z) {
  Number sum(0);
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Polygon triangle{polygon[0], polygon[k - 1], polygon[k]};
    const Number mean = (triangle[0][2] + triangle[1][2] + triangle[2][2]) / 3 - z;
    sum += mean * twiceArea(triangle, 2) / 2;
  }
  return sum;
}

bool liesAt(const Polygon& polygon, const Number& z) {
  return std::all_of(polygon.begin(), polygon.end(), [&](const Point& p) { return p[2] == z; });
}

/// The part of a convex polygon between planes n and n + 1 across an axis.
Polygon between(const Polygon& polygon, std::size_t axis, int n) {
  return clipped(clipped(polygon, axis, Number(n), 1), axis, Number(n + 1), -1);
}

/// What tetrahedra have in a cell of width 1.
struct Share {
  Number volume{0};
  double wall = 0;  ///< area
};

/// Adds the volume between a triangle and z = 0 to the cells there.
void addVolumes(const Polygon& triangle, std::map<Cell, Share>& shares) {
  for (int i = 0; i < kCells; ++i) {
    const auto slab = between(triangle, 0, i);
    if (slab.size() < 3) continue;
    for (int j = 0; j < kCells; ++j) {
      const auto column = between(slab, 1, j);
      if (twiceArea(column, 2) == 0) continue;
      for (int k = 0; k < kCells; ++k) {
        const auto within = between(column, 2, k);
        auto& volume = shares[{i, j, k}].volume;
        volume += volumeBelow(within, Number(k));
        if (liesAt(column, Number(k + 1))) continue;  // it is within
        volume += twiceArea(clipped(column, 2, Number(k + 1), 1), 2) / 2;
      }
    }
  }
}

/// Adds the area of a triangle to the cells that have a part of it. In a plane of the grid, these
/// are those on the side to which it faces, if the fluid is there.
void addWalls(const Polygon& triangle, bool isInside, std::map<Cell, Share>& shares) {
  std::array<double, 3> normal{};
  for (std::size_t a = 0; a < 3; ++a) normal[a] = CGAL::to_double(twiceArea(triangle, a)) / 2;
  const double area = std::hypot(normal[0], normal[1], normal[2]);
  std::size_t along = 0;
  for (const std::size_t a : {1, 2}) {
    if (std::abs(normal[a]) > std::abs(normal[along])) along = a;
  }
  const auto all = twiceArea(triangle, along);
  const bool isFlat = std::abs(normal[along]) == area;
  const auto part = [&](const Polygon& polygon, std::size_t axis, int n) {
    if (!isFlat || axis != along) {
      return between(polygon, axis, n);
    }
    const bool isAbove = (all > 0) != isInside;
    return polygon[0][axis] == Number(isAbove ? n : n + 1) ? polygon : Polygon{};
  };
  for (int i = 0; i < kCells; ++i) {
    const auto slab = part(triangle, 0, i);
    for (int j = 0; j < kCells && slab.size() >= 3; ++j) {
      const auto column = part(slab, 1, j);
      for (int k = 0; k < kCells && column.size() >= 3; ++k) {
        const Number share = twiceArea(part(column, 2, k), along) / all;
        if (share > 0) shares[{i, j, k}].wall += CGAL::to_double(share) * area;
      }
    }
  }
}

/// The area that bodies have of the face below a cell, on either side of it, or on both.
double partOfFace(const std::vector<Tetrahedron>& bodies, std::size_t axis, const Cell& cell,
                  bool onBoth) {
  std::vector<Polygon> parts;
  for (const auto& body : bodies) {
    if (onBoth && !body.isOnBothSidesOf(axis, cell[axis])) return 0;
    auto& polygon = parts.emplace_back(sortedAround(body.section(axis, cell[axis]), axis));
    for (std::size_t a = 0; a < 3 && polygon.size() >= 3; ++a) {
      if (a == axis) continue;
      polygon = between(polygon, a, cell[a]);
    }
  }
  Number twice = twiceArea(parts[0], axis);
  if (parts.size() == 2 && parts[1].size() >= 3) {
    twice += twiceArea(parts[1], axis) - twiceArea(common(parts[0], parts[1], axis), axis);
  }
  return CGAL::to_double(twice / 2);
}

std::vector<Tetrahedron> randomBodies(std::mt19937& random, bool areTwo) {
  std::vector<Tetrahedron> bodies{Tetrahedron(random)};
  while (areTwo && bodies.size() < 2) {
    Tetrahedron other(random);
    if (other.isApartFrom(bodies.front())) bodies.push_back(other);
  }
  return bodies;
}

PolygonSoup soupOf(const std::vector<Tetrahedron>& bodies) {
  auto soup = bodies[0].soup();
  return bodies.size() == 1 ? soup : together(soup, bodies[1].soup());
}

/// Sums over the pieces and arcs of cells of width 1.
struct Rows {
  explicit Rows(const CutCells& cells) : all(cells) {
    for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
      const auto& c = cells.arcs.cell[a];
      open[{{c.i, c.j, c.k}, cells.arcs.axis[a]}] += cells.arcs.area[a] / (kWidth * kWidth);
    }
  }
  [[nodiscard]] bool isCut(const Cell& cell) const { return row(cell) != CutCells::kNoRow; }
  [[nodiscard]] std::uint32_t row(const Cell& cell) const {
    return all.rowOf({cell[0], cell[1], cell[2]});
  }
  [[nodiscard]] std::pair<double, double> volumeAndWall(const Cell& cell) const {
    if (!isCut(cell)) {
      return {all.classOf({cell[0], cell[1], cell[2]}) == FluidClass::Fluid ? 1 : 0, 0};
    }
    std::pair<double, double> sums;
    for (auto p = all.cells.firstPiece[row(cell)]; p < all.cells.firstPiece[row(cell) + 1]; ++p) {
      sums.first += all.pieces.volume[p] / (kWidth * kWidth * kWidth);
      sums.second += all.pieces.wallArea[p] / (kWidth * kWidth);
    }
    return sums;
  }

  const CutCells& all;
  std::map<std::pair<Cell, std::size_t>, double> open;
};

struct Kind {
  FluidSide side = FluidSide::Outside;
  bool areTwo = false;
  double tolerance = 1e-14;
};

/// Returns the number of cells that are cut.
std::size_t expectExact(const std::vector<Tetrahedron>& bodies, const Kind& kind) {
  std::vector<double> planes;
  for (int n = 0; n <= kCells; ++n) planes.push_back(kWidth * n);
  const CellCutter cutter(Solid<double>(MeshSDF<double>(soupOf(bodies))), kind.side);
  const auto cells = cutter.cut(cellsBetween({planes, planes, planes}));
  const Rows rows(cells);
  const bool isInside = kind.side == FluidSide::Inside;
  std::map<Cell, Share> shares;
  for (const auto& body : bodies) {
    for (const auto& triangle : body.triangles()) {
      addVolumes(triangle, shares);
      addWalls(triangle, isInside, shares);
    }
  }
  for (int n = 0; n < kCells * kCells * kCells; ++n) {
    const Cell cell{n % kCells, n / kCells % kCells, n / kCells / kCells};
    const double volume = CGAL::to_double(shares[cell].volume);
    const auto [fluid, wall] = rows.volumeAndWall(cell);
    EXPECT_NEAR(fluid, isInside ? volume : 1 - volume, kind.tolerance) << n;
    if (!kind.areTwo) {  // where they touch, there is no wall
      EXPECT_NEAR(wall, shares[cell].wall, kind.tolerance) << n;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto below = cell;
      if (--below[axis] < 0 || (!rows.isCut(cell) && !rows.isCut(below))) continue;
      const double part = partOfFace(bodies, axis, cell, isInside);
      const auto found = rows.open.find({cell, axis});
      EXPECT_NEAR(found == rows.open.end() ? 0 : found->second, isInside ? part : 1 - part,
                  kind.tolerance)
          << n << " axis " << axis;
    }
  }
  return cells.cellCount;
}

void expectExact(int rounds, const Kind& kind) {
  std::mt19937 random(17);
  std::size_t cut = 0;
  for (int n = 0; n < rounds; ++n) {
    cut += expectExact(randomBodies(random, kind.areTwo), kind);
    ASSERT_FALSE(testing::Test::HasFailure()) << "round " << n;
  }
  EXPECT_GT(cut, static_cast<std::size_t>(10 * rounds));
}

TEST(CutTetrahedraTest, FluidOutside) {
  expectExact(scaled(50), {});
}

TEST(CutTetrahedraTest, FluidInside) {
  expectExact(scaled(50), {.side = FluidSide::Inside});
}

TEST(CutTetrahedraTest, TwoThatMayTouch) {
  expectExact(scaled(50), {.areTwo = true});
}

}  // namespace
}  // namespace cutwater::test::rational
