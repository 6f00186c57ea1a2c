// Cut leaves and unresolvedFeatures(), which looks at the solid and not at cut cells, agree.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/UnresolvedFeatures.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <set>

#include <gtest/gtest.h>

#include "CutCells/RandomVoxels.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

Solid<double> turned(const PolygonSoup& soup, double degrees) {
  Solid<double> solid{MeshSDF<double>(soup)};
  solid.rotate(degrees, Vec3<double>{1, 2, 3});
  solid.translate({0.0123, -0.0234, 0.0345});
  return solid;
}

struct CellCounts {
  std::size_t thin = 0;
  std::size_t severalPieces = 0;
  std::size_t notListed = 0;  ///< of these
};

/// Expects that thin cells are those of which no corner sees the surface.
CellCounts expectListed(const Solid<double>& solid, int level) {
  const OctreeDomain<double> domain({-1, -1, -1}, 1, {2, 2, 2});
  const Octree<double> mesh(solid, domain, {.cut = level});
  std::set<std::size_t> unseen;
  std::set<std::size_t> all;
  for (const auto& feature : unresolvedFeatures(solid, mesh)) {
    all.insert(feature.cell);
    if (feature.kind != UnresolvedKind::MultiCut) unseen.insert(feature.cell);
  }
  const auto leaves = CellCutter(solid).cut(mesh);
  std::set<std::size_t> thin;
  CellCounts counts;
  for (std::uint32_t row = 0; row < leaves.cut.leaf.size(); ++row) {
    const auto corners = leaves.cut.fluidCorners[row];
    if (corners == 0 || corners == 0xff) thin.insert(leaves.cut.leaf[row]);
    if (leaves.cut.firstPiece[row + 1] < leaves.cut.firstPiece[row] + 2) continue;
    ++counts.severalPieces;
    counts.notListed += all.contains(leaves.cut.leaf[row]) ? 0 : 1;
  }
  EXPECT_EQ(thin, unseen);
  counts.thin = thin.size();
  return counts;
}

TEST(UnresolvedCellsTest, OfPlatesRodsAndBalls) {
  for (const double thickness : {0.03, 1e-3, 1e-6}) {
    const auto plate = tessellation::box({-0.7, -0.6, 0}, {0.7, 0.6, thickness}, 1);
    const auto rod = tessellation::box({-0.7, 0, 0}, {0.7, thickness, thickness}, 1);
    const auto [thin, severalPieces, notListed] = expectListed(turned(plate, 33), 3);
    EXPECT_GT(thin, 50U);
    EXPECT_GT(severalPieces, 50U);
    EXPECT_EQ(notListed, 0U);
    EXPECT_GT(expectListed(turned(rod, 33), 3).thin, 10U);
  }
  expectListed(turned(tessellation::icosphere(0.6, 4), 33), 4);
  expectListed(turned(tessellation::icosphere(0.06, 2), 33), 2);
}

TEST(UnresolvedCellsTest, OfRandomVoxels) {
  std::mt19937 random(1);
  CellCounts sum;
  for (int n = 0; n < scaled(10); ++n) {
    Solid<double> solid{meshOf(randomVoxels(random))};
    solid.translate({-0.4, -0.4, -0.4});
    solid.rotate(33, Vec3<double>{1, 2, 3});
    const auto found = expectListed(solid, 3);
    sum.thin += found.thin;
    sum.severalPieces += found.severalPieces;
    sum.notListed += found.notListed;
  }
  EXPECT_GT(sum.thin, 100U);
  EXPECT_GT(sum.severalPieces, 300U);
  // Pieces that reach no corner, behind edges that are crossed once.
  EXPECT_GT(sum.notListed, 0U);
  EXPECT_LT(sum.notListed, sum.severalPieces / 10);
}

}  // namespace
}  // namespace cutwater::test
