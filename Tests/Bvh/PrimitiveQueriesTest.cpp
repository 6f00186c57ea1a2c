// What LinearBVH answers beside the nearest primitive, compared with trying all primitives.

#include <array>
#include <tuple>

#include "Bvh/Comparison.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class PrimitiveQueriesTest : public ::testing::Test {};
TYPED_TEST_SUITE(PrimitiveQueriesTest, Precisions);

TYPED_TEST(PrimitiveQueriesTest, FindWhatTryingAllFinds) {
  using T = TypeParam;
  for (const int count : {5, 17, 400}) {
    SCOPED_TRACE(count);
    for (const T radius : {T(0.01), T(0.3)}) {  // apart; deeply overlapping: negative values
      Comparison<T, 4>(cloud<T>(count, radius)).expectSame(count == 5 ? 900 : 60);
      Comparison<T, 8>(cloud<T>(count, radius)).expectSame(count == 5 ? 900 : 60);
      Comparison<T, 16>(cloud<T>(count, radius)).expectSame(count == 5 ? 900 : 60);
    }
  }
}

TYPED_TEST(PrimitiveQueriesTest, AreRightFarFromTheOriginAndAtExtremeSizes) {
  using T = TypeParam;
  const T far = sizeof(T) == sizeof(float) ? T(1e3) : T(1e8);
  const Vec3<T> there{far, -far, far};
  Comparison<T, 16>(cloud<T>(300, T(0.1), there), there).expectSame(60);
  for (const T scale : {T(1e-15), T(1e15)}) {
    Comparison<T, 16>(cloud<T>(300, T(0.1), {}, scale), {}, scale).expectSame(60);
  }
}

TYPED_TEST(PrimitiveQueriesTest, TiesGoToTheLowestIndices) {
  using T = TypeParam;
  // Points of a lattice, each many times, queried where several are equally near.
  std::vector<Ball<T>> balls;
  for (int copy = 0; copy < 40; ++copy) {
    for (int i = 0; i < 8; ++i) balls.push_back({{T(i & 1), T(i >> 1 & 1), T(i >> 2)}, T(0.125)});
  }
  const Comparison<T, 16> comparison(balls);
  for (const std::size_t room : {1U, 3U, 11U, 40U, 41U, 100U, 320U, 500U}) {
    comparison.expectNearest({T(0.5), T(0.5), T(0.5)}, room, 8);
    comparison.expectNearest({1, T(0.5), T(0.5)}, room, 8);
    comparison.expectNearest({1, 1, T(1.5)}, room, 8);
    comparison.expectNearest({1, 1, T(1.5)}, room, T(0.375));  // not above the limit
  }
  comparison.expectWithin({1, 1, T(1.5)}, T(0.375));
  comparison.expectHits({{0, 0, -1}, {0, 0, T(-0.125)}});  // touches
}

TYPED_TEST(PrimitiveQueriesTest, FindWhatOnlyRoundingBringsToABox) {
  using T = TypeParam;
  const T far = sizeof(T) == sizeof(float) ? T(1e3) : T(1e9);
  int hits = 0;
  for (const auto& ball : cloud<T>(300, T(0.1), {far, far, far})) {
    const LinearBVH<T, Ball<T>> one({ball});
    // Beside the box by one unit in the last place; points along it are off by as much.
    const T x = std::nextafter(ball.boundingBox().upper.x, 2 * far);
    for (const T length : {T(0.3), T(0.7), T(1.1), T(1.9)}) {
      const Segment<T> beside{{x, ball.center.y - length, ball.center.z},
                              {x, ball.center.y + length / 3, ball.center.z}};
      EXPECT_EQ(one.anyHit(beside), ball.crosses(beside)) << ball.center;
      hits += ball.crosses(beside) ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 5);
}

TYPED_TEST(PrimitiveQueriesTest, VisitorsCanStop) {
  using T = TypeParam;
  const LinearBVH<T, Ball<T>> bvh(cloud<T>(1000, T(0.3)));
  for (const int most : {1, 2, 15}) {
    int near = 0;
    bvh.within({0, 0, 0}, T(9), [&](const auto&) { return ++near < most; });
    EXPECT_EQ(near, most);
    int deep = 0;  // no positive value is asked for, and the centre is deep within some
    bvh.within({0, 0, 0}, T(0), [&](const auto&) { return ++deep < most; });
    EXPECT_EQ(deep, most);
    int hit = 0;
    bvh.allHits({{-1, -1, -1}, {1, 1, 1}}, [&](std::uint32_t) { return ++hit < most; });
    EXPECT_EQ(hit, most);
    int passed = 0;
    bvh.along({{-1, -1, -1}, {1, 1, 1}}, [&](std::uint32_t) { return ++passed < most; });
    EXPECT_EQ(passed, most);
  }
}

TYPED_TEST(PrimitiveQueriesTest, VisitSegmentsAboutFromTheirStart) {
  using T = TypeParam;
  std::vector<Ball<T>> beads;
  for (int i = 0; i < 1000; ++i) beads.push_back({{T(i), 0, 0}, T(0.25)});
  const LinearBVH<T, Ball<T>> bvh(beads);
  std::vector<std::uint32_t> order;
  bvh.allHits({{2000, 0, 0}, {-10, 0, 0}}, [&](std::uint32_t i) {
    order.push_back(i);
    return true;
  });
  ASSERT_EQ(order.size(), 1000U);
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_LE(std::abs(static_cast<int>(i + order[i]) - 999), 4) << "leaves hold four";
  }
}

