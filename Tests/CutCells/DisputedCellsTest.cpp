// CellCutter::disputedCells(), of leaves and in planes as well.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Surface/Detail/HoleCaps.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

#include <functional>

#include <gtest/gtest.h>

#include "CutCells/ShellCells.hpp"
#include "Support/WindingOracle.hpp"

namespace cutwater::test {
namespace {

/// Without the polygons of which `isTaken` holds, by their middle.
PolygonSoup opened(const PolygonSoup& whole, const std::function<bool(Vec3<double>)>& isTaken) {
  PolygonSoup rest;
  rest.points = whole.points;
  for (std::size_t i = 0; i < whole.polygonCount(); ++i) {
    Vec3<double> middle;
    for (const auto corner : whole.polygon(i)) middle += whole.points[corner];
    middle = (1.0 / static_cast<double>(whole.polygon(i).size())) * middle;
    if (!isTaken(middle)) rest.addPolygon(whole.polygon(i));
  }
  return rest;
}

/// With triangles across its rims.
PolygonSoup capped(const PolygonSoup& open) {
  auto soup = triangulated(open);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    triangles.push_back({p[0], p[1], p[2]});
  }
  const auto caps = capHoles<double>(soup.points, findOpenEdges(triangles, soup.points.size()));
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), caps.positions.begin(), caps.positions.end());
  for (const auto& [a, b, c] : caps.triangles) {
    soup.addPolygon(std::array{first + a, first + b, first + c});
  }
  weldExactly(soup);
  return soup;
}

CellPlanes gridOf(int n, double lower, double upper) {
  std::vector<double> planes;
  for (int i = 0; i <= n; ++i) planes.push_back(lower + (upper - lower) * i / n);
  return cellsBetween({planes, planes, planes});
}

/// So many points along each axis of a box.
std::vector<Vec3<double>> pointsIn(const Box<double>& box, const Index3& counts) {
  std::vector<Vec3<double>> points;
  for (int n = 0; n < counts.i * counts.j * counts.k; ++n) {
    const Vec3<double> at{(0.503 + n % counts.i) / counts.i,
                          (0.501 + n / counts.i % counts.j) / counts.j,
                          (0.499 + n / counts.i / counts.j) / counts.k};
    auto& p = points.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = box.lower[axis] + at[axis] * box.size()[axis];
    }
  }
  return points;
}

/// What samples say of the cells that are listed.
struct Shares {
  std::size_t listed = 0;
  std::size_t differing = 0;  ///< of these, those with a sample that differs
  std::size_t whole = 0;      ///< of these, those that are not cut
};

/// Compares the signs of the open surface, as a MeshSDF has them, with those of the surface with
/// its caps: none may differ in a cell that is not listed.
Shares expectAllListed(const PolygonSoup& open, const CellPlanes& grid, int samples) {
  const Solid<double> solid = solidOf(open);
  const auto closed = solidOf(capped(open));
  Shares shares;
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(solid, side, {.capHoles = true});
    const auto cells = cutter.cut(grid);
    const auto listed = cutter.disputedCells(cells);
    EXPECT_EQ(cutter.disputedCells(cells, {.threads = 1}), listed);
    shares = {.listed = listed.size()};
    auto next = listed.begin();
    const auto box = grid.indices();
    for (std::uint32_t n = 0; n < box.count(); ++n) {
      const auto nx = static_cast<std::uint32_t>(box.length(0));
      const auto ny = static_cast<std::uint32_t>(box.length(1));
      const auto cell = box.at(n % nx, n / nx % ny, n / nx / ny);
      const auto own = cells.boxOf(cell);
      bool differs = false;
      for (const auto& p : pointsIn(own, {samples, samples, samples})) {
        const bool isWithin = closed.signedDistance(p) < 0;
        differs = differs || isWithin != (solid.signedDistance(p) < 0);
        const auto found = cells.classOf(cell);
        const auto expected =
            isWithin == (side == FluidSide::Outside) ? FluidClass::Body : FluidClass::Fluid;
        EXPECT_TRUE(found == FluidClass::Cut || found == expected);
      }
      const bool isListed = next != listed.end() && *next == cell;
      EXPECT_TRUE(isListed || !differs) << cell.i << ' ' << cell.j << ' ' << cell.k;
      if (!isListed) continue;
      ++next;
      shares.differing += differs ? 1 : 0;
      shares.whole += cells.classOf(cell) == FluidClass::Cut || !differs ? 0 : 1;
    }
    EXPECT_EQ(next, listed.end());  // sorted as cells are
  }
  return shares;
}

