#include <Cutwater/Adapters/NodeLevelSet.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/EdgeCrossings.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>

#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class NodeLevelSetTest : public ::testing::Test {
 protected:
  static constexpr T kUnwritten = 77;

  static Solid<T> ball() { return Sphere<T>({T(0.03), T(-0.02), T(0.01)}, T(0.7)); }
  /// Nodes from -1.6 on, a tenth apart or nearly so.
  static Level<T> level() {
    return {{T(-1.6), T(-1.6), T(-1.6)}, {T(0.1), T(0.11), T(0.09)}, Centering::Node};
  }
  static FluidDomain<T> around(const Solid<T>& solid) {
    return {solid, FluidSide::Outside, {T(-1.55), T(-1.55), T(-1.55)}};
  }

  /// The values at a block of nodes, written through strides other than the usual ones.
  struct Filled {
    IndexBox nodes;
    std::vector<T> values;
    GridView<T> view;

    Filled(const NodeLevelSet<T>& levelSet, const IndexBox& box) : nodes(box) {
      const auto n = static_cast<std::ptrdiff_t>(box.length(2));
      const auto m = static_cast<std::ptrdiff_t>(box.length(1));
      values.assign(box.count() * 2, kUnwritten);
      view = {values.data(), {2 * n * m, 2 * n, 2}};  // z fastest, every other value
      levelSet.fill(box, view);
    }
    T at(const Index3& node) const {
      return view.at(static_cast<std::size_t>(node.i - nodes.lo.i),
                     static_cast<std::size_t>(node.j - nodes.lo.j),
                     static_cast<std::size_t>(node.k - nodes.lo.k));
    }
  };

  /// Compares a filled block with values asked one by one, beyond `within` at its nearest node.
  static void expectFilled(const IndexBox& nodes, const IndexBox& within) {
    const auto domain = around(ball());
    const NodeLevelSet<T> levelSet(domain, level(), within);
    const Filled filled(levelSet, nodes);
    forEachIndex(nodes, [&](const Index3& node) {
      const Index3 nearest{std::clamp(node.i, within.lo.i, within.hi.i),
                           std::clamp(node.j, within.lo.j, within.hi.j),
                           std::clamp(node.k, within.lo.k, within.hi.k)};
      const T value = domain.levelSet(level().position(nearest));
      const T most = T(1.25) * maxComponent(level().spacing());
      if (std::abs(value) <= most) {
        EXPECT_TRUE(sameBits(filled.at(node), value));
      } else {
        EXPECT_NEAR(filled.at(node), std::copysign(most, value), 1e-6);
      }
    });
    for (std::size_t i = 1; i < filled.values.size(); i += 2) {
      EXPECT_EQ(filled.values[i], kUnwritten);
    }
  }

  /// The edge along an axis, with the level set at its ends.
  static NodeEdge<T> edgeAt(const FluidDomain<T>& domain, const Index3& node, int axis) {
    NodeEdge<T> edge{node, axis};
    edge.atNode = domain.levelSet(level().position(node));
    edge.atNext = domain.levelSet(level().position(edge.next()));
    return edge;
  }
};

TYPED_TEST_SUITE(NodeLevelSetTest, Precisions);

TYPED_TEST(NodeLevelSetTest, FillsBlocksWithinAndBeyondABox) {
  const IndexBox nodes{{4, 5, 6}, {12, 11, 13}};
  using Nodes = NodeLevelSet<TypeParam>;
  this->expectFilled(nodes, Nodes::everywhere());
  this->expectFilled(nodes, {{6, 0, 7}, {40, 9, 11}});
  this->expectFilled(nodes, {{20, 6, 6}, {22, 7, 40}});  // before it in x
  this->expectFilled(nodes, {{0, 6, 0}, {2, 7, 1}});     // after it in x and z
  this->expectFilled(nodes, {{8, 8, 8}, {8, 8, 8}});     // one node
  this->expectFilled(nodes, {{30, 30, 30}, {31, 31, 31}});
  this->expectFilled({{4, 5, 6}, {4, 9, 6}}, {{0, 6, 7}, {3, 8, 9}});  // thin blocks
}

TYPED_TEST(NodeLevelSetTest, LeavesEmptyBlocksAlone) {
  using T = TypeParam;
  const auto domain = this->around(this->ball());
  T value = 5;
  NodeLevelSet<T>(domain, this->level()).fill({{0, 0, 0}, {-1, 3, 3}}, GridView<T>{&value, {}});
  EXPECT_EQ(value, 5);
}

