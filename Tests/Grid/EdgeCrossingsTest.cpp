#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/EdgeCrossings.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>

#include <cmath>

#include "Support/Grid.hpp"
#include "Support/OctreeMeshes.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
struct EdgeArrays {
  std::vector<std::uint32_t> count;
  std::vector<T> first;
  std::vector<T> last;
  std::vector<std::uint32_t> firstPatch;
  std::vector<std::uint32_t> lastPatch;
};

/// The index of the next node on an axis.
Index3 next(Index3 node, int axis) {
  ++(axis == 0 ? node.i : axis == 1 ? node.j : node.k);
  return node;
}

template <typename T>
class EdgeCrossingsTest : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kUnwritten = 77;

  /// Edges of a grid patch along each axis, with what was found about them.
  struct Edges {
    std::array<IndexBox, 3> boxes;
    std::array<EdgeArrays<T>, 3> arrays;
    EdgeCrossingReport report;
  };

  static Edges found(const SignedDistanceFunction<T>& solid, const GridPatch<T>& gridPatch,
                     const EdgeCrossingOptions& options = {}) {
    Edges edges;
    std::array<EdgeCrossingTargets<T>, 3> targets;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto& box = edges.boxes[axis];
      box = gridPatch.indices;
      --(axis == 0 ? box.hi.i : axis == 1 ? box.hi.j : box.hi.k);
      auto& a = edges.arrays[axis];
      const auto view = [&](auto& array, auto unwritten) {
        array.assign(box.count(), unwritten);
        using Value = std::remove_cvref_t<decltype(array[0])>;
        return GridView<Value>::contiguous(array.data(), box);
      };
      targets[axis] = {view(a.count, kUnwritten), view(a.first, T(kUnwritten)),
                       view(a.last, T(kUnwritten)), view(a.firstPatch, kUnwritten),
                       view(a.lastPatch, kUnwritten)};
    }
    edges.report = edgeCrossings(solid, gridPatch, targets, options);
    return edges;
  }

  /// Compares every edge with what the solid says of it alone. Returns how many are crossed more
  /// than once.
  static std::size_t expectAsOneByOne(const SignedDistanceFunction<T>& solid,
                                      const GridPatch<T>& gridPatch) {
    const auto edges = found(solid, gridPatch);
    std::size_t crossed = 0;
    std::size_t often = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::size_t n = 0;
      forEachIndex(edges.boxes[static_cast<std::size_t>(axis)], [&](const Index3& node) {
        const auto& a = edges.arrays[static_cast<std::size_t>(axis)];
        expectEdge(
            solid, {gridPatch.level.position(node), gridPatch.level.position(next(node, axis))},
            axis, {{a.count[n]}, {a.first[n]}, {a.last[n]}, {a.firstPatch[n]}, {a.lastPatch[n]}});
        crossed += a.count[n] > 0 ? 1 : 0;
        often += a.count[n] > 1 ? 1 : 0;
        ++n;
      });
    }
    EXPECT_EQ(edges.report.crossed, crossed);
    return often;
  }

  static void expectEdge(const SignedDistanceFunction<T>& solid, const Segment<T>& edge, int axis,
                         const EdgeArrays<T>& told) {
    std::vector<Crossing<T>> crossings;
    solid.crossings(edge, [&](const Crossing<T>& crossing) {
      crossings.push_back(crossing);
      return true;
    });
    const auto count = told.count[0];
    ASSERT_EQ(count, crossings.size()) << edge.start << edge.end;
    const bool differ =
        (solid.signedDistance(edge.start) < 0) != (solid.signedDistance(edge.end) < 0);
    ASSERT_EQ(count % 2 == 1, differ) << edge.start << edge.end;
    if (count == 0) {
      ASSERT_TRUE(std::isnan(told.first[0]) && std::isnan(told.last[0]));
      ASSERT_EQ(told.firstPatch[0], kNone);
      ASSERT_EQ(told.lastPatch[0], kNone);
      return;
    }
    const T error = tolerance<T>(4);
    ASSERT_NEAR(told.first[0], crossings.front().point[axis], error);
    ASSERT_NEAR(told.last[0], crossings.back().point[axis], error);
    ASSERT_LE(edge.start[axis], told.first[0]);
    ASSERT_LE(told.first[0], told.last[0]);
    ASSERT_LE(told.last[0], edge.end[axis]);
    ASSERT_EQ(told.firstPatch[0], crossings.front().owner.patch);
    ASSERT_EQ(told.lastPatch[0], crossings.back().owner.patch);
  }

  static GridPatch<T> nodes(const Vec3<T>& origin, T spacing, const IndexBox& indices) {
    return {Level<T>(origin, {spacing, spacing, spacing}, Centering::Node), indices};
  }
};
TYPED_TEST_SUITE(EdgeCrossingsTest, Precisions);

