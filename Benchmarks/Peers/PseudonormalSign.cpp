#include "Peers/PseudonormalSign.hpp"

#include <algorithm>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

namespace cutwater::benchmarks {

namespace {

double angleBetween(const Vec3<double>& u, const Vec3<double>& v) {
  return std::atan2(length(cross(u, v)), dot(u, v));
}

Corners cornersOf(const PolygonSoup& triangles, std::size_t i) {
  const auto v = triangles.polygon(i);
  return {triangles.points[v[0]], triangles.points[v[1]], triangles.points[v[2]]};
}

struct Side {
  std::uint64_t edge;    // lower vertex, upper vertex
  std::uint32_t corner;  // 3 * triangle + the corner it starts from
  bool operator<(const Side& other) const { return edge < other.edge; }
};

}  // namespace

std::vector<Corners> cornersOf(const PolygonSoup& triangles) {
  std::vector<Corners> result(triangles.polygonCount());
  tbb::parallel_for(std::size_t{0}, result.size(),
                    [&](std::size_t i) { result[i] = cornersOf(triangles, i); });
  return result;
}

PseudonormalSign::PseudonormalSign(const PolygonSoup& triangles)
    : corners_(triangles.corners),
      faces_(triangles.polygonCount()),
      vertices_(triangles.points.size()),
      edges_(triangles.polygonCount()) {
  setFaces(triangles);
  setVertices(triangles);
  setEdges();
}

void PseudonormalSign::setFaces(const PolygonSoup& triangles) {
  tbb::parallel_for(std::size_t{0}, faces_.size(), [&](std::size_t i) {
    const auto [a, b, c] = cornersOf(triangles, i);
    faces_[i] = normalized(cross(b - a, c - a));
  });
}

void PseudonormalSign::setVertices(const PolygonSoup& triangles) {
  std::vector<std::array<double, 3>> angles(faces_.size());
  tbb::parallel_for(std::size_t{0}, faces_.size(), [&](std::size_t i) {
    const auto [a, b, c] = cornersOf(triangles, i);
    angles[i] = {angleBetween(b - a, c - a), angleBetween(c - b, a - b),
                 angleBetween(a - c, b - c)};
  });
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) vertices_[corners_[3 * i + k]] += angles[i][k] * faces_[i];
  }
}

void PseudonormalSign::setEdges() {
  std::vector<Side> sides(corners_.size());
  tbb::parallel_for(std::size_t{0}, corners_.size(), [&](std::size_t i) {
    const auto from = corners_[i];
    const auto to = corners_[i % 3 == 2 ? i - 2 : i + 1];
    const auto [lower, upper] = std::minmax(from, to);
    sides[i] = {std::uint64_t{lower} << 32U | upper, static_cast<std::uint32_t>(i)};
  });
  tbb::parallel_sort(sides.begin(), sides.end());
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last =
        std::find_if(first, sides.end(), [&](const Side& s) { return s.edge != first->edge; });
    Vec3<double> sum;
    for (auto side = first; side != last; ++side) sum += faces_[side->corner / 3];
    for (auto side = first; side != last; ++side) edges_[side->corner / 3][side->corner % 3] = sum;
    first = last;
  }
}

}  // namespace cutwater::benchmarks
