#include <Cutwater/Surface/Cleaning/Detail/PlanarRegions.hpp>

#include <cmath>
#include <numbers>
#include <random>

#include "CleanChecks.hpp"

namespace cutwater::test {
namespace {

using detail::Loop;

/// Loops in a plane that is seen along `axis`; points are added as loops are.
struct Drawing {
  int axis = 2;
  std::vector<Vec3<double>> points = {};
  std::vector<Loop> loops = {};

  void add(const std::vector<std::pair<double, double>>& outline, bool clockwise = false) {
    Loop loop;
    for (const auto& [u, v] : outline) {
      Vec3<double> p;
      p[(axis + 1) % 3] = u;
      p[(axis + 2) % 3] = v;
      p[axis] = 0.25 * u - 0.125 * v;
      loop.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p);
    }
    if (clockwise) std::ranges::reverse(loop);
    loops.push_back(loop);
  }

  void addCircle(double u, double v, double radius, int n, bool clockwise = false) {
    std::vector<std::pair<double, double>> outline;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      outline.emplace_back(u + radius * std::cos(angle), v + radius * std::sin(angle));
    }
    add(outline, clockwise);
  }

  [[nodiscard]] double turnOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return cross(points[b] - points[a], points[c] - points[a])[axis] / 2;
  }
  /// Seen against the axis.
  [[nodiscard]] double areaOf(const Loop& loop) const {
    double sum = 0;
    for (std::size_t i = 2; i < loop.size(); ++i) sum += turnOf(loop[0], loop[i - 1], loop[i]);
    return sum;
  }
};

struct Circle {
  double u, v, radius;
};

Circle circumcircle(const Drawing& drawing, const std::array<std::uint32_t, 3>& triangle) {
  const int axis = drawing.axis;
  const auto flat = [&](std::uint32_t i) {
    return std::pair(drawing.points[i][(axis + 1) % 3], drawing.points[i][(axis + 2) % 3]);
  };
  const auto [u0, v0] = flat(triangle[0]);
  const auto [u1, v1] = flat(triangle[1]);
  const auto [u2, v2] = flat(triangle[2]);
  const double a = u1 - u0, b = v1 - v0, c = u2 - u0, d = v2 - v0;
  const double s = (a * a + b * b) / (2 * (a * d - b * c));
  const double t = (c * c + d * d) / (2 * (a * d - b * c));
  const double u = d * s - b * t, v = a * t - c * s;
  return {u0 + u, v0 + v, std::hypot(u, v)};
}

/// Triangles have area, and of two with a common edge, no corner lies within the other's circle by
/// more than two hundredths of the larger radius.
void expectDelaunay(const Drawing& drawing,
                    const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Circle> circles;
  for (const auto& t : triangles) {
    EXPECT_GT(std::abs(drawing.turnOf(t[0], t[1], t[2])), 1e-12);
    for (std::size_t i = 0; i < 3; ++i) circles[{t[i], t[(i + 1) % 3]}] = circumcircle(drawing, t);
  }
  for (const auto& t : triangles) {
    const auto own = circumcircle(drawing, t);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto neighbour = circles.find({t[(i + 1) % 3], t[i]});
      if (neighbour == circles.end()) continue;
      const auto& [u, v, radius] = neighbour->second;
      const auto& corner = drawing.points[t[(i + 2) % 3]];
      const double away =
          std::hypot(corner[(drawing.axis + 1) % 3] - u, corner[(drawing.axis + 2) % 3] - v);
      EXPECT_GT(away, radius - 0.02 * std::max(radius, own.radius))
          << t[i] << " " << t[(i + 1) % 3];
    }
  }
}

std::size_t leftIn(const detail::PlanarFilling& filling) {
  return static_cast<std::size_t>(std::ranges::count(filling.left, true));
}

