#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Triangles/Search/ChildHulls.hpp>
#include <Cutwater/Triangles/TriangleDistance.hpp>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "Support/Soups.hpp"
#include "Support/SurfaceInBlock.hpp"

#define CUTWATER_SIMD counting
#define CUTWATER_SIMD_PORTABLE
#include <Cutwater/Triangles/Search/PointSearch.inl>

namespace cutwater::test {
namespace {

using Node = BvhNode<TriangleTree::kArity>;
using Mesh = SearchableInBlock<double>;

/// Calls visit(corner) for those of all triangles below a child, in the tree's frame.
template <typename Visit>
void forCorners(const Mesh& mesh, const Node& node, int lane, const Visit& visit) {
  const auto tree = mesh.arrays.tree();
  if (!node.isLeaf(lane)) {
    const auto& below = tree.nodes()[node.nodeIndex(lane)];
    for (int k = 0; k < std::popcount(below.childMask()); ++k) forCorners(mesh, below, k, visit);
    return;
  }
  for (const auto id : tree.leaf(node.leafIndex(lane))) {
    if (id == kNone) return;
    for (const auto& corner : mesh.surface.corners(id)) visit(tree.frame().toFrame(corner));
  }
}

TEST(ChildHullsTest, EncloseWhatIsBelow) {
  const Mesh mesh(bipyramid(5000));
  const auto nodes = mesh.arrays.tree().nodes();
  ASSERT_EQ(mesh.hulls.ofNode.size(), nodes.size());
  EXPECT_GT(2 * mesh.hulls.hulls.size(), nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (mesh.hulls.ofNode[n] == kNone) continue;
    const auto& hulls = mesh.hulls.hulls[mesh.hulls.ofNode[n]];
    for (int lane = 0; lane < std::popcount(nodes[n].childMask()); ++lane) {
      const auto k = static_cast<std::size_t>(lane);
      const auto t = hulls.triangles.corners(k);
      forCorners(mesh, nodes[n], lane, [&](const Vec3<double>& corner) {
        const auto hit = triangleDistance(nodes[n].toLocal(corner), {t[0], t[1], t[2], true});
        ASSERT_LE(std::sqrt(hit.distanceSquared), hulls.thickness[k]) << n << " " << lane;
      });
    }
  }
}

TEST(ChildHullsTest, AreNotMadeWhereBoxesAreGood) {
  for (const auto& soup : {tessellation::icosphere(1, 4), tetrahedron()}) {
    const Mesh mesh(soup);
    EXPECT_TRUE(mesh.hulls.hulls.empty());
    EXPECT_TRUE(mesh.hulls.ofNode.empty());
  }
}

struct Counter {
  int* opened;

  void onNode() const { ++*opened; }
  void onLeaf() const { ++*opened; }
  void onEvaluation(int /*triangles*/) const {}
};

/// Nodes and leaves that half of the searches for points about a bipyramid open at most; those
/// nearest to an apex, where all its triangles tie, are left out.
int medianOpenings(std::uint32_t slivers) {
  const Mesh mesh(bipyramid(slivers));
  RandomPoints<double> random(1.25);
  std::vector<int> openings;
  while (openings.size() < 500) {
    const auto p = random.next();
    if (!(std::abs(p.z) - 1 < 0.9 * std::hypot(p.x, p.y))) continue;
    const auto q = mesh.surface.scale * p;
    auto best = mesh.surface.nothing(q);
    openings.push_back(0);
    counting::nearestOne(mesh.search, KernelTriangles<double>(mesh.surface), q, best,
                         TriangleSearch::kAnywhere, Counter{&openings.back()});
  }
  std::ranges::nth_element(openings, openings.begin() + 250);
  return openings[250];
}

TEST(ChildHullsTest, SearchesAboutAFanOpenFewLeaves) {
  EXPECT_LE(medianOpenings(1'000), 7);
  EXPECT_LE(medianOpenings(20'000), 11);   // by boxes alone 42
  EXPECT_LE(medianOpenings(320'000), 19);  // 82
}

}  // namespace
}  // namespace cutwater::test
