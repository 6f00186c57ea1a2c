#include <Cutwater/Surface/Detail/PairSearch.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>

#include <algorithm>
#include <atomic>

#include <gtest/gtest.h>

#include "Support/Fans.hpp"
#include "Support/IntersectingPairs.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

void expectAsBruteForce(TriangleList soup, std::mt19937& engine) {
  soup.shuffle(engine);
  expectSame(findSelfIntersections<double>(soup.points, soup.corners),
             bruteForce(soup.points, soup.corners));
}

TEST(PairSearchTest, CrowdsAsByBruteForce) {
  // Around every leaf of these are very many others.
  std::mt19937 engine(11);
  for (int round = 0; round < scaled(4); ++round) {
    auto one = fan(1100, 0.3 * round, engine);
    addIntruders(one, round, engine);
    expectAsBruteForce(std::move(one), engine);
    auto two = doubleFan(700, 0.2 * round, engine);
    addIntruders(two, 3 * round, engine);
    // The apex's place under another number, and a triangle there.
    const auto again = static_cast<std::uint32_t>(two.points.size());
    if (round % 2 == 1) {
      two.points.push_back(two.points[0]);
      two.corners.push_back({again, 5, 6});
    }
    expectAsBruteForce(std::move(two), engine);
    auto tower = twistedTower(600, 1.5 * round);  // at pi all edges pass through the axis
    addIntruders(tower, round, engine);
    expectAsBruteForce(std::move(tower), engine);
  }
  expectAsBruteForce(spiralFan(1200), engine);
  expectAsBruteForce(book(900, engine), engine);
}

TEST(PairSearchTest, BesideACrowdAsByBruteForce) {
  // Small triangles all over the fan and around its middle, whose leaves are not crowded.
  std::mt19937 engine(12);
  auto soup = fan(1000, 0.1, engine);
  for (int i = 0; i < 700; ++i) {
    const double reach = i % 2 == 0 ? 1 : 0.05;
    const Vec3<double> middle =
        soup.points[0] + reach * Vec3<double>{unitRandom(engine) - 0.5, unitRandom(engine) - 0.5,
                                              -0.3 * unitRandom(engine)};
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (int corner = 0; corner < 3; ++corner) {
      soup.points.push_back(
          middle + 0.01 * Vec3<double>{unitRandom(engine), unitRandom(engine), unitRandom(engine)});
    }
    soup.corners.push_back({first, first + 1, first + 2});
  }
  expectAsBruteForce(std::move(soup), engine);
}

TEST(PairSearchTest, LargeFansAreSearchedAsAWhole) {
  std::mt19937 engine(13);
  auto soup = doubleFan(20'000, 0.3, engine);
  soup.shuffle(engine);
  std::vector<double> reported;
  const auto clean = findSelfIntersections<double>(
      soup.points, soup.corners,
      {.threads = 1, .progress = [&](double done) { reported.push_back(done); }});
  EXPECT_EQ(clean.pairs.count, 0U);
  EXPECT_GT(reported.size(), 10U);
  EXPECT_TRUE(std::ranges::is_sorted(reported));
  EXPECT_EQ(reported.back(), 1);
  // A needle through one of the triangles.
  const auto hit = soup.corners[777];
  const auto middle = (soup.points[hit[0]] + soup.points[hit[1]] + soup.points[hit[2]]) / 3.0;
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (const auto& offset : {Vec3<double>{0, 0, -1e-6}, {0, 0, 1e-6}, {1e-9, 0, 1e-6}}) {
    soup.points.push_back(middle + offset);
  }
  soup.corners.push_back({first, first + 1, first + 2});
  const auto pierced = findSelfIntersections<double>(soup.points, soup.corners);
  EXPECT_EQ(pierced.pairs.examples, (std::vector<FacePair>{{FaceId{777}, FaceId{40'000}}}));
}

/// Looks for pairs of which one in `every` triangles has changed, in a crowd and beside it.
void expectChangedAsBruteForce(TriangleList soup, std::uint32_t every, std::mt19937& engine) {
  soup.shuffle(engine);
  std::vector<std::uint8_t> changed;
  for (std::size_t t = 0; t < soup.corners.size(); ++t) changed.push_back(engine() % every == 0);
  const auto arrays = buildTriangleTree<double>(soup.points, soup.corners);
  const auto tree = arrays.tree();
  const PairTest pairs(soup.points, soup.corners, 1, changed);
  const PairSearch search(pairs, tree, 1);
  std::vector<FacePair> found;
  const std::atomic<std::uint32_t> lastWanted{kNone};
  const auto take = [&](std::uint32_t a, std::uint32_t b) {
    found.push_back({FaceId{a}, FaceId{b}});
    return true;
  };
  for (std::size_t task = 0; task < search.tasks(); ++task) search.run(task, {lastWanted, take});
  std::ranges::sort(found, {}, [](const FacePair& p) {
    return std::pair(static_cast<std::uint32_t>(p.first), static_cast<std::uint32_t>(p.second));
  });
  const auto expected = bruteForce(soup.points, soup.corners, changed).pairs;
  ASSERT_EQ(found.size(), expected.count);
  found.resize(expected.examples.size());
  EXPECT_EQ(found, expected.examples);
}

TEST(PairSearchTest, OnlyPairsOfTrianglesThatHaveChanged) {
  std::mt19937 engine(15);
  for (const std::uint32_t every : {2U, 20U, 400U}) {
    auto crowded = doubleFan(500, 0.2, engine);
    addIntruders(crowded, 12, engine);
    expectChangedAsBruteForce(std::move(crowded), every, engine);
    TriangleList scattered;
    for (std::uint32_t i = 0; i < 900; ++i) {
      const Vec3<double> at{unitRandom(engine), unitRandom(engine), unitRandom(engine)};
      for (int corner = 0; corner < 3; ++corner) {
        scattered.points.push_back(
            at + 0.1 * Vec3<double>{unitRandom(engine), unitRandom(engine), unitRandom(engine)});
      }
      scattered.corners.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    expectChangedAsBruteForce(std::move(scattered), every, engine);
  }
}

TEST(PairSearchTest, TheFirstOfVeryManyPairs) {
  // Ten thousand triangles in one place, after a clean fan and a few pairs at its end.
  std::mt19937 engine(14);
  auto soup = fan(4000, 0.3, engine);
  const auto place = static_cast<std::uint32_t>(soup.points.size());
  for (const auto& p : {Vec3<double>{5, 5, 5}, {6, 5, 5}, {5, 6, 5}}) soup.points.push_back(p);
  soup.corners.push_back(soup.corners[3999]);  // pair 3999, 4000
  soup.corners.push_back(soup.corners[17]);    // pair 17, 4001
  for (int i = 0; i < 10'000; ++i) soup.corners.push_back({place, place + 1, place + 2});
  for (const int threads : {1, 2}) {
    const auto found =
        findSelfIntersections<double>(soup.points, soup.corners, {.threads = threads});
    EXPECT_FALSE(found.complete);
    EXPECT_EQ(found.pairs.count, 1'000'000U);
    ASSERT_EQ(found.pairs.examples.size(), 8U);
    EXPECT_EQ(found.pairs.examples[0], (FacePair{FaceId{17}, FaceId{4001}}));
    EXPECT_EQ(found.pairs.examples[1], (FacePair{FaceId{3999}, FaceId{4000}}));
    for (std::uint32_t i = 2; i < 8; ++i) {
      EXPECT_EQ(found.pairs.examples[i], (FacePair{FaceId{4002}, FaceId{4001 + i}}));
    }
  }
}

}  // namespace
}  // namespace cutwater::test
