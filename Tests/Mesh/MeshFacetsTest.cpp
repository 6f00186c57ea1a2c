#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <map>
#include <set>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class MeshFacetsTest : public ::testing::Test {
 protected:
  using Facets = std::multimap<std::uint32_t, SurfaceFacet<T>>;  // by face

  static Facets facetsOf(const SignedDistanceFunction<T>& solid, const Box<T>& box) {
    Facets found;
    EXPECT_TRUE(solid.facetsIn(box, [&](const SurfaceFacet<T>& facet) {
      const auto [first, last] = found.equal_range(facet.owner.face);
      const bool isNew = std::none_of(
          first, last, [&](const auto& other) { return other.second.corners == facet.corners; });
      EXPECT_TRUE(isNew) << "shown twice";
      found.emplace(facet.owner.face, facet);
      return true;
    }));
    return found;
  }
  /// Triangles with one of some points of theirs in the box.
  static std::set<std::uint32_t> sampled(const MeshSDF<T>& mesh, const Box<T>& box) {
    constexpr int kParts = 12;
    std::set<std::uint32_t> ids;
    for (std::uint32_t id = 0; id < mesh.triangleCount(); ++id) {
      const auto [a, b, c] = mesh.triangle(id);
      for (int i = 0; i <= kParts; ++i) {
        for (int j = 0; i + j <= kParts; ++j) {
          const T u = T(i) / kParts;
          const T v = T(j) / kParts;
          const auto p = mesh.placement().toWorld(a + u * (b - a) + v * (c - a));
          if (box.contains(p)) ids.insert(id);
        }
      }
    }
    return ids;
  }
};
TYPED_TEST_SUITE(MeshFacetsTest, Precisions);

TYPED_TEST(MeshFacetsTest, AreAllTrianglesThatMeetTheBox) {
  using T = TypeParam;
  for (const auto& soup : {tessellation::icosphere(1, 3), star(40), lPrism()}) {
    MeshSDF<T> mesh(soup);
    mesh.rotate(25, {1, 2, 3});
    mesh.translate({T(0.1), T(-0.2), 0});
    RandomPoints<T> points(5);
    const auto size = mesh.boundingBox().size();
    std::size_t all = 0;
    for (int n = 0; n < 30; ++n) {
      const auto from = mesh.boundingBox().center() + maxComponent(size) * points.next();
      const auto center = mesh.closestPoint(from).point;
      const T half = T(0.005) * static_cast<T>(1 + n) * maxComponent(size);
      const Box<T> box = Box<T>{center, center}.grown(half);
      const auto facets = this->facetsOf(mesh, box);
      for (const auto face : this->sampled(mesh, box)) {
        // Of soups of triangles; others are divided.
        if (soup.polygonCount() != mesh.triangleCount()) continue;
        EXPECT_TRUE(facets.contains(face));
      }
      for (const auto& [face, facet] : facets) {
        Box<T> around;
        for (const auto& corner : facet.corners) around.extend(corner);
        EXPECT_TRUE(around.overlaps(box.grown(tolerance<T>(4))));
        const auto [a, b, c] = facet.corners;
        EXPECT_NEAR(length(facet.normal - normalized(cross(b - a, c - a))), 0, tolerance<T>(64));
      }
      all += facets.size();
    }
    EXPECT_GT(all, 10U);
  }
}

TYPED_TEST(MeshFacetsTest, KnowWhatLiesAcrossTheirEdges) {
  using T = TypeParam;
  const MeshSDF<T> mesh(tessellation::box({0, 0, 0}, {1, 1, 1}));
  const auto count = [&](const Box<T>& box) {
    std::size_t bends = 0;
    for (const auto& [face, facet] : this->facetsOf(mesh, box)) {
      for (const auto& normal : facet.across) {
        if (normal != Vec3<T>{} && dot(normal, facet.normal) < T(0.5)) ++bends;
      }
    }
    return bends;
  };
  EXPECT_EQ(count({{T(0.4), T(0.7), T(-0.1)}, {T(0.5), T(0.8), T(0.1)}}), 0U);   // within a face
  EXPECT_EQ(count({{T(0.4), T(-0.1), T(-0.1)}, {T(0.5), T(0.1), T(0.1)}}), 2U);  // an edge
  EXPECT_EQ(count({{T(-0.1), T(-0.1), T(-0.1)}, {T(0.1), T(0.1), T(0.1)}}), 6U);
}

