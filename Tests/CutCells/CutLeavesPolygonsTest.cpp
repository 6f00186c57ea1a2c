#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// How many corners of polygons lie within an edge of another one, of those along an axis.
std::size_t cornersWithinEdges(const CutLeaves& leaves) {
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto keyOf = [&](const Vec3<double>& p) {
      return std::array{p[(axis + 1) % 3], p[(axis + 2) % 3], p[axis]};
    };
    std::set<std::array<double, 3>> corners;
    for (const auto& p : leaves.arcPolygons.points) corners.insert(keyOf(p));
    for (const auto& p : leaves.wallPolygons.points) corners.insert(keyOf(p));
    for (std::size_t a = 0; a < leaves.arcPolygons.count(); ++a) {
      const auto polygon = leaves.arcPolygons.of(a);
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        auto from = keyOf(polygon[k]);
        auto to = keyOf(polygon[(k + 1) % polygon.size()]);
        if (from[0] != to[0] || from[1] != to[1]) continue;
        if (to < from) std::swap(from, to);
        const auto next = corners.upper_bound(from);
        if (next != corners.end() && *next < to) ++count;
      }
    }
  }
  return count;
}

void expectClosedMesh(const CellCutter& cutter, const Mesh& mesh, double rounding = 1) {
  const auto leaves = cutter.cut(mesh, {.polygons = true});
  expectPolygonsOf(leaves, rounding);
  EXPECT_EQ(cornersWithinEdges(leaves), 0U);
}

TEST(CutLeavesPolygonsTest, CloseEveryPieceOfATorus) {
  std::mt19937 random(11);
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(turnedTorus(), side);
    for (int n = 0; n < scaled(6) && !HasFailure(); ++n) {
      expectClosedMesh(cutter, randomMesh(random, 4 + n % 2, 0, 1));
    }
  }
}

TEST(CutLeavesPolygonsTest, CloseEveryPieceOfVoxels) {
  std::mt19937 random(12);
  for (int n = 0; n < scaled(12) && !HasFailure(); ++n) {
    const CellCutter cutter{Solid<double>(meshOf(randomVoxels(random)))};
    const double lower = n % 2 == 0 ? 0 : -0.0113;
    const double width = n % 4 < 2 ? 0.75 : 1;
    expectClosedMesh(cutter, randomMesh(random, 4, lower, width, 80));
  }
}

/// A tetrahedron of points that come from `next`, one coordinate after the other.
template <typename Next>
PolygonSoup tetrahedron(const Next& next) {
  PolygonSoup soup;
  for (int corner = 0; corner < 4; ++corner) {
    Vec3<double> p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = next();
    soup.points.push_back(p);
  }
  for (const auto& corners : {std::array{0U, 1U, 2U}, {0U, 3U, 1U}, {1U, 3U, 2U}, {2U, 3U, 0U}}) {
    soup.addPolygon(corners);
  }
  return soup;
}

TEST(CutLeavesPolygonsTest, CloseEveryPieceFarFromTheOrigin) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> anywhere(-0.2, 1.2);
  for (int n = 0; n < scaled(20) && !HasFailure(); ++n) {
    const double far = n % 2 == 0 ? 0 : 1e5;
    const auto soup = tetrahedron([&] { return far + anywhere(random); });
    const CellCutter cutter{Solid<double>(MeshSDF<double>(soup))};
    expectClosedMesh(cutter, randomMesh(random, 6, far, 1, 50), far > 0 ? 1e6 : 10);
  }
}

/// Corners within an ulp of the planes of leaves: points of fine and coarse leaves may differ by
/// rounding, as each puts them in its own cells.
TEST(CutLeavesPolygonsTest, CloseEveryPieceNearPlanes) {
  std::mt19937 random(16);
  const auto nearPlane = [&] {
    const double plane = 0.75 + static_cast<double>(random() % 7) / 4;
    const auto way = random() % 3;
    return way == 0 ? plane : std::nextafter(plane, way == 1 ? -9 : 9);
  };
  for (int n = 0; n < scaled(60) && !HasFailure(); ++n) {
    const Solid<double> solid(MeshSDF<double>(tetrahedron(nearPlane)));
    if (!solid.as<MeshSDF<double>>()->signReport().isSound()) continue;
    expectPolygonsOf(CellCutter(solid).cut(randomMesh(random, 4, 1, 1, 60), {.polygons = true}),
                     10);
  }
}

TEST(CutLeavesPolygonsTest, OfThinPlatesAndHolesInCoarseFaces) {
  auto soup = tessellation::box({-1, -1, 0.37}, {2, 2, 0.37 + 1e-9});
  soup = together(soup, tessellation::box({0.63, -1, 0.7}, {0.66, 2, 0.73}));
  for (const auto& [at, radius] : {std::pair(Vec3<double>{0.26, 0.31, 0.5}, 0.1),
                                   {Vec3<double>{0.26, 0.76, 0.503}, 0.03},
                                   {Vec3<double>{0.5, 0.5, 0.2}, 0.15}}) {
    auto ball = tessellation::icosphere(radius, 1);
    for (auto& p : ball.points) p += at;
    soup = together(soup, ball);
  }
  std::mt19937 random(14);
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const CellCutter cutter(Solid<double>(MeshSDF<double>(soup)), side);
    for (int n = 0; n < scaled(4) && !HasFailure(); ++n) {
      expectClosedMesh(cutter, randomMesh(random, 4, 0, 1, 70));
    }
  }
}

std::vector<std::vector<double>> sorted(const CutCells::Polygons& polygons) {
  std::vector<std::vector<double>> result(polygons.count());
  for (std::size_t n = 0; n < polygons.count(); ++n) {
    for (const auto& p : polygons.of(n)) result[n].insert(result[n].end(), {p.x, p.y, p.z});
  }
  std::ranges::sort(result);
  return result;
}

TEST(CutLeavesPolygonsTest, AnOctreeOfOneLevelHasThoseOfTheGrid) {
  const CellCutter cutter(turnedTorus());
  const OctreeDomain<double> domain({0.01, -0.02, 0.03}, 0.32, {3, 4, 3});
  const Octree<double> mesh(turnedTorus(), domain, {.cut = 3, .bands = {{10.0, 3}}});
  const auto cells = cutter.cut(finestOf(mesh), {.polygons = true});
  const auto leaves = cutter.cut(mesh, {.polygons = true});
  EXPECT_EQ(sorted(leaves.arcPolygons), sorted(cells.arcPolygons));
  auto own = cells.wallPolygons;  // without those of cells beyond the box
  own.first.resize(1);
  own.points.clear();
  for (std::size_t part = 0; part < cells.wallParts.piece.size(); ++part) {
    if (cells.wallParts.piece[part] >= cells.pieceCount) continue;
    for (auto n = cells.firstWallPolygon[part]; n < cells.firstWallPolygon[part + 1]; ++n) {
      own.add(cells.wallPolygons.of(n));
    }
  }
  EXPECT_EQ(sorted(leaves.wallPolygons), sorted(own));
  EXPECT_GT(own.count(), 1000U);
}

TEST(CutLeavesPolygonsTest, AreLeftOutUnlessAskedFor) {
  std::mt19937 random(15);
  const auto leaves = CellCutter(turnedTorus()).cut(randomMesh(random, 3, 0, 1));
  EXPECT_GT(leaves.cut.leaf.size(), 8U);
  EXPECT_EQ(leaves.arcPolygons.count(), 0U);
  EXPECT_EQ(leaves.wallPolygons.count(), 0U);
  EXPECT_TRUE(leaves.firstWallPolygon.empty());
}

}  // namespace
}  // namespace cutwater::test
