#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Cutwater.hpp>
#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <gtest/gtest.h>

#include "Support/Precisions.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

using Names = std::vector<std::string>;

/// A cube with these names, and this patch at x = 1.
PolygonSoup cubeWith(Names names, std::uint32_t patch) {
  auto soup = cube();
  soup.patchNames = std::move(names);
  soup.patches[1] = patch;
  return soup;
}

template <typename T>
class PatchNamesTest : public ::testing::Test {};
TYPED_TEST_SUITE(PatchNamesTest, Precisions);

TYPED_TEST(PatchNamesTest, ThereIsOneForEveryId) {
  using T = TypeParam;
  const auto expectNames = [](const PolygonSoup& soup, const Names& names) {
    EXPECT_EQ(DcelSDF<T>(DcelMesh<T>(soup)).patchNames(), names);
    const MeshSDF<T> mesh(soup);
    EXPECT_EQ(mesh.patchNames(), names);
    EXPECT_EQ(mesh.soup().patchNames, names);
    EXPECT_EQ(MeshSDF<T>::view(mesh.toBytes()).patchNames(), names);
    EXPECT_EQ(MeshSDF<T>(DcelMesh<T>(soup)).patchNames(), names);
  };
  expectNames(cubeWith({}, 0), {"surface"});
  expectNames(cubeWith({}, 2), {"surface", "surface", "surface"});
  expectNames(cubeWith({"hull"}, 1), {"hull", "surface"});
  expectNames(cubeWith({"", "top", "unused"}, 1), {"", "top", "unused"});
}

TYPED_TEST(PatchNamesTest, MeshesWithoutNamesStayApartInUnions) {
  using T = TypeParam;
  const auto one = cubeWith({}, 1);
  const auto other = withPoints(cube(), [](const auto& p) { return p + Vec3<double>{3, 0, 0}; });
  const auto both = Solid<T>(MeshSDF<T>(one)) | DcelSDF<T>(DcelMesh<T>(other));
  EXPECT_EQ(both.patchNames(), (Names{"surface", "surface", "all"}));
  EXPECT_EQ(both.owner({T(1.25), T(0.5), T(0.5)}).patch, 1U);
  EXPECT_EQ(both.owner({T(2.75), T(0.5), T(0.5)}).patch, 2U);
  EXPECT_EQ(named(both, "pair").patchNames(), (Names{"pair/surface", "pair/surface", "pair/all"}));
}

TYPED_TEST(PatchNamesTest, WhereAGridEndsIsNotTheMesh) {
  using T = TypeParam;
  const GridPatch<T> nodes{
      {{T(0.5), T(-0.5), T(-0.5)}, {T(0.25), T(0.25), T(0.25)}, Centering::Node},
      IndexBox::ofSize(5, 9, 9)};
  const auto soup = isosurface<T>(MeshSDF<T>(cubeWith({}, 0)), nodes);
  EXPECT_EQ(soup.patchNames, (Names{"surface", "end of grid"}));
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    double most = 0;
    for (const auto corner : soup.polygon(i)) most = std::max(most, soup.points[corner].x);
    EXPECT_EQ(soup.patches[i], most == 0.5 ? 1U : 0U);
  }
}

TYPED_TEST(PatchNamesTest, RefusesIdsForWhichThereIsNoMemory) {
  using T = TypeParam;
  EXPECT_EQ(MeshSDF<T>(cubeWith({}, (1U << 20U) - 1)).patchNames().size(), 1U << 20U);
  for (const std::uint32_t patch : {1U << 20U, kNone}) {
    const auto soup = cubeWith({"hull"}, patch);
    EXPECT_THROW(MeshSDF<T>{soup}, Error);
    EXPECT_THROW(DcelSDF<T>{DcelMesh<T>(soup)}, Error);
  }
}

}  // namespace
}  // namespace cutwater::test
