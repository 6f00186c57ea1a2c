#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <limits>
#include <vector>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/SameCrossings.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class SegmentBatchesTest : public ::testing::Test {
 protected:
  /// More than one batch, and some segments that are none.
  static std::vector<Segment<T>> segments() {
    RandomPoints<T> random(2, /*seed=*/5);
    std::vector<Segment<T>> result;
    for (int i = 0; i < 300; ++i) result.push_back({random.next(), random.next()});
    result[100].start.x = std::numeric_limits<T>::quiet_NaN();
    result[101].end.y = std::numeric_limits<T>::infinity();
    result[102].end = result[102].start;
    return result;
  }
  static Solid<T> placed() {
    Solid<T> solid = Torus<T>(1, T(0.3)) | Cuboid<T>({-1, 0, 0}, {0, 1, T(0.5)});
    solid.rotate(25, {1, 2, 3});
    solid.translate({T(0.1), T(-0.2), T(0.3)});
    return solid;
  }
};
TYPED_TEST_SUITE(SegmentBatchesTest, Precisions);

TYPED_TEST(SegmentBatchesTest, AreAnsweredAsOneByOne) {
  using T = TypeParam;
  EXPECT_GT(expectSameCrossings<T>(this->placed(), this->segments()), 50U);
  // A solid without a Lipschitz constant has stretches that are not resolved.
  const FunctionSDF bare([](const Vec3<T>& p) { return lengthSquared(p) - T(1); }, Guarantee<T>{});
  EXPECT_GT(expectSameCrossings<T>(bare, this->segments()), 50U);
}

TYPED_TEST(SegmentBatchesTest, DoNotDependOnThreads) {
  using T = TypeParam;
  for (const int threads : {1, 2, 5}) {
    expectSameCrossings<T>(this->placed(), this->segments(), {.threads = threads});
  }
  expectSameCrossings<T>(this->placed(), this->segments(), {.threads = 2, .grain = 200});
}

TYPED_TEST(SegmentBatchesTest, TellWhereABallIsEntered) {
  using T = TypeParam;
  const Sphere<T> ball({0, 0, 0}, 1);
  const std::vector<Segment<T>> segments{
      {{-2, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {0, 4, 0}}, {{-2, 2, 0}, {2, 2, 0}}};
  std::vector<FirstHit<T>> hits(3);
  // What was in the results before does not show.
  hits[2].found = true;
  ball.firstHits(std::span<const Segment<T>>(segments), std::span(hits));
  ASSERT_TRUE(hits[0].found);
  EXPECT_NEAR(hits[0].crossing.parameter, T(0.25), T(1e-6));
  EXPECT_TRUE(hits[0].crossing.entering);
  ASSERT_TRUE(hits[1].found);
  EXPECT_NEAR(hits[1].crossing.parameter, T(0.25), T(1e-6));
  EXPECT_FALSE(hits[1].crossing.entering);
  EXPECT_FALSE(hits[2].found);
  const auto lists = ball.crossings(std::span<const Segment<T>>(segments));
  EXPECT_EQ(lists.offsets, (std::vector<std::size_t>{0, 2, 3, 3}));
}

TYPED_TEST(SegmentBatchesTest, MayBeEmptyAndNeedOneHitPerSegment) {
  using T = TypeParam;
  const Sphere<T> ball({0, 0, 0}, 1);
  std::vector<FirstHit<T>> hits(2);
  ball.firstHits(std::span<const Segment<T>>{}, std::span(hits).first(0));
  EXPECT_EQ(ball.crossings(std::span<const Segment<T>>{}).offsets, (std::vector<std::size_t>{0}));
  const std::vector<Segment<T>> one(1);
  EXPECT_THROW(ball.firstHits(std::span<const Segment<T>>(one), std::span(hits)), Error);
}

}  // namespace
}  // namespace cutwater::test