TYPED_TEST(EdgeCrossingsTest, OfAUnionAreThoseOfEachEdgeAlone) {
  using T = TypeParam;
  const auto gridPatch =
      this->nodes({T(-0.1), T(0.03), 0}, T(0.057), {{-19, -23, -17}, {20, 18, 21}});
  // Edges along z go through both sides of the plate.
  EXPECT_GT(this->expectAsOneByOne(ballAndPlate<T>(), gridPatch), 400U);
}

TYPED_TEST(EdgeCrossingsTest, OfAMeshWithOtherSpacings) {
  using T = TypeParam;
  MeshSDF<T> ball(tessellation::icosphere(0.8, 4));
  ball.rotate(33, {1, 0, 2});
  // Most edges along z that meet the ball go all the way through it.
  const Level<T> level({0, 0, T(-0.85)}, {T(0.03), T(0.11), T(1.7)}, Centering::Node);
  EXPECT_GT(this->expectAsOneByOne(ball, {level, {{-33, -9, -2}, {34, 10, 2}}}), 500U);
}

TYPED_TEST(EdgeCrossingsTest, ThroughVerticesAlongEdgesAndInFaces) {
  using T = TypeParam;
  // Faces, edges and vertices on nodes, and triangles' diagonals through them.
  const MeshSDF<T> box(tessellation::box({0, 0, 0}, {2, 2, 2}, 2));
  this->expectAsOneByOne(box, this->nodes({0, 0, 0}, T(0.5), {{-3, -3, -3}, {7, 7, 7}}));
  this->expectAsOneByOne(Cuboid<T>({0, 0, 0}, {1, 1, 2}),
                         this->nodes({0, 0, 0}, T(0.25), {{-3, -3, -3}, {9, 9, 9}}));
}

TYPED_TEST(EdgeCrossingsTest, OfAPlateBetweenTheNodes) {
  using T = TypeParam;
  const Cuboid<T> plate({-1, -1, T(0.401)}, {1, 1, T(0.402)});
  const auto gridPatch = this->nodes({0, 0, 0}, T(0.25), {{-8, -8, -8}, {8, 8, 8}});
  const auto edges = this->found(plate, gridPatch);
  // 7 x 7 edges go straight through: those at x, y = -1, 1 lie in its sides, which are outside.
  EXPECT_EQ(edges.report.crossed, 49U);
  const auto& z = edges.arrays[2];
  std::size_t n = 0;
  forEachIndex(edges.boxes[2], [&](const Index3& node) {
    const bool isCrossed = node.k == 1 && std::abs(node.i) < 4 && std::abs(node.j) < 4;
    EXPECT_EQ(z.count[n], isCrossed ? 2U : 0U);
    if (isCrossed) {
      EXPECT_NEAR(z.first[n], T(0.401), tolerance<T>(1));
      EXPECT_NEAR(z.last[n], T(0.402), tolerance<T>(1));
    }
    ++n;
  });
}

TYPED_TEST(EdgeCrossingsTest, DoNotDependOnThePatchOrTheThreads) {
  using T = TypeParam;
  const auto solid = ballAndPlate<T>();
  const auto whole = this->nodes({0, 0, 0}, T(0.041), {{-40, -35, -37}, {39, 33, 41}});
  const auto all = this->found(solid, whole, {.threads = 1});
  const auto part = this->nodes({0, 0, 0}, T(0.041), {{-21, -27, -9}, {18, 13, 25}});
  for (const int threads : {1, 5}) {
    const auto some = this->found(solid, part, {.threads = threads});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& box = all.boxes[axis];
      std::size_t n = 0;
      forEachIndex(some.boxes[axis], [&](const Index3& node) {
        const auto m =
            static_cast<std::size_t>(node.i - box.lo.i) +
            box.length(0) * (static_cast<std::size_t>(node.j - box.lo.j) +
                             box.length(1) * static_cast<std::size_t>(node.k - box.lo.k));
        ASSERT_EQ(some.arrays[axis].count[n], all.arrays[axis].count[m]);
        ASSERT_TRUE(sameBits(some.arrays[axis].first[n], all.arrays[axis].first[m]));
        ASSERT_TRUE(sameBits(some.arrays[axis].last[n], all.arrays[axis].last[m]));
        ASSERT_EQ(some.arrays[axis].firstPatch[n], all.arrays[axis].firstPatch[m]);
        ASSERT_EQ(some.arrays[axis].lastPatch[n], all.arrays[axis].lastPatch[m]);
        ++n;
      });
    }
  }
}

