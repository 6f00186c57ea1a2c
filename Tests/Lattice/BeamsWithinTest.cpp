#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

BeamGraph octetBlock(std::uint32_t n) {
  return beamsOf(UnitCell::octet(), {{2.0 / n, 2.0 / n, 2.0 / n}, {n, n, n}}, 0.2 / n);
}

template <typename T>
class BeamsWithinTest : public ::testing::Test {};
TYPED_TEST_SUITE(BeamsWithinTest, Precisions);

TYPED_TEST(BeamsWithinTest, WhatIsLeftHasTheSamePointsInCommon) {
  using T = TypeParam;
  const auto block = octetBlock(8);
  const auto expectSame = [&](const auto& part, const auto& partInDouble) {
    const auto kept = beamsWithin(block, partInDouble);
    EXPECT_LT(kept.beams.size(), block.beams.size() / 2);
    EXPECT_LT(kept.nodes.size(), block.nodes.size() / 2);
    const BeamLattice<T> all(block);
    const BeamLattice<T> clipped(kept);
    const auto whole = all & part;
    const auto less = clipped & part;
    RandomPoints<T> random(1, 4);
    int inside = 0;
    for (int i = 0; i < scaled(4000); ++i) {
      const auto p = random.next() + Vec3<T>{1, 1, 1};
      EXPECT_EQ(less.signedDistance(p) < 0, whole.signedDistance(p) < 0) << p;
      inside += less.signedDistance(p) < 0 ? 1 : 0;
      EXPECT_GE(clipped.signedDistance(p), all.signedDistance(p));
    }
    EXPECT_GT(inside, 30);
  };
  expectSame(Sphere<T>({1, 1, 1}, T(0.6)), Sphere<double>({1, 1, 1}, 0.6));
  expectSame(translated(MeshSDF<T>(cube()), {T(0.4), T(0.5), T(0.6)}),
             translated(MeshSDF<double>(cube()), {0.4, 0.5, 0.6}));
}

TYPED_TEST(BeamsWithinTest, ClippedGraphsKeepTheirGuarantee) {
  using T = TypeParam;
  const auto block = octetBlock(4);
  const Solid<T> ball = Sphere<T>({1, 1, 1}, T(0.7));
  const BeamLattice<T> all(block);
  auto part = BeamLattice<T>(beamsWithin(block, Sphere<double>({1, 1, 1}, 0.7))) & ball;
  part.translate({-1, -1, -1});
  const auto isInside = [&](const Vec3<double>& p) {
    return length(p) < 0.7 && all.signedDistance(Vec3<T>(p + Vec3<double>{1, 1, 1})) < 0;
  };
  expectGuarantee(part, 0.9, {.inside = isInside, .probes = 1500, .lines = 24});
}

TEST(BeamsWithinTest, OnlyWhatIsOutsideIsLeftOut) {
  const auto block = octetBlock(6);
  const Solid<double> ball = Sphere<double>({1, 1, 1}, 0.5);
  const auto kept = beamsWithin(block, ball);
  // In the order of before.
  std::size_t next = 0;
  for (const auto& beam : block.beams) {
    const auto& a = block.nodes[beam.nodes[0]];
    const auto& b = block.nodes[beam.nodes[1]];
    const bool isNext = next < kept.beams.size() && kept.nodes[kept.beams[next].nodes[0]] == a &&
                        kept.nodes[kept.beams[next].nodes[1]] == b;
    next += isNext ? 1 : 0;
    double nearest = 1e300;
    for (int i = 0; i <= 100; ++i) {
      nearest = std::min(nearest, length(a + i / 100.0 * (b - a) - Vec3<double>{1, 1, 1}));
    }
    if (nearest < 0.5 + beam.radii[0]) {
      EXPECT_TRUE(isNext) << a << b;
    }
    if (nearest > 0.5 + beam.radii[0] + length(b - a)) {
      EXPECT_FALSE(isNext) << a << b;
    }
  }
  EXPECT_EQ(next, kept.beams.size());
}

TEST(BeamsWithinTest, BallsFollowTheirNodes) {
  const BeamGraph graph{{{9, 0, 0}, {0, 0, 0}, {5, 0, 0}, {0, 3, 0}},
                        {{{0, 2}, {1, 1}}, {{1, 3}, {0.5, 0.25}, BeamBody::Frustum}},
                        {{0, 1.0}, {3, 2.0}, {2, 4.5}}};
  const auto kept = beamsWithin(graph, Sphere<double>({0, 0, 0}, 1));
  ASSERT_EQ(kept.beams.size(), 1U);
  EXPECT_EQ(kept.beams[0].body, BeamBody::Frustum);
  EXPECT_EQ(kept.beams[0].radii, (std::array{0.5, 0.25}));
  EXPECT_EQ(kept.nodes, (std::vector<Vec3<double>>{{0, 0, 0}, {0, 3, 0}, {5, 0, 0}}));
  ASSERT_EQ(kept.balls.size(), 2U);
  EXPECT_EQ(kept.balls[0].node, 1U);
  EXPECT_EQ(kept.balls[1].node, 2U);
  EXPECT_EQ(kept.balls[1].radius, 4.5);
}

TEST(BeamsWithinTest, RefusesNodesThatThereAreNot) {
  const Solid<double> ball = Sphere<double>({0, 0, 0}, 1);
  EXPECT_THROW((void)beamsWithin({{{0, 0, 0}}, {{{0, 1}, {1, 1}}}, {}}, ball), Error);
  EXPECT_THROW((void)beamsWithin({{{0, 0, 0}}, {}, {{1, 1.0}}}, ball), Error);
  EXPECT_TRUE(beamsWithin({}, ball).beams.empty());
}

}  // namespace
}  // namespace cutwater::test
