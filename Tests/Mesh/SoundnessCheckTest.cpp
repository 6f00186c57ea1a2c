#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "Support/DamagedSoups.hpp"
#include "Support/Precisions.hpp"
#include "Support/SameMeshes.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class SoundnessCheckTest : public ::testing::Test {};
TYPED_TEST_SUITE(SoundnessCheckTest, Precisions);

/// A ball of 20 480 triangles, one vertex of which is pulled through it and out on the other side:
/// a spike of few triangles, that probes do not notice.
PolygonSoup piercedBall() {
  auto ball = tessellation::icosphere(1, 5);
  const auto height = [](const auto& p) { return p.z; };
  *std::ranges::max_element(ball.points, {}, height) = {0, 0, -1.5};
  return ball;
}

TYPED_TEST(SoundnessCheckTest, NoOverlapIsTooSmallToBeNoticed) {
  using T = TypeParam;
  const auto soup = piercedBall();
  // Beside the spike, where it is out of the ball again: its faces are seen from behind, but the
  // surface does not wind around the point.
  const Vec3<T> beside(Vec3<double>{0.02, 0, -1.3});
  const MeshSDF<T> probed(soup, {.findSelfIntersections = false, .probes = 64});
  ASSERT_TRUE(probed.signReport().isSound());
  EXPECT_FALSE(probed.signReport().isProven);
  EXPECT_LT(probed.signedDistance(beside), 0);  // the limit of probes

  const MeshSDF<T> solid(soup);
  EXPECT_GT(solid.signReport().selfIntersections, 0U);
  EXPECT_LT(solid.signReport().selfIntersections, 100U);
  EXPECT_FALSE(solid.signReport().isSound());
  EXPECT_FALSE(solid.signReport().isProven);
  EXPECT_EQ(solid.signReport().scheme, SignScheme::WindingNumber);
  EXPECT_GT(solid.signedDistance(beside), 0);
  EXPECT_LT(solid.signedDistance({T(0.5), 0, 0}), 0);
  // Without a tree, fewer places are examined in the same time.
  const auto without = DcelSDF<T>(DcelMesh<T>(soup)).signReport();
  EXPECT_EQ(without.selfIntersections, solid.signReport().selfIntersections);
  EXPECT_EQ(without.scheme, SignScheme::WindingNumber);
}

TYPED_TEST(SoundnessCheckTest, ProvesWhatBoundsASolid) {
  using T = TypeParam;
  const auto ball = tessellation::icosphere(1, 3);
  const auto shells =
      together(together(ball, insideOut(tessellation::icosphere(0.5, 2))), moved(ball, {3, 0, 0}));
  const MeshSDF<T> solid(shells);
  EXPECT_TRUE(solid.signReport().isProven);
  EXPECT_EQ(solid.signReport().doubt(), 0);
  EXPECT_EQ(solid.signReport().probes, 3U);  // one place on each
  EXPECT_EQ(solid.signReport().selfIntersections, 0U);
  EXPECT_EQ(solid.guarantee().inside, Quality::Exact);
}

TYPED_TEST(SoundnessCheckTest, ShellsWithinOthersDoNotMeetAndAreNotSound) {
  using T = TypeParam;
  const auto nested = together(tessellation::icosphere(1, 3), tessellation::icosphere(0.5, 2));
  const MeshSDF<T> solid(nested);
  EXPECT_EQ(solid.signReport().selfIntersections, 0U);
  EXPECT_FALSE(solid.signReport().isProven);
  EXPECT_GT(solid.signReport().unsound, 0U);
  EXPECT_LT(solid.signedDistance({T(0.49), 0, 0}), 0);
  EXPECT_LT(solid.signedDistance({T(0.51), 0, 0}), 0);
}

TYPED_TEST(SoundnessCheckTest, ExaminesPartsOnEitherSideOfACommonEdge) {
  // A wedge within a wedge, along the same edge: connected there, but the inner one is unsound.
  using T = TypeParam;
  const auto wedge = [](double from, double to) {
    return makeSoup({{0, 0, 0},
                     {0, 0, 1},
                     {std::cos(from), std::sin(from), 0},
                     {std::cos(from), std::sin(from), 1},
                     {std::cos(to), std::sin(to), 0},
                     {std::cos(to), std::sin(to), 1}},
                    {{0, 4, 2}, {1, 3, 5}, {0, 2, 3, 1}, {0, 1, 5, 4}, {2, 4, 5, 3}});
  };
  auto inner = wedge(0.5, 1);
  for (auto& p : inner.points) {
    if (p.x > 0) p = {0.5 * p.x, 0.5 * p.y, 0.5 * p.z + 0.25};
  }
  auto soup = merged(merged(together(wedge(0, 1.5), inner), 6, 0), 7, 1);
  const MeshSDF<T> solid(soup);
  ASSERT_TRUE(solid.signReport().isClosed());
  EXPECT_EQ(solid.signReport().selfIntersections, 0U);
  EXPECT_FALSE(solid.signReport().isSound());
  // Outside of the outer one, they are sound.
  const auto beside = wedge(3, 4);
  soup = merged(merged(together(wedge(0, 1.5), beside), 6, 0), 7, 1);
  EXPECT_TRUE(MeshSDF<T>(soup).signReport().isProven);
}