TEST(DisputedCellsTest, OneFlatCapMakesNone) {
  // A bowl: half a ball, open at a rim of its edges.
  const auto bowl = [](int level) {
    auto ball = tessellation::capsule(0.4, 0.1, 8 * level, 4 * level);
    for (auto& p : ball.points) p.z = std::abs(p.z) < 1e-12 ? 0 : p.z;
    return opened(ball, [](const Vec3<double>& p) { return p.z > 0; });
  };
  const auto tub = opened(tessellation::box({-0.3, -0.35, -0.2}, {0.3, 0.25, 0.2}, 3),
                          [](const Vec3<double>& p) { return p.z > 0.199; });
  for (const auto& open : {tub, bowl(3)}) {
    for (const int n : {3, 10}) {
      EXPECT_EQ(expectAllListed(open, gridOf(n, -0.5, 0.5), 4).listed, 0U) << n;
    }
  }
}

/// A box with a rim that bends up along x, and down along y.
TEST(DisputedCellsTest, ABentCapMakesThoseBetweenItAndTheSheetOfOneHalf) {
  auto tray = opened(tessellation::box({-0.4, -0.4, -0.2}, {0.4, 0.4, 0.2}, 6),
                     [](const Vec3<double>& p) { return p.z > 0.199; });
  for (auto& p : tray.points) {
    if (p.z > 0) p.z += (p.x * p.x - p.y * p.y);
  }
  for (const int n : {4, 9}) {
    const auto [listed, differing, whole] = expectAllListed(tray, gridOf(n, -0.53, 0.51), 10);
    EXPECT_GT(differing, n == 9 ? 70U : 20U);
    EXPECT_GT(whole, n == 9 ? 20U : 0U);
    EXPECT_LE(10 * listed, 18 * differing);
  }
}

/// A short tube, both ends of which are open.
PolygonSoup ring() {
  return opened(tessellation::cylinder(0.4, 0.2, 24),
                [](const Vec3<double>& p) { return p.z < 0.001 || p.z > 0.199; });
}

/// Each of them alone has half of the full solid angle at most, both have more between them.
TEST(DisputedCellsTest, TwoCapsOfAShortTubeMakeThoseBetweenThem) {
  for (const int n : {9, 14}) {
    const auto [listed, differing, whole] = expectAllListed(ring(), gridOf(n, -0.53, 0.51), 6);
    EXPECT_GT(whole, n == 14 ? 50U : 0U);
    EXPECT_LE(10 * listed, 12 * differing);
  }
}

/// Whether signs differ at one of these points.
bool differAt(const std::vector<Vec3<double>>& points, const Solid<double>& one,
              const Solid<double>& other) {
  return std::ranges::any_of(points, [&](const Vec3<double>& p) {
    return (one.signedDistance(p) < 0) != (other.signedDistance(p) < 0);
  });
}

TEST(DisputedCellsTest, OfLeaves) {
  const auto open = solidOf(ring());
  const auto closed = solidOf(capped(ring()));
  const OctreeDomain<double> domain({-0.53, -0.53, -0.53}, 1.04, {1, 1, 1});
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(open, side, {.capHoles = true});
    const Octree<double> octree(open, domain, {.cut = 4, .bands = {{0.1, 3}}});
    const auto leaves = cutter.cut(octree);
    const auto listed = cutter.disputedLeaves(leaves, octree);
    EXPECT_EQ(cutter.disputedLeaves(leaves, octree, {.threads = 1}), listed);
    std::size_t differing = 0;
    for (std::uint32_t n = 0; n < octree.cells().size(); ++n) {
      const bool differs =
          differAt(pointsIn(octree.box(octree.cells()[n]), {5, 5, 5}), open, closed);
      differing += differs ? 1 : 0;
      EXPECT_TRUE(!differs || std::ranges::binary_search(listed, n)) << n;
    }
    EXPECT_GT(differing, 200U);
    EXPECT_LE(10 * listed.size(), 13 * differing);
    EXPECT_TRUE(std::ranges::is_sorted(listed));
    EXPECT_THROW(
        static_cast<void>(cutter.disputedLeaves(leaves, Octree<double>(open, domain, {.cut = 2}))),
        Error);
  }
}

