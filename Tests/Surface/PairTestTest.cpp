#include <Cutwater/Surface/Detail/PairTest.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include "Support/Fans.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// Compares every pair with intersect(); returns how many meet.
std::size_t expectAsPairByPair(const TriangleList& soup) {
  const auto& [points, corners] = soup;
  const PairTest pairs(points, corners);
  std::size_t meeting = 0;
  for (std::uint32_t a = 0; a < corners.size(); ++a) {
    const auto& [p, q, r] = corners[a];
    EXPECT_EQ(pairs.hasArea(a), hasArea({points[p], points[q], points[r]}));
    if (!pairs.hasArea(a)) continue;
    for (std::uint32_t b = a + 1; b < corners.size(); ++b) {
      if (!pairs.hasArea(b)) continue;
      const bool meet = intersect(points, corners[a], corners[b]);
      EXPECT_EQ(pairs.meet(a, b), meet) << a << ' ' << b;
      EXPECT_EQ(pairs.meet(b, a), meet);
      meeting += meet ? 1U : 0U;
    }
  }
  return meeting;
}

TEST(PairTestTest, FansThatLieFlatFoldOrRunAroundTwice) {
  std::mt19937 engine(3);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(400); ++round) {
    const auto n = static_cast<std::uint32_t>(3 + engine() % 12);
    auto soup = fan(n, round % 3 * 0.8, engine);
    const auto pick = [&] { return 1 + engine() % n; };
    if (round % 4 == 1) std::swap(soup.points[pick()], soup.points[pick()]);
    if (round % 4 == 2) soup.points[pick()] = soup.points[pick()];
    if (round % 4 == 3) {
      for (std::uint32_t i = 0; i < n; ++i) {  // around twice
        const double angle = 4 * std::numbers::pi * i / n;
        soup.points[1 + i] = {std::cos(angle), std::sin(angle), 0.01 * i};
      }
    }
    for (auto& t : soup.corners) {  // any corner first, any way around at a third of the fans
      if (round % 3 == 0 && engine() % 2 == 0) std::swap(t[1], t[2]);
      std::rotate(t.begin(), t.begin() + engine() % 3, t.end());
    }
    meeting += expectAsPairByPair(soup);
  }
  EXPECT_GT(meeting, 500U);
}

TEST(PairTestTest, EveryCoincidenceOfAGrid) {
  std::mt19937 engine(4);
  for (int round = 0; round < scaled(200); ++round) {
    TriangleList soup;
    const auto below = [&](unsigned n) { return static_cast<std::uint32_t>(engine() % n); };
    for (int i = 0; i < 12; ++i)
      soup.points.push_back({1.0 * below(3), 1.0 * below(3), 1.0 * below(2)});
    for (int i = 0; i < 30; ++i) {
      soup.corners.push_back({below(12), below(12), below(12)});
    }
    expectAsPairByPair(soup);
  }
}

TEST(PairTestTest, TwoRingsAtOneVertexMayMeet) {
  // Each lies around the vertex once, as seen from above; together they do so twice.
  std::mt19937 engine(5);
  auto soup = fan(6, 0, engine);
  const auto other = fan(6, 0, engine);
  for (std::uint32_t i = 0; i < 6; ++i)
    soup.points.push_back(other.points[1 + i] + Vec3<double>{0.1, 0, i % 2 * 0.5 - 0.25});
  for (std::uint32_t i = 0; i < 6; ++i) soup.corners.push_back({0, 7 + i, 7 + (i + 1) % 6});
  EXPECT_GT(expectAsPairByPair(soup), 0U);
}

}  // namespace
}  // namespace cutwater::test
