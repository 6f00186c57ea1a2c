// What LinearBVH answers beside the nearest primitive, compared with trying all primitives.

#include <algorithm>
#include <array>
#include <set>

#include "Bvh/Balls.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// Index and value, in the order of values and then of indices.
template <typename T>
using Ranking = std::vector<std::pair<T, std::uint32_t>>;

template <typename T>
Ranking<T> rankedByTryingAll(const std::vector<Ball<T>>& balls, const Vec3<T>& q, T limit) {
  Ranking<T> ranking;
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const T value = balls[i].distance(q);
    if (value <= limit) ranking.emplace_back(value, i);
  }
  std::ranges::sort(ranking);
  return ranking;
}

/// The balls of one test, as they are and in a tree, and points to ask about.
template <typename T, int K>
class Comparison {
 public:
  explicit Comparison(std::vector<Ball<T>> balls, Vec3<T> shift = {}, T scale = 1)
      : balls_(std::move(balls)), bvh_(balls_), shift_(shift), scale_(scale) {}

  void expectNearest(const Vec3<T>& q, std::size_t room, T limit) const {
    using Nearest = typename LinearBVH<T, Ball<T>, K>::Nearest;
    auto expected = rankedByTryingAll(balls_, q, limit);
    expected.resize(std::min(expected.size(), room));
    const Nearest untouched{.primitive = 12345, .distance = -1};
    std::vector<Nearest> results(room + 1, untouched);
    const std::span<Nearest> given = std::span(results).first(room);
    Ranking<T> found;
    for (std::size_t i = 0; i < bvh_.nearest(q, given, limit); ++i) {
      found.emplace_back(results[i].distance, results[i].primitive);
    }
    EXPECT_EQ(found, expected) << "query " << q << ", room for " << room;
    EXPECT_EQ(results[room].primitive, untouched.primitive);
  }

  void expectWithin(const Vec3<T>& q, T radius) const {
    Ranking<T> found;
    bvh_.within(q, radius, [&](const auto& one) {
      found.emplace_back(one.distance, one.primitive);
      return true;
    });
    std::ranges::sort(found);
    EXPECT_EQ(found, rankedByTryingAll(balls_, q, radius)) << "query " << q;
  }

  void expectHits(const Segment<T>& segment) const {
    std::set<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
      if (balls_[i].crosses(segment)) expected.insert(i);
    }
    std::set<std::uint32_t> found;
    bvh_.allHits(segment, [&](std::uint32_t i) {
      EXPECT_TRUE(found.insert(i).second) << "told twice: " << i;
      return true;
    });
    EXPECT_EQ(found, expected) << segment.start << " to " << segment.end;
    EXPECT_EQ(bvh_.anyHit(segment), !expected.empty());
    hits_ += expected.size();
    misses_ += expected.empty() ? 1 : 0;
  }

  void run(int queries) const {
    RandomPoints<T> random(2, /*seed=*/7);
    for (int i = 0; i < queries; ++i) {
      const Vec3<T> q = shift_ + scale_ * random.next();
      for (const std::size_t room : {1U, 2U, 7U, 40U}) {
        expectNearest(q, room, std::numeric_limits<T>::max());
        expectNearest(q, room, scale_ * T(0.7));
      }
      for (const T radius : {T(-0.1), T(0), T(0.5), T(8)}) expectWithin(q, scale_ * radius);
      const Vec3<T> anywhere = shift_ + scale_ * random.next();
      const auto& ball = balls_[static_cast<std::size_t>(i) % balls_.size()];
      const Vec3<T> end = i % 8 == 0 ? q : i % 4 == 1 ? ball.center : anywhere;
      expectHits({q, i % 3 == 0 ? T(0.1) * end + T(0.9) * q : end});
    }
    EXPECT_GT(hits_, 0U);
    EXPECT_GT(misses_, 0U);
  }

 private:
  std::vector<Ball<T>> balls_;
  LinearBVH<T, Ball<T>, K> bvh_;
  Vec3<T> shift_;
  T scale_;
  mutable std::size_t hits_ = 0;
  mutable std::size_t misses_ = 0;
};

template <typename T>
class PrimitiveQueriesTest : public ::testing::Test {};
TYPED_TEST_SUITE(PrimitiveQueriesTest, Precisions);

TYPED_TEST(PrimitiveQueriesTest, FindWhatTryingAllFinds) {
  using T = TypeParam;
  for (const int count : {5, 17, 400}) {
    SCOPED_TRACE(count);
    for (const T radius : {T(0.01), T(0.3)}) {  // apart; deeply overlapping: negative values
      Comparison<T, 4>(cloud<T>(count, radius)).run(count == 5 ? 900 : 60);
      Comparison<T, 8>(cloud<T>(count, radius)).run(count == 5 ? 900 : 60);
      Comparison<T, 16>(cloud<T>(count, radius)).run(count == 5 ? 900 : 60);
    }
  }
}

TYPED_TEST(PrimitiveQueriesTest, AreRightFarFromTheOriginAndAtExtremeSizes) {
  using T = TypeParam;
  const T far = sizeof(T) == sizeof(float) ? T(1e3) : T(1e8);
  const Vec3<T> there{far, -far, far};
  Comparison<T, 16>(cloud<T>(300, T(0.1), there), there).run(60);
  for (const T scale : {T(1e-15), T(1e15)}) {
    Comparison<T, 16>(cloud<T>(300, T(0.1), {}, scale), {}, scale).run(60);
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
