#include <Cutwater/Grid/Detail/FacetTree.hpp>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class FacetTreeTest : public ::testing::Test {
 protected:
  using Facet = SurfaceFacet<T>;

  std::vector<Facet> randomFacets(int count, T spread, T size) {
    std::vector<Facet> facets;
    while (facets.size() < static_cast<std::size_t>(count)) {
      const auto at = spread * random_.next();
      Facet facet{};
      for (auto& corner : facet.corners) corner = at + size * random_.next();
      const auto& [a, b, c] = facet.corners;
      facet.normal = normalized(cross(b - a, c - a));
      if (facet.normal != Vec3<T>{}) facets.push_back(facet);
    }
    return facets;
  }
  static detail::FacetTree<T> treeOf(const std::vector<Facet>& facets) {
    detail::FacetTree<T> tree;
    for (const auto& facet : facets) tree.add(facet);
    tree.build();
    return tree;
  }
  static Box<T> boxOf(const Facet& facet) {
    Box<T> box;
    for (const auto& corner : facet.corners) box.extend(corner);
    return box;
  }
  /// By the definition.
  static bool face(const Facet& a, const Facet& b, T side, T least) {
    T before = -1;
    T after = -1;
    for (const auto& corner : a.corners) {
      before = std::max(before, side * dot(b.normal, corner - b.corners[0]));
    }
    for (const auto& corner : b.corners) {
      after = std::max(after, side * dot(a.normal, corner - a.corners[0]));
    }
    return dot(a.normal, b.normal) < T(-0.5) && before > least && after > least;
  }

  RandomPoints<T> random_{1, /*seed=*/3};
};
TYPED_TEST_SUITE(FacetTreeTest, Precisions);

TYPED_TEST(FacetTreeTest, FindsWhatAComparisonOfAllPairsFinds) {
  using T = TypeParam;
  std::array<int, 2> counts{};
  for (int n = 0; n < 400; ++n) {
    const auto own = this->randomFacets(1 + n % 13, T(0.1), T(0.05));
    const auto others = this->randomFacets(1 + n % 29, T(0.7), T(0.05));
    const Box<T> region = Box<T>{{}, {}}.grown(T(0.01) * static_cast<T>(n % 50));
    const T side = n % 2 == 0 ? T(1) : T(-1);
    const T least = T(0.02) * static_cast<T>(n % 3);
    const auto isNear = [&](const auto& facet) { return this->boxOf(facet).overlaps(region); };
    bool expected = false;
    for (const auto& a : own) {
      for (const auto& b : others) {
        expected = expected || (this->face(a, b, side, least) && isNear(b));
      }
    }
    const auto facing = side > 0 ? detail::Facing::Fronts : detail::Facing::Backs;
    const bool found = this->treeOf(own).isFaced(
        this->treeOf(others), facing, least,
        [&](const Box<T>& box) { return box.overlaps(region); }, isNear);
    EXPECT_EQ(found, expected) << n;
    ++counts[expected ? 1 : 0];
  }
  EXPECT_GT(counts[0], 50);
  EXPECT_GT(counts[1], 50);
}

TYPED_TEST(FacetTreeTest, DoesNotLookAtFacetsThatCannotFace) {
  using T = TypeParam;
  // Of two heaps back to back, a wall but no gap.
  std::vector<SurfaceFacet<T>> left;
  std::vector<SurfaceFacet<T>> right;
  for (int n = 0; n < 1000; ++n) {
    const T y = T(0.01) * static_cast<T>(n % 40);
    const T z = T(0.01) * static_cast<T>(n / 40);
    left.push_back({{{{-1, y, z}, {-1, y, z + 1}, {-1, y + 1, z}}}, {-1, 0, 0}, {}, {}});
    right.push_back({{{{1, y, z}, {1, y + 1, z}, {1, y, z + 1}}}, {1, 0, 0}, {}, {}});
  }
  const auto own = this->treeOf(left);
  const auto others = this->treeOf(right);
  int looks = 0;
  const auto look = [&](const auto&) {
    ++looks;
    return true;
  };
  EXPECT_FALSE(own.isFaced(others, detail::Facing::Fronts, 0, look, look));
  EXPECT_EQ(looks, 0);
  EXPECT_TRUE(own.isFaced(others, detail::Facing::Backs, 0, look, look));
  EXPECT_LT(looks, 40);
  detail::FacetTree<T> nothing;
  nothing.build();
  EXPECT_FALSE(own.isFaced(nothing, detail::Facing::Backs, 0, look, look));
  EXPECT_FALSE(nothing.isFaced(own, detail::Facing::Backs, 0, look, look));
}

}  // namespace
}  // namespace cutwater::test
