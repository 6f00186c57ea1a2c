#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Surface/MovedTriangles.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

namespace cutwater {

DoubleDouble3 MovedTriangles::wayBetween(std::uint32_t from, std::uint32_t to) const {
  const auto& p = positionOf(from);
  const auto& q = positionOf(to);
  return {exactDifference(q.x, p.x), exactDifference(q.y, p.y), exactDifference(q.z, p.z)};
}

int MovedTriangles::facing(std::uint32_t triangle, int axis) const {
  const auto& [a, b, c] = corners[triangle];
  const double at = positionOf(a)[axis];
  if (positionOf(b)[axis] != at || positionOf(c)[axis] != at) return 0;
  return crossSign(positionOf(a), positionOf(b), positionOf(a), positionOf(c), axis);
}

namespace {

/// Pairs the sides at the edge between two vertices.
void pairAtEdge(MovedTriangles& triangles, const std::pair<std::uint32_t, std::uint32_t>& edge,
                std::span<const std::uint32_t> sides) {
  const auto [p, q] = edge;
  std::vector<SideAtEdge> around;
  for (const auto side : sides) {
    around.push_back(
        {side, triangles.startOf(side) == p, triangles.wayBetween(p, triangles.oppositeOf(side))});
  }
  for (const auto& [one, other] : pairedAround(triangles.wayBetween(p, q), std::move(around))) {
    triangles.pair(one, other);
  }
}

}  // namespace

void pairSides(MovedTriangles& triangles) {
  std::vector<std::uint32_t> order(3 * triangles.corners.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto ends = [&](std::uint32_t side) {
    return std::pair(std::minmax({triangles.startOf(side), triangles.endOf(side)}));
  };
  std::ranges::sort(order, {}, [&](std::uint32_t side) { return std::pair(ends(side), side); });
  triangles.edges.resize(triangles.corners.size());
  for (std::size_t first = 0; first < order.size();) {
    const auto edge = ends(order[first]);
    auto last = first + 1;
    while (last < order.size() && ends(order[last]) == edge) ++last;
    const auto sides = std::span(order).subspan(first, last - first);
    const auto forward = std::ranges::count_if(
        sides, [&](std::uint32_t side) { return triangles.startOf(side) == edge.first; });
    if (2 * static_cast<std::size_t>(forward) != sides.size()) {
      throw Error(ErrorKind::Topology, "cut cells: the surface is not closed");
    }
    if (sides.size() == 2) {
      triangles.pair(sides[0], sides[1]);
    } else {
      pairAtEdge(triangles, edge, sides);
    }
    first = last;
  }
}

}  // namespace cutwater