TYPED_TEST(EdgeCrossingsTest, ThatCannotBeExcludedAreCounted) {
  using T = TypeParam;
  // Promises nothing: whatever has no change of sign may hide an even number of crossings.
  const FunctionSDF wild([](const Vec3<T>& p) { return p.x - T(0.3); }, Guarantee<T>{});
  const auto gridPatch = this->nodes({0, 0, 0}, 1, {{0, 0, 0}, {1, 1, 1}});
  const auto edges = this->found(wild, gridPatch);
  EXPECT_EQ(edges.report.crossed, 4U);
  EXPECT_EQ(edges.report.unresolved, 12U);
  EXPECT_EQ(this->found(Sphere<T>({0, 0, 0}, T(0.3)), gridPatch).report.unresolved, 0U);
}

TYPED_TEST(EdgeCrossingsTest, LeavesOutWhatIsNotAskedFor) {
  using T = TypeParam;
  const auto gridPatch = this->nodes({0, 0, 0}, T(0.25), {{-8, -8, -8}, {8, 8, 8}});
  const auto solid = ballAndPlate<T>();
  std::vector<T> last(16 * 17 * 17 * 2, -7);  // every second value is somebody else's
  std::array<EdgeCrossingTargets<T>, 3> targets;
  targets[0].last = {last.data(), {2, 32, 32 * 17}};
  const auto report = edgeCrossings(solid, gridPatch, targets);
  const auto all = this->found(solid, gridPatch);
  EXPECT_EQ(report.crossed, all.report.crossed);
  for (std::size_t n = 0; n < last.size(); ++n) {
    EXPECT_TRUE(sameBits(last[n], n % 2 == 0 ? all.arrays[0].last[n / 2] : T(-7)));
  }
}

TYPED_TEST(EdgeCrossingsTest, OfPatchesWithoutEdges) {
  using T = TypeParam;
  const auto solid = ballAndPlate<T>();
  for (const IndexBox& indices : {IndexBox{}, IndexBox{{0, 0, 0}, {0, 0, 0}}}) {
    const auto report = edgeCrossings(solid, this->nodes({0, 0, 0}, 1, indices), {});
    EXPECT_EQ(report.crossed, 0U);
  }
  // Next to the end of all indices.
  constexpr auto kLast = std::numeric_limits<std::int32_t>::max();
  const T far = -static_cast<T>(kLast);
  const auto gridPatch =
      this->nodes({far, far, far}, 1, {{kLast - 2, kLast, kLast}, {kLast, kLast, kLast}});
  if (sizeof(T) == 8) {
    const auto edges = this->found(Sphere<T>({T(-1.5), 0, 0}, T(0.25)), gridPatch);
    EXPECT_EQ(edges.arrays[0].count, (std::vector<std::uint32_t>{2, 0}));
  }
}

TYPED_TEST(EdgeCrossingsTest, RefusesWhatCannotBe) {
  using T = TypeParam;
  const auto solid = ballAndPlate<T>();
  const GridPatch<T> cells{Level<T>({0, 0, 0}, {1, 1, 1}), IndexBox::ofSize(2, 2, 2)};
  EXPECT_THROW(edgeCrossings(solid, cells, {}), Error);
  const auto gridPatch = this->nodes({0, 0, 0}, 1, IndexBox::ofSize(2, 2, 2));
  EXPECT_THROW(edgeCrossings(solid, gridPatch, {}, {.threads = -1}), Error);
}

}  // namespace
}  // namespace cutwater::test
