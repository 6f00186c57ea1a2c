#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/CellPatches.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>
#include <set>

#include "Support/Clipping.hpp"
#include "Support/OctreeMeshes.hpp"
#include "Support/Precisions.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class CellPatchesTest : public ::testing::Test {
 protected:
  using Patches = std::set<std::uint32_t>;

  /// All triangles against the cell; corners as a mesh of T holds them.
  static Patches patchesIn(const PolygonSoup& soup, const Box<T>& box) {
    Patches patches;
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      std::vector<std::array<double, 3>> part;
      for (const auto corner : soup.polygon(i)) {
        const auto [x, y, z] = Vec3<T>(soup.points[corner]);
        part.push_back({double{x}, double{y}, double{z}});
      }
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        part = clipped(part, a, double{box.lower[axis]}, 1);
        part = clipped(part, a, double{box.upper[axis]}, -1);
      }
      if (!part.empty()) patches.insert(soup.patches[i]);
    }
    return patches;
  }
  /// Every triangle has one of so many patches (one or more), without order.
  static PolygonSoup coloured(PolygonSoup soup, std::uint32_t count) {
    soup.patchNames = {"p0"};
    for (std::uint32_t n = 1; n < count; ++n) soup.patchNames.push_back("p" + std::to_string(n));
    for (std::uint32_t i = 0; i < soup.patches.size(); ++i)
      soup.patches[i] = i * 7919 % std::max(count, 1U);
    return soup;
  }
};
TYPED_TEST_SUITE(CellPatchesTest, Precisions);

TYPED_TEST(CellPatchesTest, AreThoseOfAllTrianglesThatMeetACell) {
  using T = TypeParam;
  for (const auto& plain : {tessellation::icosphere(0.8, 2), tessellation::icosphere(0.01, 0),
                            withPoints(tessellation::box({-0.7, -0.6, -0.5}, {0.8, 0.7, 0.5001}, 3),
                                       [](const Vec3<double>& p) { return 1.01 * p; })}) {
    const auto soup = this->coloured(triangulated(plain), 100);
    const MeshSDF<T> solid(soup);
    const Octree<T> mesh(solid, {{T(-1.3), T(-1.2), T(-1.25)}, T(0.6), {4, 4, 5}}, {.cut = 2});
    const auto found = cellPatches(solid, mesh);
    EXPECT_TRUE(found.isComplete);
    ASSERT_EQ(found.offsets.size(), mesh.cells().size() + 1);
    EXPECT_EQ(found.offsets.back(), found.patches.size());
    std::size_t most = 0;
    for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
      const auto& cell = mesh.cells()[n];
      const auto row = found.of(n);
      EXPECT_TRUE(std::ranges::is_sorted(row, std::ranges::less_equal{}) || row.size() < 2);
      const typename TestFixture::Patches named(row.begin(), row.end());
      EXPECT_EQ(named.size(), row.size());
      if (!mayBeCut(cell.kind)) {
        EXPECT_TRUE(row.empty());
      }
      // What comes within rounding of the cell may be named.
      const auto box = mesh.box(cell);
      const T margin = tolerance<T>(8);
      const auto fewest = this->patchesIn(soup, box.grown(-margin));
      const auto all = this->patchesIn(soup, box.grown(margin));
      EXPECT_TRUE(std::ranges::includes(named, fewest)) << n;
      EXPECT_TRUE(std::ranges::includes(all, named)) << n;
      most = std::max(most, row.size());
    }
    EXPECT_GE(most, 4U);
  }
}

TYPED_TEST(CellPatchesTest, OfUnionsAreThoseOfTheOperands) {
  using T = TypeParam;
  const auto mesh = ballAndPlateMesh<T>(3);
  Solid<T> ball = MeshSDF<T>(tessellation::icosphere(0.8, 3));
  const auto plate = Solid<T>(MeshSDF<T>(tessellation::box({-1, -1, 0.0401}, {0.5, 1, 0.0402})));
  const auto solid = named(ball, "ball") | named(plate, "plate");
  const Octree<T> around(solid, mesh.domain(), {.cut = 3});
  const auto found = cellPatches(solid, around);
  std::size_t both = 0;
  for (std::size_t n = 0; n < around.cells().size(); ++n) {
    const auto& cell = around.cells()[n];
    if (!mayBeCut(cell.kind)) continue;
    const auto row = found.of(n);
    const std::array kinds{ball.classify(around.box(cell)), plate.classify(around.box(cell))};
    for (std::uint32_t patch = 0; patch < 2; ++patch) {
      const bool isNamed = std::ranges::count(row, patch) == 1;
      EXPECT_TRUE(isNamed || kinds[patch] != BoxClass::Cut);
      EXPECT_TRUE(!isNamed || mayBeCut(kinds[patch]));
    }
    both += row.size() == 2 ? 1 : 0;
  }
  EXPECT_GT(both, 10U);
}

TYPED_TEST(CellPatchesTest, OfOtherSolidsAreSamples) {
  using T = TypeParam;
  const Torus<T> torus(T(0.7), T(0.25));
  const Octree<T> mesh(torus, {{T(-1.3), T(-1.2), T(-1.25)}, T(0.6), {4, 4, 5}}, {.cut = 3});
  const auto found = cellPatches<T>(torus, mesh);
  EXPECT_FALSE(found.isComplete);
  EXPECT_GT(found.patches.size(), mesh.count(BoxClass::Cut) / 2);
  EXPECT_LE(found.patches.size(), mesh.cells().size());
}

TYPED_TEST(CellPatchesTest, AreTheSameForAnyNumberOfThreads) {
  using T = TypeParam;
  const auto solid = ballAndPlate<T>();
  const auto mesh = ballAndPlateMesh<T>(4);
  const auto one = cellPatches(solid, mesh, {.threads = 1});
  const auto many = cellPatches(solid, mesh, {.threads = 3});
  EXPECT_EQ(one.offsets, many.offsets);
  EXPECT_EQ(one.patches, many.patches);
  EXPECT_THROW((void)cellPatches(solid, mesh, {.threads = -1}), Error);
}

}  // namespace
}  // namespace cutwater::test
