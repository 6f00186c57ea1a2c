// The order of triangles along an axis; pairs that meet are in Surface/SelfIntersectionsTest.cpp,
// case by case.

#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using Corners = std::array<Vec3<double>, 3>;

/// How high a triangle is at a place; nothing beside it, or close to its rim.
std::optional<double> heightAt(const Corners& t, const Vec3<double>& p, int axis) {
  const auto normal = cross(t[1] - t[0], t[2] - t[0]);
  std::optional<double> none;
  if (normal[axis] == 0) return none;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto side = cross(t[(i + 1) % 3] - t[i], p - t[i]);
    if (side[axis] / normal[axis] < 1e-6) return none;
  }
  auto way = p - t[0];
  way[axis] = 0;
  return t[0][axis] - dot(normal, way) / normal[axis];
}

/// As points of one show that lie above or below the other: nothing if there are none.
std::optional<int> orderSeen(const Corners& a, const Corners& b, int axis) {
  constexpr int kSteps = 24;
  for (int i = 1; i < kSteps; ++i) {
    for (int j = 1; i + j < kSteps; ++j) {
      const auto p =
          a[0] + (1.0 / kSteps) * (double(i) * (a[1] - a[0]) + double(j) * (a[2] - a[0]));
      const auto height = heightAt(b, p, axis);
      if (height && std::abs(*height - p[axis]) > 1e-9) return *height > p[axis] ? 1 : -1;
    }
  }
  return std::nullopt;
}

bool meet(const Corners& a, const Corners& b) {
  const std::vector<Vec3<double>> points{a[0], a[1], a[2], b[0], b[1], b[2]};
  return intersect(points, {0, 1, 2}, {3, 4, 5});
}

TEST(TriangleIntersectionTest, OrderIsThatOfPointsAboveOneAnother) {
  std::mt19937 random(6);
  const auto number = [&] { return 0.125 * static_cast<double>(random() % 9); };
  const auto triangle = [&] {
    const auto corner = [&] { return Vec3<double>{number(), number(), number()}; };
    Corners result;
    do {
      result = {corner(), corner(), corner()};
    } while (!hasArea(result));
    return result;
  };
  int above = 0;
  int below = 0;
  for (int round = 0; round < 20'000; ++round) {
    const auto a = triangle();
    const auto b = triangle();
    if (meet(a, b)) continue;
    const int axis = round % 3;
    const int order = orderAlong(a, b, axis);
    ASSERT_EQ(orderAlong(b, a, axis), -order);
    const auto seen = orderSeen(a, b, axis);
    if (!seen) continue;
    ASSERT_EQ(order, *seen);
    ++(order > 0 ? above : below);
  }
  EXPECT_GT(above, 500);
  EXPECT_GT(below, 500);
}

TEST(TriangleIntersectionTest, OrderIsFoundWithinRounding) {
  const Corners flat{Vec3<double>{0, 0, 0.7}, {0.9, 0.1, 0.7}, {0.2, 0.8, 0.7}};
  const double up = std::nextafter(0.7, 1);
  EXPECT_EQ(orderAlong(flat, {Vec3<double>{0.1, -1, up}, {0.4, 2, up}, {0.3, -2, up}}, 2), 1);
  // One corner is below the plane, but beside the triangle.
  const double down = std::nextafter(0.7, 0);
  EXPECT_EQ(orderAlong(flat, {Vec3<double>{0.1, -1, up}, {0.4, 2, up}, {0.3, -2, down}}, 2), 1);
  EXPECT_EQ(orderAlong(flat, {Vec3<double>{0.1, -1, down}, {0.4, 2, down}, {0.3, -2, up}}, 2), -1);
  EXPECT_EQ(orderAlong(flat, {Vec3<double>{2, 0, up}, {3, 0, up}, {2, 1, down}}, 2), 0);
}

/// At an edge or a corner that they share, they touch; what else there is decides.
TEST(TriangleIntersectionTest, OrderIsThatBesideWhatTheyShare) {
  const Vec3<double> a{0, 0, 0};
  const Vec3<double> b{1, 0, 0};
  const Vec3<double> c{0, 1, 0};
  EXPECT_EQ(orderAlong({a, b, c}, {b, a, {0, 1, 0x1p-60}}, 2), 1);
  EXPECT_EQ(orderAlong({a, b, c}, {b, a, {0, 1, -0x1p-60}}, 2), -1);
  EXPECT_EQ(orderAlong({a, b, c}, {a, {1, 1, 0x1p-60}, {0.9, 1, 0x1p-60}}, 2), 1);
  EXPECT_EQ(orderAlong({a, b, c}, {b, a, {0, -1, 1}}, 2), 0);
}

}  // namespace
}  // namespace cutwater::test