TYPED_TEST(NodeLevelSetTest, ClassifiesTheBoxThatNodesSpan) {
  using T = TypeParam;
  const auto domain = this->around(this->ball());
  const NodeLevelSet<T> levelSet(domain, this->level());
  EXPECT_EQ(levelSet.classify({{0, 0, 0}, {4, 4, 4}}), FluidClass::Fluid);
  EXPECT_EQ(levelSet.classify({{14, 14, 14}, {18, 16, 19}}), FluidClass::Body);
  EXPECT_EQ(levelSet.classify({{4, 4, 4}, {14, 14, 14}}), FluidClass::Cut);
  EXPECT_EQ(levelSet.classify({{0, 0, 16}, {30, 30, 16}}), FluidClass::Cut) << "one layer";
  // Behind a face of the domain the body goes on.
  const NodeLevelSet<T> bounded(domain, this->level(), {{0, 0, 0}, {16, 40, 40}});
  EXPECT_EQ(bounded.classify({{30, 14, 17}, {35, 14, 17}}), FluidClass::Body);
  EXPECT_EQ(levelSet.classify({{30, 14, 17}, {35, 14, 17}}), FluidClass::Fluid);
}

// A line through a sphere: closed form.
TYPED_TEST(NodeLevelSetTest, InterceptsOfASphereAreWhereItsSurfaceIs) {
  using T = TypeParam;
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const FluidDomain<T> domain(this->ball(), side,
                                side == FluidSide::Inside ? Vec3<T>{} : Vec3<T>{2, 2, 2});
    const NodeLevelSet<T> levelSet(domain, this->level());
    int cut = 0;
    forEachIndex({{0, 0, 0}, {30, 30, 30}}, [&](const Index3& node) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto edge = this->edgeAt(domain, node, axis);
        const T found = levelSet.intercept(edge);
        if (!edge.isCut()) {
          EXPECT_TRUE(std::isnan(found));
          continue;
        }
        ++cut;
        const auto a = this->level().position(node);
        const auto b = this->level().position(edge.next());
        EXPECT_TRUE(a[axis] < found && found < b[axis]);
        auto local = a - Vec3<T>{T(0.03), T(-0.02), T(0.01)};
        local[axis] = 0;
        const T half = std::sqrt(T(0.49) - lengthSquared(local));
        const T center = axis == 0 ? T(0.03) : axis == 1 ? T(-0.02) : T(0.01);
        const bool isLower = (edge.atNode < 0) == (side == FluidSide::Outside);  // into the ball
        const T nearest = isLower ? center - half : center + half;
        EXPECT_NEAR(found, nearest, tolerance<T>(1, 64) / std::max(half, T(0.01)));
      }
    });
    EXPECT_GT(cut, 500);
  }
}

// To the bit what edgeCrossings() says, which has its own tests.
TYPED_TEST(NodeLevelSetTest, InterceptsOfAMeshAreItsCrossings) {
  using T = TypeParam;
  Solid<T> torus = MeshSDF<T>(tessellation::torus(0.8, 0.3, 24, 12));
  torus.rotate(20, {1, 2, 3});
  const auto domain = this->around(torus);
  const NodeLevelSet<T> levelSet(domain, this->level());
  const auto nodes = IndexBox::ofSize(32, 32, 32);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::uint32_t> count(nodes.count());
    std::vector<T> first(nodes.count());
    std::vector<T> last(nodes.count());
    std::array<EdgeCrossingTargets<T>, 3> targets;
    targets[static_cast<std::size_t>(axis)] = {
        .count = GridView<std::uint32_t>::contiguous(count.data(), nodes),
        .first = GridView<T>::contiguous(first.data(), nodes),
        .last = GridView<T>::contiguous(last.data(), nodes)};
    edgeCrossings(torus, {this->level(), nodes}, targets);
    int odd = 0;
    forEachIndex({{0, 0, 0}, {30, 30, 30}}, [&](const Index3& node) {
      const auto at = static_cast<std::size_t>(std::int64_t{node.i} + 32 * (node.j + 32 * node.k));
      const auto edge = this->edgeAt(domain, node, axis);
      EXPECT_EQ(edge.isCut(), count[at] % 2 == 1);
      if (!edge.isCut()) return;
      ++odd;
      EXPECT_EQ(levelSet.intercept(edge), edge.atNode < 0 ? first[at] : last[at]);
    });
    EXPECT_GT(odd, 300);
  }
}

