#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

#include <CGAL/Gmpq.h>

#include "Support/Clipping.hpp"

namespace cutwater::test::rational {

using Number = CGAL::Gmpq;
using Point = std::array<Number, 3>;
using Polygon = std::vector<Point>;
using Cell = std::array<int, 3>;

constexpr int kCells = 6;       // along each axis, from 0
constexpr double kWidth = 0.5;  // coordinates of corners are multiples of it

/// Twice the area of a polygon as seen along an axis, counterclockwise.
inline Number twiceArea(const Polygon& polygon, std::size_t axis) {
  const auto u = (axis + 1) % 3;
  const auto v = (axis + 2) % 3;
  Number sum(0);
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const auto& a = polygon[0];
    const auto& b = polygon[k - 1];
    const auto& c = polygon[k];
    sum += (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
  }
  return sum;
}

/// A convex polygon with these corners, counterclockwise as seen along the axis: sorted by angle
/// around their middle.
inline Polygon sortedAround(std::vector<Point> points, std::size_t axis) {
  if (points.size() < 3) return {};
  const auto u = (axis + 1) % 3;
  const auto v = (axis + 2) % 3;
  Point middle{Number(0), Number(0), Number(0)};
  for (const auto& p : points) {
    for (std::size_t a = 0; a < 3; ++a) middle[a] += p[a] / Number(static_cast<int>(points.size()));
  }
  const auto isLow = [&](const Point& p) {
    return p[v] < middle[v] || (p[v] == middle[v] && p[u] < middle[u]);
  };
  std::sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    if (isLow(a) != isLow(b)) return isLow(a);
    return (a[u] - middle[u]) * (b[v] - middle[v]) > (a[v] - middle[v]) * (b[u] - middle[u]);
  });
  return points;
}

/// The part of a convex polygon within another one, both counterclockwise as seen along the axis.
inline Polygon common(Polygon polygon, const Polygon& other, std::size_t axis) {
  for (std::size_t i = 0; i < other.size() && polygon.size() >= 3; ++i) {
    const auto& a = other[i];
    const auto& b = other[(i + 1) % other.size()];
    Polygon left;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto& p = polygon[k];
      const auto& q = polygon[(k + 1) % polygon.size()];
      const Number here = twiceArea({a, b, p}, axis);
      const Number next = twiceArea({a, b, q}, axis);
      if (here >= 0) left.push_back(p);
      if (here * next >= 0) continue;
      Point crossing;
      for (std::size_t n = 0; n < 3; ++n) crossing[n] = p[n] + here / (here - next) * (q[n] - p[n]);
      left.push_back(crossing);
    }
    polygon = std::move(left);
  }
  return polygon;
}

/// A tetrahedron with corners at multiples of the width; its triangles face outwards.
class Tetrahedron {
 public:
  explicit Tetrahedron(std::mt19937& random) {
    do {
      for (auto& corner : corners_) {
        for (auto& x : corner) x = static_cast<int>(random() % (kCells + 1));
      }
    } while (volume() == 0);
    if (volume() < 0) std::swap(corners_[0], corners_[1]);
  }

  [[nodiscard]] PolygonSoup soup() const {
    PolygonSoup soup;
    soup.patchNames = {"all"};
    for (const auto& c : corners_)
      soup.points.push_back({kWidth * c[0], kWidth * c[1], kWidth * c[2]});
    for (const auto& t : kTriangles) soup.addPolygon(t);
    return soup;
  }
  [[nodiscard]] std::vector<Polygon> triangles() const {
    std::vector<Polygon> result;
    for (const auto& t : kTriangles) {
      auto& polygon = result.emplace_back();
      for (const auto c : t) {
        polygon.push_back({Number(corners_[c][0]), Number(corners_[c][1]), Number(corners_[c][2])});
      }
    }
    return result;
  }
  /// Whether no point is within both: a plane separates them, that of a face or one along an edge
  /// of each.
  [[nodiscard]] bool isApartFrom(const Tetrahedron& other) const {
    for (const auto& u : edges()) {
      for (const auto& v : edges()) {
        if (isApartAlong(cross(u, v), other)) return true;
      }
      for (const auto& v : other.edges()) {
        if (isApartAlong(cross(u, v), other)) return true;
      }
    }
    for (const auto& u : other.edges()) {
      for (const auto& v : other.edges()) {
        if (isApartAlong(cross(u, v), other)) return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool isOnBothSidesOf(std::size_t axis, int plane) const {
    bool isBelow = false;
    bool isAbove = false;
    for (const auto& corner : corners_) {
      isBelow = isBelow || corner[axis] < plane;
      isAbove = isAbove || corner[axis] > plane;
    }
    return isBelow && isAbove;
  }
  /// The corners of its section by a plane of the grid, in any order.
  [[nodiscard]] std::vector<Point> section(std::size_t axis, int plane) const {
    std::vector<Point> points;
    const auto at = [&](std::size_t c) {
      return Point{Number(corners_[c][0]), Number(corners_[c][1]), Number(corners_[c][2])};
    };
    for (std::size_t a = 0; a < 4; ++a) {
      if (corners_[a][axis] == plane) points.push_back(at(a));
      for (std::size_t b = 0; b < a; ++b) {
        if ((corners_[a][axis] < plane) == (corners_[b][axis] < plane)) continue;
        if (corners_[a][axis] == plane || corners_[b][axis] == plane) continue;
        const Point p = at(a);
        const Point q = at(b);
        const Number share = (Number(plane) - p[axis]) / (q[axis] - p[axis]);
        Point crossing;
        for (std::size_t k = 0; k < 3; ++k) crossing[k] = p[k] + share * (q[k] - p[k]);
        points.push_back(crossing);
      }
    }
    return points;
  }

 private:
  static constexpr std::array<std::array<std::uint32_t, 3>, 4> kTriangles{
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

  static Cell cross(const Cell& u, const Cell& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  static int dot(const Cell& u, const Cell& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
  [[nodiscard]] Cell way(std::size_t from, std::size_t to) const {
    const auto& a = corners_[from];
    const auto& b = corners_[to];
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  }
  [[nodiscard]] std::array<Cell, 6> edges() const {
    return {way(0, 1), way(0, 2), way(0, 3), way(1, 2), way(1, 3), way(2, 3)};
  }
  [[nodiscard]] bool isApartAlong(const Cell& direction, const Tetrahedron& other) const {
    if (direction == Cell{}) return false;
    const auto reach = [&](const Tetrahedron& body) {
      std::array<int, 4> heights{};
      for (std::size_t c = 0; c < 4; ++c) heights[c] = dot(direction, body.corners_[c]);
      return std::minmax({heights[0], heights[1], heights[2], heights[3]});
    };
    const auto own = reach(*this);
    const auto its = reach(other);
    return own.second <= its.first || its.second <= own.first;
  }
  /// Six times it.
  [[nodiscard]] int volume() const { return dot(way(0, 1), cross(way(0, 2), way(0, 3))); }

  std::array<Cell, 4> corners_{};  // in widths
};

}  // namespace cutwater::test::rational