TEST(DisputedCellsTest, OfLeavesOfOneLevelTheyAreThoseOfTheGrid) {
  const auto open = solidOf(ring());
  const OctreeDomain<double> domain({-0.5, -0.5, -0.5}, 1, {1, 1, 1});
  const Octree<double> octree(open, domain, {.cut = 3, .bands = {{2, 3}}});
  ASSERT_EQ(octree.cells().size(), 512U);
  const CellCutter cutter(open, FluidSide::Outside, {.capHoles = true});
  std::vector<Index3> found;
  for (const auto n : cutter.disputedLeaves(cutter.cut(octree), octree)) {
    found.push_back(octree.cells()[n].index);
  }
  std::ranges::sort(found, {}, [](const Index3& c) { return std::tuple(c.k, c.j, c.i); });
  EXPECT_FALSE(found.empty());
  EXPECT_EQ(found, cutter.disputedCells(cutter.cut(gridOf(8, -0.5, 0.5))));
}

TEST(DisputedCellsTest, InPlanes) {
  const auto open = solidOf(ring());
  const auto closed = solidOf(capped(ring()));
  std::size_t differing = 0;
  std::size_t listings = 0;
  for (const double z : {-0.05, 0.03, 0.1, 0.19}) {
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      const CellCutter cutter(open, side, {.capHoles = true});
      const auto cells = cutter.cutInPlane(gridOf(11, -0.53, 0.51), z);
      const auto listed = cutter.disputedCellsInPlane(cells, z);
      listings += listed.size();
      for (std::int32_t n = 0; n < 121; ++n) {
        const Index3 cell{n % 11, n / 11, 0};
        auto box = cells.boxOf(cell);
        box.lower.z = box.upper.z = z;
        const bool differs = differAt(pointsIn(box, {12, 12, 1}), open, closed);
        differing += differs ? 1 : 0;
        EXPECT_TRUE(!differs || std::ranges::find(listed, cell) != listed.end()) << z << ' ' << n;
      }
    }
  }
  EXPECT_GT(differing, 200U);
  EXPECT_LE(10 * listings, 12 * differing);
}

/// A gutter, bent to a ring: its rims are circles in one plane, one within the other. And a bend,
/// both ends of which are in one plane.
TEST(DisputedCellsTest, CapsInOnePlaneMakeNone) {
  auto gutter = tessellation::torus(0.3, 0.15, 24, 6);
  const double top = gutter.boundingBox().upper.z;
  for (auto& p : gutter.points) p.z = p.z > 0.9 * top ? top : p.z;
  const auto open =
      opened(gutter, [&](const Vec3<double>& middle) { return middle.z > 0.9 * top; });
  auto bend = tessellation::torus(0.3, 0.15, 24, 7);
  for (auto& p : bend.points) p.y = std::abs(p.y) < 1e-12 ? 0 : p.y;
  bend = opened(bend, [](const Vec3<double>& middle) { return middle.y < 0; });
  for (const auto& soup : {open, bend}) {
    EXPECT_EQ(expectAllListed(soup, gridOf(9, -0.53, 0.51), 4).listed, 0U);
  }
}

TEST(DisputedCellsTest, NoCapsMakeNone) {
  const CellCutter cutter(solidOf(ball(0.4, kMiddle)), FluidSide::Outside, {.capHoles = true});
  EXPECT_TRUE(cutter.disputedCells(cutter.cut(gridOf(5, 0, 1))).empty());
  const CellCutter periodic(solidOf(ball(0.4, kMiddle)), FluidSide::Outside, {.period = {1, 0, 0}});
  EXPECT_THROW(static_cast<void>(periodic.disputedCells(cutter.cut(gridOf(5, 0, 1)))), Error);
}

}  // namespace
}  // namespace cutwater::test