TYPED_TEST(PrimitiveQueriesTest, LookAtFewPrimitives) {
  using T = TypeParam;
  struct Counted : Ball<T> {
    int* calls;
    T distance(const Vec3<T>& p) const { return ++*calls, Ball<T>::distance(p); }
    bool crosses(const Segment<T>& s) const { return ++*calls, Ball<T>::crosses(s); }
  };
  int calls = 0;
  std::vector<Counted> balls;
  for (const auto& ball : cloud<T>(20000, T(0.001))) balls.push_back({ball, &calls});
  const LinearBVH<T, Counted> bvh(balls);
  const auto callsOf = [&](const auto& query) {
    calls = 0;
    query();
    return calls;
  };
  std::array<typename LinearBVH<T, Counted>::Nearest, 10> ten;
  const auto all = [](const auto&) { return true; };
  EXPECT_LT(callsOf([&] { std::ignore = bvh.nearest({0, 0, 0}, ten); }), 400);
  EXPECT_LT(callsOf([&] { bvh.within({0, 0, 0}, T(0.05), all); }), 200);
  EXPECT_LT(callsOf([&] { bvh.allHits({{-1, -1, -1}, {1, 1, 1}}, all); }), 1000);
  EXPECT_EQ(callsOf([&] { std::ignore = bvh.anyHit({{3, 3, 3}, {4, 4, 4}}); }), 0);
}

TYPED_TEST(PrimitiveQueriesTest, FindNothingInNothingAndNowhere) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  const T inf = std::numeric_limits<T>::infinity();
  const LinearBVH<T, Ball<T>> none(std::vector<Ball<T>>{});
  const LinearBVH<T, Ball<T>> one({{{0, 0, 0}, 1}});
  const auto fails = [](const auto&) {
    ADD_FAILURE() << "visited";
    return true;
  };
  std::array<typename LinearBVH<T, Ball<T>>::Nearest, 3> room;
  EXPECT_EQ(none.nearest({0, 0, 0}, room), 0U);
  EXPECT_EQ(one.nearest({0, 0, nan}, room), 0U);
  EXPECT_EQ(one.nearest({0, 0, 0}, std::span(room).first(0)), 0U);
  EXPECT_EQ(one.nearest({3, 0, 0}, room, T(1.5)), 0U);
  EXPECT_EQ(one.nearest({3, 0, 0}, room, T(2)), 1U);
  none.within({0, 0, 0}, 1, fails);
  one.within({0, 0, inf}, 1, fails);
  one.within({0, 0, 0}, nan, fails);
  one.within({0, 0, 0}, T(-1.5), fails);
  one.within({0, 0, 0}, -inf, fails);
  one.allHits({{0, 0, 0}, {nan, 0, 0}}, fails);
  one.allHits({{2, 2, 2}, {3, 2, 2}}, fails);
  EXPECT_FALSE(none.anyHit({{0, 0, 0}, {1, 1, 1}}));
  EXPECT_TRUE(one.anyHit({{0, 0, 0}, {0, 0, 0}}));
  int found = 0;
  one.within({9, 9, 9}, inf, [&](const auto&) { return ++found > 0; });
  EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace cutwater::test