/// All loops are filled: triangles of no overlap, whose boundary they are.
void expectFilled(const Drawing& drawing, double area) {
  const auto filling = detail::fillLoops(drawing.points, drawing.loops, drawing.axis);
  EXPECT_EQ(leftIn(filling), 0U);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double sum = 0;
  double size = 0;
  for (const auto& [a, b, c] : filling.triangles) {
    sum += drawing.turnOf(a, b, c);
    size += std::abs(drawing.turnOf(a, b, c));
    for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, a}}) {
      ++edges[{from, to}];
      --edges[{to, from}];
    }
  }
  for (const auto& loop : drawing.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto from = loop[i];
      const auto to = loop[(i + 1) % loop.size()];
      --edges[{from, to}];
      ++edges[{to, from}];
    }
  }
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, 0) << edge.first << " " << edge.second;
  EXPECT_NEAR(sum, area, 1e-12 * std::abs(area));
  EXPECT_NEAR(size, std::abs(area), 1e-12 * size);
  expectDelaunay(drawing, filling.triangles);
}

TEST(PlanarRegions, ASquareWithASquareHole) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool turned : {false, true}) {
      Drawing drawing{axis};
      drawing.add({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, turned);
      drawing.add({{1, 1}, {2, 1}, {2, 2}, {1, 2}}, !turned);
      expectFilled(drawing, turned ? -8 : 8);
    }
  }
}

TEST(PlanarRegions, IslandsInHolesAndManyHoles) {
  Drawing drawing;
  double area = 0;
  drawing.addCircle(0, 0, 10, 200);
  for (int i = 0; i < 7; ++i) {
    for (int k = 0; k < 7; ++k) {
      if (std::hypot(i - 3, k - 3) > 4) continue;
      drawing.addCircle(2 * i - 6, 2 * k - 6, 0.9, 9 + i + k, /*clockwise=*/true);
      drawing.addCircle(2 * i - 6, 2 * k - 6, 0.5, 5 + i);
    }
  }
  for (const auto& loop : drawing.loops) area += drawing.areaOf(loop);
  expectFilled(drawing, area);
}

TEST(PlanarRegions, CombsWithinCombs) {
  // Long teeth, so that most corners are hidden from most others.
  std::vector<std::pair<double, double>> comb;
  std::vector<std::pair<double, double>> hole;
  for (int i = 0; i < 10; ++i) {
    comb.insert(comb.end(), {{i, 0}, {i + 0.5, 10}, {i + 0.5, 0.5}});
    hole.insert(hole.end(), {{i + 0.25, 0.6}, {i + 0.5, 11}});
  }
  comb.insert(comb.end(), {{11, 0.5}, {11, 20}, {-1, 20}, {-1, 0}});
  hole.insert(hole.end(), {{10.5, 0.6}, {10.5, 12}, {-0.5, 12}, {-0.5, 0.6}});
  Drawing drawing;
  drawing.add(comb);
  std::ranges::reverse(drawing.loops[0]);
  drawing.addCircle(5, 15, 2, 30, drawing.areaOf(drawing.loops[0]) > 0);
  drawing.addCircle(5, 18.5, 1, 30, drawing.areaOf(drawing.loops[0]) > 0);
  double area = 0;
  for (const auto& loop : drawing.loops) area += drawing.areaOf(loop);
  expectFilled(drawing, area);
}

TEST(PlanarRegions, RandomStarsWithHoles) {
  std::mt19937 engine(13);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 100; ++round) {
    Drawing drawing{round % 3};
    const auto star = [&](double u, double v, double least, double most, int n, bool clockwise) {
      std::vector<std::pair<double, double>> outline;
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5 * share(engine)) / n;
        const double radius = least + (most - least) * share(engine);
        outline.emplace_back(u + radius * std::cos(angle), v + radius * std::sin(angle));
      }
      drawing.add(outline, clockwise);
    };
    star(0, 0, 10, 20, 3 + round, false);
    const int holes = round % 12;
    for (int i = 0; i < holes; ++i) {
      const double angle = 2 * std::numbers::pi * i / 12;
      star(6 * std::cos(angle), 6 * std::sin(angle), 0.2, 1.4, 3 + i, true);
    }
    if (round < 5) drawing.loops.erase(drawing.loops.begin() + 1, drawing.loops.end());
    double area = 0;
    for (const auto& loop : drawing.loops) area += drawing.areaOf(loop);
    // Few corners: the outline may cut through the holes.
    if (round >= 20 || drawing.loops.size() == 1) expectFilled(drawing, area);
  }
}

