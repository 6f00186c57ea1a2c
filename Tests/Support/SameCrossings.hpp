#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {

/// All crossings of a segment, and how many stretches are unresolved.
template <typename T>
struct CrossingsOfOne {
  std::vector<Crossing<T>> found;
  std::size_t unresolved = 0;
};

template <typename T>
CrossingsOfOne<T> oneByOne(const SignedDistanceFunction<T>& solid, const Segment<T>& segment) {
  CrossingsOfOne<T> result;
  const auto count = solid.crossings(segment, [&](const Crossing<T>& crossing) {
    result.found.push_back(crossing);
    return true;
  });
  EXPECT_EQ(count.found, result.found.size());
  result.unresolved = count.unresolved;
  return result;
}

/// To the bit.
template <typename T>
bool areSame(const Crossing<T>& a, const Crossing<T>& b) {
  return a.parameter == b.parameter && a.point == b.point && a.normal == b.normal &&
         a.entering == b.entering && a.owner == b.owner;
}

/// Whether batches give what crossings() gives one by one. Returns how many segments have a
/// crossing.
template <typename T>
std::size_t expectSameCrossings(const SignedDistanceFunction<T>& solid,
                                const std::vector<Segment<T>>& segments,
                                const ParallelOptions& options = {}) {
  const std::span<const Segment<T>> all(segments);
  const auto lists = solid.crossings(all, options);
  std::vector<FirstHit<T>> hits(segments.size());
  solid.firstHits(all, std::span(hits), options);
  EXPECT_EQ(lists.offsets.size(), segments.size() + 1);
  EXPECT_EQ(lists.offsets.back(), lists.crossings.size());
  std::size_t some = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto expected = oneByOne(solid, segments[i]);
    const auto list = lists.of(i);
    const bool areEqual = std::ranges::equal(list, expected.found, areSame<T>);
    EXPECT_TRUE(areEqual) << i;
    EXPECT_EQ(lists.unresolved[i], expected.unresolved) << i;
    EXPECT_EQ(hits[i].found, !expected.found.empty()) << i;
    if (!hits[i].found) {
      EXPECT_EQ(hits[i].unresolved, expected.unresolved) << i;
      continue;
    }
    ++some;
    EXPECT_TRUE(areSame(hits[i].crossing, expected.found.front())) << i;
    const auto stopped = solid.crossings(segments[i], [](const Crossing<T>&) { return false; });
    EXPECT_EQ(hits[i].unresolved, stopped.unresolved) << i;
  }
  return some;
}

}  // namespace cutwater::test
