#include <Cutwater/Grid/OctreeNodes.hpp>

#include <algorithm>
#include <set>
#include <tuple>

#include "Support/Grid.hpp"
#include "Support/OctreeMeshes.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OctreeNodesTest : public ::testing::Test {
 protected:
  using Place = std::tuple<int, int, int>;

  /// All corners of all cells, each once, on the finest level.
  static std::set<Place> placesOf(const OctreeCells<T>& mesh) {
    std::set<Place> places;
    for (const auto& [index, level, kind] : mesh.cells()) {
      const int shift = mesh.deepest() - level;
      for (int c = 0; c < 8; ++c) {
        places.insert({(index.i + (c & 1)) << shift, (index.j + (c >> 1 & 1)) << shift,
                       (index.k + (c >> 2)) << shift});
      }
    }
    return places;
  }

  static void expectNodes(const OctreeCells<T>& mesh) {
    const OctreeNodes<T> nodes(mesh);
    std::set<Place> numbered;
    for (std::size_t n = 0; n < nodes.count(); ++n) {
      const auto [i, j, k] = nodes.index(n);
      EXPECT_TRUE(numbered.insert({i, j, k}).second) << n;
    }
    EXPECT_EQ(numbered, placesOf(mesh));
    std::vector<typename OctreeNodes<T>::Corners> corners(mesh.cells().size());
    nodes.corners(0, corners);
    for (std::size_t n = 0; n < corners.size(); ++n) {
      const auto box = mesh.box(mesh.cells()[n]);
      EXPECT_EQ(corners[n][0], n);
      for (int c = 0; c < 8; ++c) {
        const auto node = corners[n][static_cast<std::size_t>(c)];
        ASSERT_LT(node, nodes.count());
        EXPECT_EQ(nodes.position(node), box.corner(c));
      }
    }
  }
};
TYPED_TEST_SUITE(OctreeNodesTest, Precisions);

TYPED_TEST(OctreeNodesTest, AreAllCornersOnce) {
  using T = TypeParam;
  for (const auto balance : {Balance::None, Balance::Face, Balance::Corner}) {
    this->expectNodes(ballAndPlateMesh<T>(4, balance));
  }
}

TYPED_TEST(OctreeNodesTest, OfAnyStretchOfAMesh) {
  using T = TypeParam;
  const auto mesh = ballAndPlateMesh<T>(3);
  const auto expectNodesOf = [&](std::size_t first, std::size_t count) {
    const auto some = mesh.cells().subspan(first, count);
    this->expectNodes(OctreeCells<T>(mesh.domain(), 3, {some.begin(), some.end()}));
  };
  expectNodesOf(0, 0);
  for (std::size_t first = 0; first < 1500; first += 83) {
    for (const std::size_t count : {1U, 3U, 8U, 250U}) expectNodesOf(first, count);
  }
  expectNodesOf(mesh.cells().size() - 100, 100);
}

TYPED_TEST(OctreeNodesTest, OfAMeshWithoutLevels) {
  using T = TypeParam;
  this->expectNodes(ballAndPlateMesh<T>(0));
  const OctreeDomain<T> cube({0, 0, 0}, 1, {1, 1, 1});
  this->expectNodes(Octree<T>(ballAndPlate<T>(), cube, Refinement<T>{}));
}

TYPED_TEST(OctreeNodesTest, OfTheDeepestMeshThereIs) {
  using T = TypeParam;
  const auto mesh = deepMesh<T>();
  ASSERT_EQ(mesh.deepest(), 17);
  ASSERT_EQ(mesh.cells().back().level, 17);
  this->expectNodes(mesh);
}

TYPED_TEST(OctreeNodesTest, AreTheSameInAnyOrderAndForAnyNumberOfThreads) {
  using T = TypeParam;
  const auto mesh = ballAndPlateMesh<T>(6);
  ASSERT_GT(mesh.cells().size(), 100'000U);  // work for several threads
  const OctreeNodes<T> one(mesh, {.threads = 1});
  const OctreeNodes<T> many(mesh, {.threads = 5});
  ASSERT_EQ(one.count(), many.count());
  const auto size = mesh.cells().size();
  std::vector<typename OctreeNodes<T>::Corners> all(size);
  one.corners(0, all);
  typename OctreeNodes<T>::Corners corners{};
  for (std::size_t n = size; n-- > 0; n -= std::min<std::size_t>(n, 37)) {
    many.corners(n, std::span(&corners, 1));
    EXPECT_EQ(corners, all[n]);
  }
  for (std::size_t n = 0; n < one.count(); ++n) ASSERT_EQ(one.index(n), many.index(n));

  std::vector<std::size_t> some;
  for (std::size_t n = 5; n < size; n += 1 + n % 41) some.push_back(n);
  std::vector<typename OctreeNodes<T>::Corners> theirs(some.size());
  one.corners(some, theirs);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(theirs[i], all[some[i]]);
}

}  // namespace
}  // namespace cutwater::test