TYPED_TEST(MeshFacetsTest, AreThoseOfTheOperands) {
  using T = TypeParam;
  const MeshSDF<T> mesh(tessellation::icosphere(1, 2));
  const Solid<T> moved = translated(Solid<T>(mesh), {3, 0, 0});
  const Solid<T> solid = named(Solid<T>(mesh), "left") | ~~moved;
  const Box<T> box{{T(2.5), T(-0.5), T(0.5)}, {T(3.5), T(0.5), T(1.5)}};
  const auto whole = this->facetsOf(solid, box);
  const auto alone =
      this->facetsOf(mesh, {box.lower - Vec3<T>{3, 0, 0}, box.upper - Vec3<T>{3, 0, 0}});
  ASSERT_EQ(whole.size(), alone.size());
  EXPECT_GT(alone.size(), 4U);
  for (const auto& [face, facet] : whole) {
    EXPECT_EQ(facet.owner.object, 1U);
    EXPECT_EQ(facet.owner.patch, 1U);
    EXPECT_EQ(facet.normal, alone.find(face)->second.normal);
    EXPECT_NEAR(length(facet.corners[1] - alone.find(face)->second.corners[1] - Vec3<T>{3, 0, 0}),
                0, tolerance<T>(4));
  }
  for (const auto& [face, facet] : this->facetsOf(~moved, box)) {
    EXPECT_EQ(facet.normal, -alone.find(face)->second.normal);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(facet.across[i], -alone.find(face)->second.across[i]);
  }
}

TYPED_TEST(MeshFacetsTest, StopWhenToldTo) {
  using T = TypeParam;
  const MeshSDF<T> mesh(tessellation::icosphere(1, 2));
  const Solid<T> both = Solid<T>(mesh) | translated(Solid<T>(mesh), {T(0.1), 0, 0});
  int shown = 0;
  const auto visit = [&](const SurfaceFacet<T>&) { return ++shown < 7; };
  both.facetsIn({{-2, -2, -2}, {2, 2, 2}}, visit);
  EXPECT_EQ(shown, 7);
  shown = 0;
  const DcelSDF<T> withoutTree(DcelMesh<T>(tessellation::icosphere(1, 2)));
  withoutTree.facetsIn({{-2, -2, -2}, {2, 2, 2}}, visit);
  EXPECT_EQ(shown, 7);
}

TYPED_TEST(MeshFacetsTest, OfOtherSolidsAreSamples) {
  using T = TypeParam;
  const Sphere<T> sphere({0, 0, 0}, 1);
  int shown = 0;
  const auto visit = [&](const SurfaceFacet<T>& facet) {
    EXPECT_NEAR(length(facet.corners[0]), 1, tolerance<T>(8));
    EXPECT_EQ(facet.corners[0], facet.corners[2]);
    EXPECT_NEAR(length(facet.normal - facet.corners[0]), 0, tolerance<T>(8));
    ++shown;
    return true;
  };
  EXPECT_FALSE(sphere.facetsIn({{T(0.9), T(-0.1), T(-0.1)}, {T(1.1), T(0.1), T(0.1)}}, visit));
  EXPECT_EQ(shown, 27);
  shown = 0;
  sphere.facetsIn({{T(1.1), T(-0.1), T(-0.1)}, {T(1.3), T(0.1), T(0.1)}}, visit);
  EXPECT_EQ(shown, 0);
  EXPECT_TRUE(sphere.facetsIn(Box<T>{}, visit));
  EXPECT_EQ(shown, 0);
}

}  // namespace
}  // namespace cutwater::test
