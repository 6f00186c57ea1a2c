#pragma once

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "Bvh/Balls.hpp"

namespace cutwater::test {

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

  /// The balls in other places, in the same tree.
  void move(std::vector<Ball<T>> balls, Vec3<T> shift = {}, T scale = 1) {
    EXPECT_EQ(bvh_.refit(balls).size(), balls.size());
    balls_ = std::move(balls);
    shift_ = shift;
    scale_ = scale;
  }

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

  void expectSame(int queries) const {
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
    hits_ = misses_ = 0;
  }

 private:
  std::vector<Ball<T>> balls_;
  LinearBVH<T, Ball<T>, K> bvh_;
  Vec3<T> shift_;
  T scale_;
  mutable std::size_t hits_ = 0;
  mutable std::size_t misses_ = 0;
};

}  // namespace cutwater::test
