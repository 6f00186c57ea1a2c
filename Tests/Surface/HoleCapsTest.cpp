#include <Cutwater/Surface/Detail/HoleCaps.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <random>

#include <gtest/gtest.h>

#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles trianglesOf(const PolygonSoup& soup) {
  Triangles triangles;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto c = soup.polygon(i);
    triangles.push_back({c[0], c[1], c[2]});
  }
  return triangles;
}

HoleCaps capsOf(const std::vector<Vec3<double>>& points, const Triangles& triangles) {
  return capHoles<double>(points, findOpenEdges(triangles, points.size()));
}

/// Surface and caps together, with equal positions made one.
std::size_t openEdgesTogether(std::vector<Vec3<double>> points, Triangles triangles) {
  const auto caps = capsOf(points, triangles);
  PolygonSoup all;
  all.points = points;
  all.patchNames = {"all"};
  const auto shift = static_cast<std::uint32_t>(points.size());
  all.points.insert(all.points.end(), caps.positions.begin(), caps.positions.end());
  for (const auto& t : triangles) all.addPolygon(t);
  for (const auto& [a, b, c] : caps.triangles) {
    all.addPolygon(std::array{a + shift, b + shift, c + shift});
  }
  weldExactly(all);
  return findOpenEdges(trianglesOf(all), all.points.size()).size();
}

TEST(HoleCaps, AClosedSurfaceNeedsNone) {
  const auto sphere = tessellation::icosphere(1, 2);
  EXPECT_TRUE(capsOf(sphere.points, trianglesOf(sphere)).triangles.empty());
}

TEST(HoleCaps, AMissingTriangleIsPutBack) {
  const auto sphere = tessellation::icosphere(1, 1);
  auto triangles = trianglesOf(sphere);
  const auto lost = triangles.back();
  triangles.pop_back();
  const auto caps = capsOf(sphere.points, triangles);
  ASSERT_EQ(caps.triangles.size(), 1U);
  // The same corners, in the same cyclic order.
  std::vector<Vec3<double>> corners;
  for (const auto v : caps.triangles[0]) corners.push_back(caps.positions[v]);
  const auto first = std::ranges::find(corners, sphere.points[lost[0]]);
  ASSERT_NE(first, corners.end());
  std::rotate(corners.begin(), first, corners.end());
  EXPECT_EQ(corners[1], sphere.points[lost[1]]);
  EXPECT_EQ(corners[2], sphere.points[lost[2]]);
}

TEST(HoleCaps, ATriangleByItselfGetsItsBack) {
  const auto caps = capsOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  ASSERT_EQ(caps.triangles.size(), 1U);
  const auto [a, b, c] = caps.triangles[0];
  EXPECT_EQ(cross(caps.positions[b] - caps.positions[a], caps.positions[c] - caps.positions[a]),
            (Vec3<double>{0, 0, -1}));
}

TEST(HoleCaps, ALongRimTakesFewLargeTriangles) {
  const auto tube = tessellation::cylinder(1, 1, 1024);
  Triangles open;
  for (std::size_t i = 0; i < tube.polygonCount(); ++i) {
    const auto c = tube.polygon(i);
    for (std::size_t k = 2; c.size() < 5 && k < c.size(); ++k)
      open.push_back({c[0], c[k - 1], c[k]});
  }
  const auto caps = capsOf(tube.points, open);
  EXPECT_EQ(caps.triangles.size(), 2 * 1022U);
  int large = 0;
  for (const auto& [a, b, c] : caps.triangles) {
    const double extent = std::max(length(caps.positions[b] - caps.positions[a]),
                                   length(caps.positions[c] - caps.positions[a]));
    if (extent > 0.5) ++large;
  }
  EXPECT_LE(large, 2 * 15);
}

TEST(HoleCaps, AnythingIsClosed) {
  std::mt19937 engine(3);
  for (int round = 0; round < 200; ++round) {
    // Few vertices, so that edges are shared by many, at random and in no order.
    const auto vertices = static_cast<std::uint32_t>(4 + engine() % 12);
    std::vector<Vec3<double>> points;
    for (std::uint32_t i = 0; i < vertices; ++i) {
      points.push_back({double(i), double(i * i % 7), double(engine() % 100)});
    }
    Triangles triangles;
    for (std::uint32_t i = 0; i < 1 + engine() % 40; ++i) {
      const auto a = static_cast<std::uint32_t>(engine() % vertices);
      const auto b = (a + 1 + engine() % (vertices - 1)) % vertices;
      auto c = static_cast<std::uint32_t>(engine() % vertices);
      while (c == a || c == b) c = (c + 1) % vertices;
      triangles.push_back({a, static_cast<std::uint32_t>(b), c});
    }
    ASSERT_EQ(openEdgesTogether(points, triangles), 0U) << round;
  }
}

}  // namespace
}  // namespace cutwater::test