/// A pyramid up to a height and one down to a depth, on a square.
PolygonSoup bipyramid(double height, double depth) {
  return makeSoup(
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, height}, {0, 0, -depth}},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

TYPED_TEST(SoundnessCheckTest, ExaminesBothSidesOfEdgesThatOthersTouch) {
  // The surfaces pass through one another exactly where both have edges, with vertices of their
  // own. The largest faces of both are sound, the others within the other solid.
  using T = TypeParam;
  const MeshSDF<T> crossing(together(bipyramid(1, 3), bipyramid(3, 1)));
  EXPECT_EQ(crossing.signReport().selfIntersections, 0U);
  EXPECT_GT(crossing.signReport().unsound, 0U);
  EXPECT_FALSE(crossing.signReport().isProven);
  EXPECT_EQ(crossing.guarantee().inside, Quality::LowerBound);
  const MeshSDF<T> beside(together(bipyramid(1, 3), moved(bipyramid(1, 3), {1, 1, 0})));
  EXPECT_TRUE(beside.signReport().isProven);  // touching along an edge
  EXPECT_EQ(beside.guarantee().inside, Quality::Exact);
}

TYPED_TEST(SoundnessCheckTest, CountsEdgesThatTouchInPart) {
  const auto touching = [](const Vec3<double>& by) {
    const MeshSDF<TypeParam> both(together(bipyramid(1, 3), moved(bipyramid(1, 3), by)));
    EXPECT_TRUE(both.signReport().isProven);
    return both.signReport().touchingEdges;
  };
  EXPECT_EQ(touching({3, 0, 0}), 0U);
  EXPECT_EQ(touching({1, 1, 0}), 0U);        // all along an edge, which both share
  EXPECT_EQ(touching({1.25, 0.75, 0}), 4U);  // an edge of two triangles on each side
  EXPECT_EQ(touching({2, 0, 0}), 0U);        // in a vertex
}

TYPED_TEST(SoundnessCheckTest, ProvesSurfacesWithChainsOfFacesWithoutArea) {
  // One face of a bipyramid is divided at points on its upper edge, the one above it is not: faces
  // without area lie between.
  using T = TypeParam;
  for (const std::uint32_t count : {1U, 2U, 15U}) {
    auto soup = bipyramid(0.25, 0.25);
    soup = onlyFaces(soup, [](std::size_t i) { return i != 4; });
    std::uint32_t before = 1;
    for (std::uint32_t i = 1; i <= count; ++i) {
      const double share = i / (count + 1.0);
      soup.points.push_back({share, 1 - share, 0});
      const auto here = static_cast<std::uint32_t>(soup.points.size() - 1);
      soup.addPolygon(std::array{before, here, 5U});
      if (i > 1) soup.addPolygon(std::array{1U, here, before});
      before = here;
    }
    soup.addPolygon(std::array{before, 0U, 5U});
    soup.addPolygon(std::array{1U, 0U, before});
    const MeshSDF<T> solid(soup);
    ASSERT_TRUE(solid.signReport().isClosed());
    EXPECT_EQ(solid.signReport().selfIntersections, 0U);
    EXPECT_EQ(solid.signReport().touchingEdges, 0U);
    EXPECT_TRUE(solid.signReport().isProven);
    EXPECT_EQ(solid.signReport().scheme, SignScheme::NearestFeature);
    EXPECT_EQ(solid.guarantee().inside, Quality::Exact);
    const MeshSDF<T> plain(bipyramid(0.25, 0.25));
    RandomPoints<T> random(1, count);
    for (int i = 0; i < scaled(500); ++i) {
      // Around the whole, and close to the edge.
      const Vec3<T> p =
          i % 2 == 0 ? T(2) * random.next() : Vec3<T>{T(0.5), T(0.5), 0} + T(0.25) * random.next();
      EXPECT_NEAR(solid.signedDistance(p), plain.signedDistance(p), 1e-6) << p;
    }
  }
}

TYPED_TEST(SoundnessCheckTest, LooksForNothingOnOpenSurfaces) {
  const MeshSDF<TypeParam> open(
      onlyFaces(tessellation::icosphere(1, 2), [](auto i) { return i > 0; }));
  EXPECT_FALSE(open.signReport().selfIntersections);
  EXPECT_FALSE(open.signReport().isProven);
  EXPECT_EQ(open.signReport().probes, 1024U);
}

}  // namespace
}  // namespace cutwater::test
