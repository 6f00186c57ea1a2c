#include <Cutwater/Triangles/QueryBox.hpp>

#include <random>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using Corners = QueryBox::Corners;

/// A turned box and its axes.
OrientedBox<double> turnedBox(const Vec3<double>& center, const Vec3<double>& half,
                              const Vec3<double>& along, double slack) {
  OrientedBox<double> box;
  const auto x = normalized(along);
  const auto y =
      normalized(cross(x, std::abs(x.x) < 0.5 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0}));
  box.center = center;
  box.halfAxis = {half.x * x, half.y * y, half.z * cross(x, y)};
  box.slack = slack;
  return box;
}

/// The distance between triangle and box, and how little of it may be missing: by projections to
/// the one and the other, far more often than QueryBox does, among many starts.
double distanceBetween(const OrientedBox<double>& box, const Corners& triangle) {
  const auto nearestInBox = [&](const Vec3<double>& p) {
    Vec3<double> result = box.center;
    for (const auto& half : box.halfAxis) {
      const double squared = lengthSquared(half);
      if (squared == 0) continue;
      result += std::clamp(dot(p - box.center, half) / squared, -1.0, 1.0) * half;
    }
    return result;
  };
  double least = 1e300;
  constexpr int kSteps = 64;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j + i <= kSteps; ++j) {
      const double u = double(i) / kSteps;
      const double v = double(j) / kSteps;
      const auto p =
          triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
      least = std::min(least, length(p - nearestInBox(p)));
    }
  }
  return least;
}
double spacing(const Corners& t) {
  return std::max({length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])}) / 64;
}

class QueryBoxTest : public ::testing::Test {
 protected:
  Corners nextTriangle(int i) {
    const auto a = points_.next();
    const double size = i % 3 == 0 ? 2 : i % 3 == 1 ? 0.3 : 0.01;
    Corners t{a, a + size * points_.next(), a + size * points_.next()};
    if (i % 7 == 0) t[2] = t[1] + 1e-9 * points_.next();  // a needle
    if (i % 11 == 0) t[2] = t[0] + 0.3 * (t[1] - t[0]);   // a segment
    if (i % 13 == 0) t = {t[0], t[0], t[0]};              // a point
    return t;
  }
  OrientedBox<double> nextBox(int i) {
    Vec3<double> half = 0.5 * abs(points_.next());
    if (i % 5 == 0) half.x = 0;
    if (i % 10 == 0) half.y = 0;
    if (i % 30 == 0) half = {};
    return turnedBox(points_.next(), half, points_.next(), i % 2 == 0 ? 0 : 0.01);
  }

  RandomPoints<double> points_{1, 5};
};

TEST_F(QueryBoxTest, SaysOnlyWhatIsTrueAndNearlyAllOfIt) {
  int open = 0;
  int apart = 0;
  int met = 0;
  const int count = scaled(3000);
  for (int i = 0; i < count; ++i) {
    const auto box = nextBox(i);
    const auto triangle = nextTriangle(i);
    const QueryBox query(box);
    const auto local = query.toBox(triangle);
    const double distance = distanceBetween(box, triangle);
    const double slack = spacing(triangle);
    if (query.isApart(local)) {
      ++apart;
      ASSERT_GT(distance, box.slack) << i;
    } else {
      ASSERT_LT(distance - slack, box.slack * 1.8 + 1e-12) << i;  // around corners sqrt(3)
    }
    if (query.meets(local)) {
      ++met;
      ASSERT_LE(distance, slack + 1e-12) << i;
      ASSERT_FALSE(query.isApart(local)) << i;
    }
    if (!query.isApart(local) && !query.meets(local) && box.slack == 0 && i % 5 != 0) ++open;
  }
  EXPECT_GT(apart, count / 10);
  EXPECT_GT(met, count / 40);
  EXPECT_EQ(open, 0);
}

TEST_F(QueryBoxTest, GapIsABoundAndNearlyTheDistance) {
  double worst = 0;
  const int count = scaled(2000);
  for (int i = 0; i < count; ++i) {
    auto box = nextBox(i);
    box.slack = 0;
    const auto triangle = nextTriangle(i);
    const QueryBox query(box);
    const double distance = distanceBetween(box, triangle);
    const double gap = query.gap(query.toBox(triangle), 1e300);
    ASSERT_LE(gap, distance) << i;
    worst = std::max(worst, (distance - spacing(triangle) - gap) / (distance + 0.05));
    if (query.isApart(query.toBox(triangle)) && distance > spacing(triangle) + 1e-9) {
      ASSERT_GT(gap, 0) << i;
    }
    // What is enough is not improved on, but still a bound.
    const double some = query.gap(query.toBox(triangle), 0.5 * gap);
    ASSERT_LE(some, distance) << i;
    ASSERT_GE(some, std::min(gap, 0.5 * gap) * (1 - 1e-12)) << i;
  }
  EXPECT_LT(worst, 0.002);
}

}  // namespace
}  // namespace cutwater::test
