#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Mesh/Detail/PassageWalk.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>
#include <Cutwater/Triangles/SurfaceLocation.hpp>

#include <numeric>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Soups.hpp"
#include "Support/SurfaceInBlock.hpp"

namespace cutwater::test {
namespace {

/// A surface with both ways to find its triangles.
template <typename T>
struct Searchable : SurfaceInBlock<T> {
  using SurfaceInBlock<T>::data;
  using SurfaceInBlock<T>::surface;

  explicit Searchable(const PolygonSoup& soup) : SurfaceInBlock<T>(soup) {
    arrays = buildBvh<16, 4>(triangleBoxes(data.positions(), data.triangles()));
  }
  auto byTree() const {
    return [tree = arrays.tree()](const Segment<double>& segment, TriangleVisitor visit) {
      tree.along(segment, visit);
    };
  }
  auto byAll() const {
    return [n = surface.triangles.size()](const Segment<double>&, TriangleVisitor visit) {
      std::vector<std::uint32_t> all(n);
      std::iota(all.begin(), all.end(), 0U);
      visit(all);
    };
  }

  BvhArrays<16, 4> arrays;
};

template <typename T>
class SurfaceLocationTest : public ::testing::Test {};
TYPED_TEST_SUITE(SurfaceLocationTest, Precisions);

TYPED_TEST(SurfaceLocationTest, LatticePointsAreInOnOrOutOfALatticeBox) {
  // The largest coordinate is a power of two, so that positions are not scaled.
  const Searchable<TypeParam> box(tessellation::box({0, -1, 1}, {3, 2, 4}, 3));
  ASSERT_EQ(box.surface.scale, TypeParam(0.25));
  for (int x = -2; x <= 10; ++x) {
    for (int y = -4; y <= 6; ++y) {
      for (int z = 0; z <= 10; ++z) {
        const Vec3<double> p{0.5 * x, 0.5 * y, 0.5 * z};
        const bool within = 0 <= p.x && p.x <= 3 && -1 <= p.y && p.y <= 2 && 1 <= p.z && p.z <= 4;
        const bool inside = 0 < p.x && p.x < 3 && -1 < p.y && p.y < 2 && 1 < p.z && p.z < 4;
        const auto found = locate(box.surface, 0.25 * p, box.byTree());
        ASSERT_EQ(found.onSurface, within && !inside) << p;
        ASSERT_EQ(found.isInside(), inside) << p;
        const auto plain = locate(box.surface, 0.25 * p, box.byAll());
        ASSERT_EQ(found.winding, plain.winding) << p;
        ASSERT_EQ(found.onSurface, plain.onSurface) << p;
      }
    }
  }
}

TYPED_TEST(SurfaceLocationTest, CountsShellsAroundThePoint) {
  auto soup = tessellation::icosphere(1, 2);
  for (const double radius : {0.75, 0.5}) {
    soup = together(soup, tessellation::icosphere(radius, 2));
  }
  const Searchable<TypeParam> nested(soup);
  const double scale{nested.surface.scale};
  for (const auto& [x, winding] : {std::pair{1.1, 0}, {0.9, 1}, {0.6, 2}, {0.1, 3}}) {
    const auto found = locate(nested.surface, {scale * x, 0, 0}, nested.byTree());
    EXPECT_EQ(found.winding, winding) << x;
  }
}

TYPED_TEST(SurfaceLocationTest, TheTreeMissesNoPassage) {
  const Searchable<TypeParam> torus(tessellation::torus(1, 0.4, 60, 30));
  const double scale{torus.surface.scale};
  RandomPoints<double> random(2 * scale);
  int some = 0;
  for (int i = 0; i < 2'000; ++i) {
    const Segment<double> segment{random.next(), random.next()};
    std::vector<std::uint32_t> byTree;
    std::vector<std::uint32_t> byAll;
    const auto noteIn = [](std::vector<std::uint32_t>& list) {
      return [&list](std::uint32_t id, int) {
        list.push_back(id);
        return 1.0;
      };
    };
    visitPassages<TypeParam>(torus.surface, segment, torus.byTree(), noteIn(byTree));
    visitPassages<TypeParam>(torus.surface, segment, torus.byAll(), noteIn(byAll));
    std::ranges::sort(byTree);
    ASSERT_EQ(byTree, byAll);
    some += byAll.empty() ? 0 : 1;
  }
  EXPECT_GT(some, 200);
}

TYPED_TEST(SurfaceLocationTest, TheWalkGivesEveryPassageInOrder) {
  // 150 plates, 300 passages: several batches.
  PolygonSoup soup = tessellation::box({0, 0, 0}, {1, 1, 0.25});
  for (int i = 1; i < 150; ++i) {
    const double z = i % 2 == 0 ? 0.5 * i : 0.5 * (150 - i);  // not in order
    soup = together(soup, tessellation::box({0, 0, z}, {1, 1, z + 0.25}));
  }
  const Searchable<TypeParam> plates(soup);
  const double scale{plates.surface.scale};
  const auto byTree = plates.byTree();
  for (const bool up : {true, false}) {
    const Vec3<double> below{scale * 0.3, scale * 0.4, scale * -1};
    const Vec3<double> above{scale * 0.3, scale * 0.4, scale * 80};
    PassageWalk<TypeParam> walk(
        plates.surface, up ? Segment<double>{below, above} : Segment<double>{above, below}, byTree);
    int count = 0;
    double last = -1;
    for (auto p = walk.next(); p.triangle != kNone; p = walk.next()) {
      EXPECT_GT(p.parameter, last);
      EXPECT_EQ(p.direction, count % 2 == 0 ? -1 : 1);  // in, out, in, ...
      const double z = (up ? p.parameter : 1 - p.parameter) * 81 - 1;
      const int index = up ? count : 299 - count;
      EXPECT_NEAR(z, 0.5 * (index / 2) + 0.25 * (index % 2), 1e-12) << count;
      last = p.parameter;
      ++count;
    }
    EXPECT_EQ(count, 300);
    EXPECT_EQ(walk.next().triangle, kNone);
  }
}

/// Who wants the first passage only is not led to what lies far behind it.
TYPED_TEST(SurfaceLocationTest, AWalkForOnePassageStopsBehindIt) {
  PolygonSoup soup = tessellation::box({0, 0, 0}, {1, 1, 0.25}, 4);
  for (int i = 1; i < 50; ++i) {
    soup = together(soup, tessellation::box({0, 0, 0.5 * i}, {1, 1, 0.5 * i + 0.25}, 4));
  }
  const Searchable<TypeParam> plates(soup);
  const double scale{plates.surface.scale};
  const Segment<double> segment{{scale * 0.3, scale * 0.4, scale * -1},
                                {scale * 0.3, scale * 0.4, scale * 30}};
  std::size_t leaves = 0;
  const auto byTree = plates.byTree();
  const auto counted = [&](const Segment<double>& s, TriangleVisitor visit) {
    byTree(s, [&](std::span<const std::uint32_t> ids) {
      ++leaves;
      return visit(ids);
    });
  };
  PassageWalk<TypeParam> all(plates.surface, segment, counted);
  const auto first = all.next();
  const auto second = all.next();
  const auto leavesOfAll = leaves;
  leaves = 0;
  PassageWalk<TypeParam> one(plates.surface, segment, counted, 1);
  EXPECT_EQ(one.next().triangle, first.triangle);
  EXPECT_LT(8 * leaves, leavesOfAll);
  EXPECT_EQ(one.next().triangle, second.triangle);  // it goes on as the other does
}

TYPED_TEST(SurfaceLocationTest, ExactlyOneBatchIsNoSpecialCase) {
  PolygonSoup soup = tessellation::box({0, 0, 0}, {1, 1, 0.25});
  for (int i = 1; i < 32; ++i) {
    soup = together(soup, tessellation::box({0, 0, 0.5 * i}, {1, 1, 0.5 * i + 0.25}));
  }
  const Searchable<TypeParam> plates(soup);
  const double scale{plates.surface.scale};
  const auto byTree = plates.byTree();
  PassageWalk<TypeParam> walk(
      plates.surface, {{scale * 0.3, scale * 0.4, -1}, {scale * 0.3, scale * 0.4, 2}}, byTree);
  int count = 0;
  while (walk.next().triangle != kNone) ++count;
  EXPECT_EQ(count, 64);
}

}  // namespace
}  // namespace cutwater::test