TEST(PlanarRegions, TheCrossSectionOfAPipe) {
  // Lines between points of the outer circle 60 degrees to either side touch the inner one.
  for (const int n : {24, 36, 48, 360}) {
    for (const bool turned : {false, true}) {
      Drawing drawing;
      drawing.addCircle(0, 0, 2, n, turned);
      drawing.addCircle(0, 0, 1, n, !turned);
      expectFilled(drawing, drawing.areaOf(drawing.loops[0]) + drawing.areaOf(drawing.loops[1]));
      // A line from every point to its image, and one diagonal of each trapezoid between those.
      for (const auto& [a, b, c] :
           detail::fillLoops(drawing.points, drawing.loops, drawing.axis).triangles) {
        const double half = std::numbers::pi / n;
        EXPECT_GE(std::abs(drawing.turnOf(a, b, c)), 0.99 * std::sin(half) * std::cos(half)) << n;
      }
    }
  }
}

TEST(PlanarRegions, LoopsOfTheSameWayAreNoHoles) {
  Drawing drawing;
  drawing.addCircle(0, 0, 2, 12);
  drawing.addCircle(0, 0, 1, 12);
  expectFilled(drawing, drawing.areaOf(drawing.loops[0]) + drawing.areaOf(drawing.loops[1]));
}

TEST(PlanarRegions, CornersMayBeShared) {
  Drawing drawing;
  drawing.add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  drawing.points.push_back({1, 2, 0});
  drawing.points.push_back({1, 1, 0});
  drawing.loops.push_back({0, 4, 5});  // a hole that hangs on the first corner
  drawing.points.push_back({-1, -1, 0});
  drawing.points.push_back({0, -1, 0});
  drawing.loops.push_back({0, 6, 7});  // another square's corner
  ASSERT_LT(drawing.areaOf(drawing.loops[1]), 0);
  expectFilled(drawing, 16 - 0.5 + 0.5);
}

TEST(PlanarRegions, TouchingInMoreThanASharedCornerIsMeeting) {
  for (const bool turned : {false, true}) {
    Drawing along;  // from a shared corner along the other's side
    along.add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    along.points.push_back({1, 0, 0});
    along.points.push_back({1, 1, 0});
    along.loops.push_back({0, 5, 4});
    if (turned) std::swap(along.loops[0], along.loops[1]);
    EXPECT_EQ(leftIn(detail::fillLoops(along.points, along.loops, 2)), 2U);
    Drawing corner;  // a corner on a side, and a side through a corner
    corner.add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    corner.add({{4, 2}, {6, 1}, {6, 3}});
    if (turned) std::swap(corner.loops[0], corner.loops[1]);
    EXPECT_EQ(leftIn(detail::fillLoops(corner.points, corner.loops, 2)), 2U);
  }
}

TEST(PlanarRegions, WhatMeetsIsLeftWithAllWithin) {
  Drawing drawing;
  drawing.add({{0, 0}, {4, 4}, {4, 0}, {0, 4}});        // a bow tie ...
  drawing.add({{0.5, 1.5}, {1, 2}, {0.5, 2.5}}, true);  // ... with something in it
  drawing.add({{10, 0}, {12, 0}, {12, 2}, {10, 2}});    // two that cross
  drawing.add({{11, 1}, {13, 1}, {13, 3}, {11, 3}});
  drawing.add({{20, 0}, {21, 0}, {21, 1}});           // one by itself
  drawing.add({{30, 0}, {32, 0}, {32, 2}, {30, 2}});  // one whose hole touches its side
  drawing.add({{30, 1}, {31, 1}, {31, 1.5}}, true);
  const auto filling = detail::fillLoops(drawing.points, drawing.loops, drawing.axis);
  EXPECT_EQ(filling.left, (std::vector<bool>{true, true, true, true, false, true, true}));
  EXPECT_EQ(filling.triangles.size(), 1U);
}

}  // namespace
}  // namespace cutwater::test
