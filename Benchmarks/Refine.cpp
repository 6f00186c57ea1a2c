#include "Refine.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "Points.hpp"

namespace cutwater::benchmarks {

namespace {

using Triple = std::array<std::uint32_t, 3>;

struct Edge {
  std::uint32_t lower;
  std::uint32_t upper;
  bool operator==(const Edge&) const = default;
  bool operator<(const Edge& other) const {
    return lower != other.lower ? lower < other.lower : upper < other.upper;
  }
};

Edge edgeBetween(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

std::vector<Edge> edgesOf(const PolygonSoup& triangles) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < triangles.polygonCount(); ++i) {
    const auto v = triangles.polygon(i);
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(edgeBetween(v[k], v[(k + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// The longest ones, sorted by their ends.
std::vector<Edge> longest(std::vector<Edge> edges, const PolygonSoup& soup, std::size_t count) {
  count = std::min(count, edges.size());
  const auto isLonger = [&](const Edge& a, const Edge& b) {
    const double lengthA = lengthSquared(soup.points[a.upper] - soup.points[a.lower]);
    const double lengthB = lengthSquared(soup.points[b.upper] - soup.points[b.lower]);
    return lengthA != lengthB ? lengthA > lengthB : a < b;
  };
  const auto end = edges.begin() + static_cast<std::ptrdiff_t>(count);
  if (end != edges.end()) std::nth_element(edges.begin(), end, edges.end(), isLonger);
  edges.erase(end, edges.end());
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The triangle v whose edge from v[k] to the next corner has the midpoint m[k], or none.
void addSplit(PolygonSoup& soup, Triple v, Triple m) {
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup.addPolygon(Triple{a, b, c});
  };
  const auto split = 3 - std::count(m.begin(), m.end(), kNone);
  // One split edge comes first, two come first and second.
  while ((split == 1 && m[0] == kNone) || (split == 2 && m[2] != kNone)) {
    std::rotate(v.begin(), v.begin() + 1, v.end());
    std::rotate(m.begin(), m.begin() + 1, m.end());
  }
  if (split == 0) {
    add(v[0], v[1], v[2]);
  } else if (split == 1) {
    add(v[0], m[0], v[2]);
    add(m[0], v[1], v[2]);
  } else {
    add(m[0], v[1], m[1]);
    if (split == 2) {
      add(v[0], m[0], m[1]);
      add(v[0], m[1], v[2]);
    } else {
      add(v[0], m[0], m[2]);
      add(m[2], m[1], v[2]);
      add(m[0], m[1], m[2]);
    }
  }
}

PolygonSoup withSplit(const PolygonSoup& triangles, const std::vector<Edge>& edges) {
  PolygonSoup result;
  result.points = triangles.points;
  result.patchNames = triangles.patchNames;
  const auto firstMidpoint = static_cast<std::uint32_t>(result.points.size());
  for (const auto& [a, b] : edges) {
    result.points.push_back(0.5 * triangles.points[a] + 0.5 * triangles.points[b]);
  }
  for (std::size_t i = 0; i < triangles.polygonCount(); ++i) {
    const auto v = triangles.polygon(i);
    Triple midpoints{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = edgeBetween(v[k], v[(k + 1) % 3]);
      const auto at = std::lower_bound(edges.begin(), edges.end(), edge);
      const bool isSplit = at != edges.end() && *at == edge;
      midpoints[k] =
          isSplit ? firstMidpoint + static_cast<std::uint32_t>(at - edges.begin()) : kNone;
    }
    addSplit(result, {v[0], v[1], v[2]}, midpoints);
  }
  return result;
}

}  // namespace

PolygonSoup refined(PolygonSoup triangles, std::size_t count) {
  while (triangles.polygonCount() < count) {
    // Each edge that is split makes two triangles more.
    const auto wanted = (count - triangles.polygonCount() + 1) / 2;
    triangles = withSplit(triangles, longest(edgesOf(triangles), triangles, wanted));
  }
  return triangles;
}

void displace(PolygonSoup& triangles, double amplitude) {
  std::vector<Vec3<double>> normals(triangles.points.size());
  for (std::size_t i = 0; i < triangles.polygonCount(); ++i) {
    const auto v = triangles.polygon(i);
    const auto& a = triangles.points[v[0]];
    const auto normal = cross(triangles.points[v[1]] - a, triangles.points[v[2]] - a);
    for (const auto corner : v) normals[corner] += normal;
  }
  struct Wave {
    Vec3<double> direction;  // times the wave number
    double phase;
  };
  std::array<Wave, 8> waves;
  Random random(4);
  const double number = 2 * std::numbers::pi * 60 / triangles.boundingBox().diagonal();
  for (auto& wave : waves) wave = {random.inBall(number), 2 * std::numbers::pi * random.unit()};
  for (std::size_t i = 0; i < normals.size(); ++i) {
    double height = 0;
    for (const auto& w : waves) height += std::sin(dot(w.direction, triangles.points[i]) + w.phase);
    triangles.points[i] += amplitude / waves.size() * height * normalized(normals[i]);
  }
}

}  // namespace cutwater::benchmarks