// Three crossings on an edge: a plate in front of a block. What is beyond the first is lost.
TYPED_TEST(NodeLevelSetTest, OfSeveralCrossingsTakesTheFluidsFirst) {
  using T = TypeParam;
  const auto at = [](double x) { return static_cast<T>(x); };
  const auto slab = [&](double from, double to) {
    return Solid<T>(Cuboid<T>({at(from), -1, -1}, {at(to), 1, 1}));
  };
  // The edge from node 16 to 17 along x is [0, 0.1].
  const auto behind = this->around(slab(0.02, 0.03) | slab(0.06, 1));
  EXPECT_NEAR(
      NodeLevelSet<T>(behind, this->level()).intercept(this->edgeAt(behind, {16, 14, 17}, 0)), 0.02,
      1e-6);
  const auto before = this->around(slab(-1, 0.04) | slab(0.07, 0.08));
  EXPECT_NEAR(
      NodeLevelSet<T>(before, this->level()).intercept(this->edgeAt(before, {16, 14, 17}, 0)), 0.08,
      1e-6);
}

// The surface is less than a unit in the last place before a node, which is where it is found.
TYPED_TEST(NodeLevelSetTest, InterceptsStayBetweenTheNodes) {
  using T = TypeParam;
  const T node = this->level().position({20, 14, 17}).x;
  const auto before = std::nextafter(node, T(0));
  const auto function = [=](const Vec3<T>& p) { return (p.x - node) + (node - before) / 8; };
  const auto domain =
      FluidDomain<T>(FunctionSDF<T, decltype(function)>(
                         function, Guarantee<T>{.lipschitz = T(1), .continuous = true}),
                     FluidSide::Outside, {1, 0, 0});
  const auto edge = this->edgeAt(domain, {19, 14, 17}, 0);
  ASSERT_TRUE(edge.isCut() && edge.atNext != 0);
  EXPECT_EQ(NodeLevelSet<T>(domain, this->level()).intercept(edge), before);
}

TYPED_TEST(NodeLevelSetTest, ANodeWithZeroIsTheBodysAndHasTheIntercept) {
  using T = TypeParam;
  const auto domain = this->around(this->ball());
  const NodeLevelSet<T> levelSet(domain, this->level());
  const T here = this->level().position({16, 14, 17}).y;
  const T next = this->level().position({16, 15, 17}).y;
  EXPECT_EQ(levelSet.intercept({{16, 14, 17}, 1, 0, -1}), here);
  EXPECT_EQ(levelSet.intercept({{16, 14, 17}, 1, -1, 0}), next);
  EXPECT_TRUE(std::isnan(levelSet.intercept({{16, 14, 17}, 1, 0, 1})));
  EXPECT_TRUE(std::isnan(levelSet.intercept({{16, 14, 17}, 1, 0, 0})));
  // The host says it is cut, but there is no surface: all of it is fluid.
  EXPECT_EQ(levelSet.intercept({{16, 14, 17}, 1, 1, -1}), here);
  EXPECT_EQ(levelSet.intercept({{16, 14, 17}, 1, -1, 1}), next);
}

TYPED_TEST(NodeLevelSetTest, InterceptsMoveToNodesThatWereCovered) {
  using T = TypeParam;
  const auto domain = this->around(this->ball());
  const NodeLevelSet<T> levelSet(domain, this->level());
  constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
  const T here = this->level().position({16, 14, 17}).z;
  const T next = this->level().position({16, 14, 18}).z;
  const auto moved = [&](T atNode, T atNext, T before) {
    return levelSet.intercept({{16, 14, 17}, 2, atNode, atNext}, before);
  };
  const T between = (here + next) / 2;
  EXPECT_EQ(moved(-1, 1, between), between);
  EXPECT_EQ(moved(-1, 0, between), next);
  EXPECT_EQ(moved(0, -1, between), here);
  EXPECT_EQ(moved(-1, 1, kNaN), next);
  EXPECT_EQ(moved(1, -1, kNaN), here);
}

TYPED_TEST(NodeLevelSetTest, RefusesCellsAndNoNodes) {
  using T = TypeParam;
  const auto domain = this->around(this->ball());
  EXPECT_THROW((NodeLevelSet<T>(domain, Level<T>({0, 0, 0}, {1, 1, 1}))), Error);
  EXPECT_THROW((NodeLevelSet<T>(domain, this->level(), {{0, 0, 0}, {1, 1, -1}})), Error);
}

}  // namespace
}  // namespace cutwater::test
