#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "Support/Random.hpp"

namespace cutwater::test {

using Polygons = std::vector<std::vector<std::uint32_t>>;

inline PolygonSoup makeSoup(std::vector<Vec3<double>> points, const Polygons& polygons) {
  PolygonSoup soup;
  soup.points = std::move(points);
  soup.patchNames = {"all"};
  for (const auto& polygon : polygons) soup.addPolygon(polygon);
  return soup;
}

/// Corners (0,0,0), (1,0,0), (0,1,0), (0,0,1).
inline PolygonSoup tetrahedron() {
  return makeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                  {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

/// Six quads around the unit cube; vertex i at (bit 0, bit 1, bit 2) of i.
inline PolygonSoup cube() {
  std::vector<Vec3<double>> points;
  for (int i = 0; i < 8; ++i) {
    points.push_back(Box<double>{{0, 0, 0}, {1, 1, 1}}.corner(i));
  }
  return makeSoup(
      std::move(points),
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

/// A polygon in the plane z = 0, counter-clockwise, raised to z = height.
inline PolygonSoup prism(const std::vector<std::pair<double, double>>& outline, double height) {
  const auto n = static_cast<std::uint32_t>(outline.size());
  PolygonSoup soup;
  soup.patchNames = {"prism"};
  for (const double z : {0.0, height}) {
    for (const auto& [x, y] : outline) soup.points.push_back({x, y, z});
  }
  std::vector<std::uint32_t> bottom;
  std::vector<std::uint32_t> top;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
    soup.addPolygon(std::vector{i, next, n + next, n + i});
  }
  soup.addPolygon(bottom);
  soup.addPolygon(top);
  return soup;
}

/// Both pyramids over an n-gon in the unit circle, of height 1: n triangles at each apex.
inline PolygonSoup bipyramid(std::uint32_t n) {
  PolygonSoup soup;
  soup.patchNames = {"fans"};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    soup.points.push_back({std::cos(angle), std::sin(angle), 0});
  }
  soup.points.push_back({0, 0, 1});
  soup.points.push_back({0, 0, -1});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    soup.addPolygon(std::array{i, next, n});
    soup.addPolygon(std::array{next, i, n + 1});
  }
  return soup;
}

/// An L of arms 2 and thickness 1: area 3, one concave corner at (1, 1).
inline PolygonSoup lPrism(double height = 1) {
  return prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, height);
}

/// Faces side by side; no point is shared.
inline PolygonSoup together(const PolygonSoup& one, const PolygonSoup& other) {
  PolygonSoup result = one;
  const auto shift = static_cast<std::uint32_t>(one.points.size());
  result.points.insert(result.points.end(), other.points.begin(), other.points.end());
  for (std::size_t i = 0; i < other.polygonCount(); ++i) {
    std::vector<std::uint32_t> corners;
    for (const auto c : other.polygon(i)) corners.push_back(c + shift);
    result.addPolygon(corners, other.patches[i]);
  }
  return result;
}

template <typename Change>
PolygonSoup withPoints(PolygonSoup soup, Change change) {
  for (auto& p : soup.points) p = change(p);
  return soup;
}

/// Replaces one point by another wherever it is a corner.
inline PolygonSoup merged(PolygonSoup soup, std::uint32_t from, std::uint32_t into) {
  std::replace(soup.corners.begin(), soup.corners.end(), from, into);
  return soup;
}

/// Turns polygon i around.
inline PolygonSoup flipped(PolygonSoup soup, std::size_t i) {
  std::reverse(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.offsets[i]),
               soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.offsets[i + 1]));
  return soup;
}

/// Triangles (0, i, i + 1) around one vertex, closed by one polygon of n corners: a flat cone.
inline PolygonSoup star(std::uint32_t n) {
  std::vector<Vec3<double>> points{{0, 0, 1}};
  Polygons polygons(n + 1);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    polygons[i] = {0, i + 1, (i + 1) % n + 1};
    polygons[n].push_back(n - i);
  }
  return makeSoup(std::move(points), polygons);
}

/// Triangles that have nothing to do with each other, about `size` large; needles among them, and
/// some that are far smaller.
inline PolygonSoup randomTriangles(int count, double spread, double size) {
  RandomPoints<double> random(1, /*seed=*/11);
  PolygonSoup soup;
  soup.patchNames = {"random"};
  for (int i = 0; i < count; ++i) {
    const auto at = spread * random.next();
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    // Every other one a needle, and each seventh of a size of its own.
    const double scale = std::ldexp(size, i % 7 == 0 ? -(i % 40) : 0);
    const auto along = scale * random.next();
    const auto across = (i % 2 == 0 ? 1e-9 * scale : scale) * random.next();
    for (const auto& corner : {at, at + along, at + 0.4 * along + across}) {
      soup.points.push_back(corner);
    }
    soup.addPolygon(std::array{first, first + 1, first + 2});
  }
  return soup;
}

}  // namespace cutwater::test
