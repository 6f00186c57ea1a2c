#include <Cutwater/Surface/Detail/CrowdSplits.hpp>

#include <algorithm>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "Support/Fans.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

Crowd allOf(const PairTest& pairs) {
  Crowd crowd;
  for (std::uint32_t t = 0; t < pairs.triangles(); ++t) {
    if (pairs.hasArea(t)) crowd.members.push_back(t);
  }
  return crowd;
}

template <typename Visit>
void visitPairs(const Crowd& crowd, Visit&& visit) {
  for (std::size_t i = 0; i < crowd.members.size(); ++i) {
    const auto t = crowd.members[i];
    for (std::size_t j = i + 1; crowd.within && j < crowd.members.size(); ++j) {
      visit(t, crowd.members[j]);
    }
    for (const auto guest : crowd.guests) visit(std::min(t, guest), std::max(t, guest));
  }
}

/// Splits until nothing is left to split. Every pair must be in one part, unless it does not meet.
/// Returns the number of splits.
int expectKeepsPairs(const TriangleList& soup) {
  const PairTest pairs(soup.points, soup.corners);
  std::vector<Crowd> pending{allOf(pairs)};
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> kept;
  visitPairs(pending.front(), [&](auto a, auto b) {
    if (pairs.meet(a, b)) kept[{a, b}] = 0;
  });
  int splits = 0;
  while (!pending.empty()) {
    const Crowd crowd = std::move(pending.back());
    pending.pop_back();
    EXPECT_TRUE(std::ranges::is_sorted(crowd.members));
    EXPECT_TRUE(std::ranges::is_sorted(crowd.guests));
    const auto parts = crowd.size() < 4 ? std::nullopt : split(pairs, crowd);
    if (parts) {
      ++splits;
      pending.insert(pending.end(), parts->begin(), parts->end());
      continue;
    }
    visitPairs(crowd, [&](auto a, auto b) {
      if (const auto found = kept.find({a, b}); found != kept.end()) ++found->second;
    });
  }
  for (const auto& [pair, count] : kept) EXPECT_EQ(count, 1) << pair.first << ' ' << pair.second;
  return splits;
}

TEST(CrowdSplitsTest, EveryPairThatMeetsStaysInOnePart) {
  std::mt19937 engine(7);
  int splits = 0;
  for (int round = 0; round < scaled(12); ++round) {
    auto soup = round % 2 == 0 ? fan(150, 0.6, engine) : doubleFan(80, 0.4, engine);
    if (round % 3 == 0) {  // another vertex in the apex's place, and a rim vertex in the second's
      soup.points.push_back(soup.points[0]);
      const auto again = static_cast<std::uint32_t>(soup.points.size() - 1);
      for (std::uint32_t i = 1; i < 9; ++i) soup.corners.push_back({again, i, i + 1});
    }
    addIntruders(soup, round, engine);
    soup.shuffle(engine);
    splits += expectKeepsPairs(soup);
  }
  EXPECT_GT(splits, 100);
}

TEST(CrowdSplitsTest, OnGridsToo) {
  std::mt19937 engine(8);
  int splits = 0;
  for (int round = 0; round < scaled(60); ++round) {
    const unsigned levels = 3 + engine() % 4;
    TriangleList soup;
    const auto count = static_cast<std::uint32_t>(6 + engine() % 60);
    const auto below = [&](unsigned n) { return static_cast<std::uint32_t>(engine() % n); };
    for (std::uint32_t i = 0; i < count; ++i) {
      soup.points.push_back({1.0 * below(levels), 1.0 * below(levels), 1.0 * below(3)});
    }
    // Most at one of two points, with two others that are close to one another.
    const std::array hubs{soup.points[0], soup.points[1]};
    std::ranges::sort(soup.points, {}, [](const auto& p) { return std::tuple(p.x, p.y, p.z); });
    soup.points.insert(soup.points.end(), hubs.begin(), hubs.end());
    for (int i = 0; i < 90; ++i) {
      const auto next = below(count - 1);
      soup.corners.push_back({below(9) == 0 ? below(count) : count + below(2), next, next + 1});
    }
    splits += expectKeepsPairs(soup);
  }
  EXPECT_GT(splits, 100);
}

/// Triangles in all crowds that come of splitting, and pairs in those that are not split
/// further: what the time is proportional to.
double workOn(const TriangleList& soup) {
  const PairTest pairs(soup.points, soup.corners);
  std::vector<Crowd> pending{allOf(pairs)};
  double work = 0;
  while (!pending.empty()) {
    const Crowd crowd = std::move(pending.back());
    pending.pop_back();
    if (crowd.isDecided()) continue;
    work += static_cast<double>(crowd.size());
    const auto parts = crowd.size() <= 16 ? std::nullopt : split(pairs, crowd);
    if (parts) {
      pending.insert(pending.end(), parts->begin(), parts->end());
    } else {
      work += static_cast<double>(crowd.members.size()) * static_cast<double>(crowd.size());
    }
  }
  return work;
}

TEST(CrowdSplitsTest, WorkIsNearlyLinear) {
  const auto expectNearlyLinear = [](const char* name, auto make) {
    constexpr std::uint32_t kFew = 2000;
    std::mt19937 engine(9);
    auto few = make(kFew, engine);
    auto many = make(8 * kFew, engine);
    few.shuffle(engine);
    many.shuffle(engine);
    const double ratio = workOn(many) / workOn(few);
    EXPECT_LT(ratio, 16) << name;  // the square is 64
    EXPECT_LT(workOn(many), 100 * static_cast<double>(many.corners.size())) << name;
  };
  expectNearlyLinear("fan", [](auto n, auto& engine) { return fan(n, 0, engine); });
  expectNearlyLinear("rough fan", [](auto n, auto& engine) { return fan(n, 0.6, engine); });
  expectNearlyLinear("spiral", [](auto n, auto&) { return spiralFan(n); });
  expectNearlyLinear("two fans", [](auto n, auto& engine) { return doubleFan(n, 0.3, engine); });
  expectNearlyLinear("tower", [](auto n, auto&) { return twistedTower(n, 1); });
  expectNearlyLinear("book", [](auto n, auto& engine) { return book(n, engine); });
}

}  // namespace
}  // namespace cutwater::test
