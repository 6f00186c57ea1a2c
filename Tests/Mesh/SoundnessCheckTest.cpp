#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "Support/DamagedSoups.hpp"
#include "Support/Precisions.hpp"

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
  // Without a tree, a probe takes longer, and there are fewer.
  const auto withoutTree = DcelSDF<T>(DcelMesh<T>(soup)).signReport();
  EXPECT_EQ(withoutTree.scheme, SignScheme::WindingNumber);
  EXPECT_EQ(withoutTree.selfIntersections, solid.signReport().selfIntersections);
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

TYPED_TEST(SoundnessCheckTest, LooksForNothingOnOpenSurfaces) {
  const MeshSDF<TypeParam> open(
      onlyFaces(tessellation::icosphere(1, 2), [](auto i) { return i > 0; }));
  EXPECT_FALSE(open.signReport().selfIntersections);
  EXPECT_FALSE(open.signReport().isProven);
  EXPECT_EQ(open.signReport().probes, 1024U);
}

}  // namespace
}  // namespace cutwater::test
