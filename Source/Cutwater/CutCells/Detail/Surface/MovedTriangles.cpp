#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Surface/MovedTriangles.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
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

/// A side, under the two vertices that it joins, the lower one in the upper half of the key.
struct SideOfEdge {
  std::uint64_t ends = 0;
  std::uint32_t side = 0;

  [[nodiscard]] std::uint32_t lower() const { return static_cast<std::uint32_t>(ends >> 32U); }
  [[nodiscard]] std::uint32_t upper() const { return static_cast<std::uint32_t>(ends); }
  [[nodiscard]] bool operator<(const SideOfEdge& other) const {
    return ends != other.ends ? ends < other.ends : side < other.side;
  }
};

std::vector<SideOfEdge> sidesByEdge(std::span<const MovedTriangles::Corners> triangles) {
  std::vector<SideOfEdge> sides;
  sides.reserve(3 * triangles.size());
  for (const auto& corners : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [lower, upper] = std::minmax({corners[i], corners[(i + 1) % 3]});
      sides.push_back(
          {std::uint64_t{lower} << 32U | upper, static_cast<std::uint32_t>(sides.size())});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Pairs the sides at an edge.
void pairAtEdge(MovedTriangles& triangles, std::span<const SideOfEdge> sides) {
  const auto p = sides.front().lower();
  const auto q = sides.front().upper();
  std::vector<SideAtEdge> around;
  for (const auto& [ends, side] : sides) {
    around.push_back(
        {side, triangles.startOf(side) == p, triangles.wayBetween(p, triangles.oppositeOf(side))});
  }
  for (const auto& [one, other] : pairedAround(triangles.wayBetween(p, q), std::move(around))) {
    triangles.pair(one, other);
  }
}

}  // namespace

void pairSides(MovedTriangles& triangles) {
  const auto all = sidesByEdge(triangles.corners);
  triangles.edges.resize(triangles.corners.size());
  for (std::size_t first = 0; first < all.size();) {
    auto last = first + 1;
    while (last < all.size() && all[last].ends == all[first].ends) ++last;
    const auto sides = std::span(all).subspan(first, last - first);
    const auto forward = std::ranges::count_if(
        sides, [&](const SideOfEdge& it) { return triangles.startOf(it.side) == it.lower(); });
    if (2 * static_cast<std::size_t>(forward) != sides.size()) {
      throw Error(ErrorKind::Topology, "cut cells: the surface is not closed");
    }
    if (sides.size() == 2) {
      triangles.pair(sides[0].side, sides[1].side);
    } else {
      pairAtEdge(triangles, sides);
    }
    first = last;
  }
}

}  // namespace cutwater
