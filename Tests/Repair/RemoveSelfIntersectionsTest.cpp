#include <Cutwater/Repair/RemoveSelfIntersections.hpp>

#include "RepairChecks.hpp"

namespace cutwater::test {
namespace {

/// A ball on which two neighbouring points have changed places: faces around cross each other.
PolygonSoup crumpledBall() {
  auto ball = tessellation::icosphere(1, 4);
  std::swap(ball.points[ball.polygon(200)[0]], ball.points[ball.polygon(200)[1]]);
  return ball;
}

TEST(RemoveSelfIntersections, AFoldIsSmoothedOut) {
  const auto before = crumpledBall();
  ASSERT_GT(pairsIn(before), 0U);
  auto soup = before;
  const auto report = removeSelfIntersections(soup);
  EXPECT_EQ(report.pairsBefore, pairsIn(before));
  EXPECT_EQ(report.pairsAfter, 0U);
  expectSolid(soup);
  EXPECT_NEAR(measure(soup).volume, measure(tessellation::icosphere(1, 4)).volume, 0.02);
  EXPECT_LT(report.farthest, 0.2);
  EXPECT_EQ(report.facesAfter, soup.polygonCount());
}

TEST(RemoveSelfIntersections, PatchesStay) {
  auto soup = crumpledBall();
  soup.patchNames = {"below", "above"};
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    soup.patches[i] = middleOf(soup, i).z > 0 ? 1 : 0;
  }
  removeSelfIntersections(soup);
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const double z = middleOf(soup, i).z;
    if (std::abs(z) < 0.1) continue;
    EXPECT_EQ(soup.patches[i], z > 0 ? 1U : 0U) << i;
  }
}

TEST(RemoveSelfIntersections, NothingToDoChangesNothing) {
  auto soup = cube();
  const auto report = removeSelfIntersections(soup, {.mostPairs = SIZE_MAX});
  EXPECT_EQ(report.pairsBefore, 0U);
  EXPECT_TRUE(sameSoup(soup, cube()));
}

TEST(RemoveSelfIntersections, MostPairsAreTaken) {
  // Enough that the limit alone, and not the wish for examples, ends the search.
  auto soup = together(crumpledBall(), moved(crumpledBall(), {3, 0, 0}));
  const auto pairs = pairsIn(soup);
  ASSERT_GT(pairs, Findings<FacePair>::kExamples + 1);
  EXPECT_THROW(removeSelfIntersections(soup, {.mostPairs = pairs - 1}), Error);
  const auto report = removeSelfIntersections(soup, {.mostPairs = pairs});
  EXPECT_EQ(report.pairsBefore, pairs);
  EXPECT_EQ(report.pairsAfter, 0U);
}

TEST(RemoveSelfIntersections, Refusals) {
  auto soup = crumpledBall();
  EXPECT_THROW(removeSelfIntersections(soup, {.rounds = 0}), Error);
  EXPECT_THROW(removeSelfIntersections(soup, {.seconds = 0}), Error);
  EXPECT_THROW(removeSelfIntersections(soup, {.mostPairs = 1}), Error);
  auto fins = together(crumpledBall(), PolygonSoup{});
  fins.addPolygon(fins.polygon(0));  // three faces at an edge
  const auto before = fins;
  try {
    removeSelfIntersections(fins);
    ADD_FAILURE() << "was not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Topology);
  }
  EXPECT_TRUE(sameSoup(fins, before));
}

}  // namespace
}  // namespace cutwater::test
