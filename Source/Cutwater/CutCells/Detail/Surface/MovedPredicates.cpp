#include <Cutwater/CutCells/Detail/Surface/MovedPredicates.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <cmath>
#include <utility>

namespace cutwater {

namespace {

// The determinant of the vertices' positions as seen from a node has a column for each axis: a sum
// of the coordinates, P, of e_d s, S, and of -d_d, G. As it is linear in each column, it is the sum
// of the determinants with one of these in each, and the first that is not 0 has its sign.
enum class Column : std::uint8_t { P, S, G };

/// In the order of e_1^i e_2^j e_3^k, then those with a d. Two columns G are equal and give 0.
constexpr auto kInSpace = [] {
  using enum Column;
  return std::array<std::array<Column, 3>, 20>{{
      {P, P, P}, {S, P, P}, {P, S, P}, {S, S, P}, {P, P, S}, {S, P, S}, {P, S, S},
      {S, S, S}, {G, P, P}, {P, G, P}, {P, P, G}, {S, G, P}, {S, P, G}, {G, S, P},
      {P, S, G}, {S, S, G}, {G, P, S}, {P, G, S}, {S, G, S}, {G, S, S},
  }};
}();

/// The same for two of the axes, in their order.
constexpr auto kInPlane = [] {
  using enum Column;
  return std::array<std::array<Column, 2>, 8>{
      {{P, P}, {S, P}, {P, S}, {S, S}, {G, P}, {P, G}, {S, G}, {G, S}}};
}();

DoubleDouble columnEntry(const MovedVertex& v, int axis, Column column, double origin) {
  if (column == Column::P) return exactDifference(v.position[axis], origin);
  return column == Column::S ? static_cast<double>(v.shift[static_cast<std::size_t>(axis)]) : -1.0;
}

/// The sign of (p - origin) x (q - origin) along the axis that completes a < c.
int turnSign(const MovedVertex& p, const MovedVertex& q, const PlaneAcross& a,
             const PlaneAcross& c) {
  for (const auto& [first, second] : kInPlane) {
    const int sign = determinantSign(
        columnEntry(p, a.axis, first, a.position), columnEntry(q, a.axis, first, a.position),
        columnEntry(p, c.axis, second, c.position), columnEntry(q, c.axis, second, c.position));
    if (sign != 0) return sign;
  }
  return 0;
}

}  // namespace

bool isCrossingAbove(const MovedVertex& p, const MovedVertex& q, const PlaneAcross& crossed,
                     const PlaneAcross& plane) {
  // Seen along the third axis, the edge goes up the crossed axis, and the grid line is to its right
  // if the crossing is above it.
  const bool goesUp = isAbove(q, crossed.axis, crossed.position);
  const int turn =
      crossed.axis < plane.axis ? turnSign(p, q, crossed, plane) : -turnSign(p, q, plane, crossed);
  return goesUp ? turn < 0 : turn > 0;
}

int sideOfNode(const std::array<MovedVertex, 3>& triangle, const Vec3<double>& node) {
  for (const auto& columns : kInSpace) {
    std::array<DoubleDouble3, 3> rows;
    for (std::size_t i = 0; i < 3; ++i) {
      rows[i] = {columnEntry(triangle[i], 0, columns[0], node.x),
                 columnEntry(triangle[i], 1, columns[1], node.y),
                 columnEntry(triangle[i], 2, columns[2], node.z)};
    }
    // Positive where the vertices turn right as seen from the node: then it is behind them.
    if (const int sign = determinantSign(rows); sign != 0) return -sign;
  }
  return 0;
}

int riseBelowNode(const std::array<MovedVertex, 3>& triangle, const Vec3<double>& node, int axis) {
  const auto& [a, b, c] = triangle;
  const int low = axis == 0 ? 1 : 0;
  const PlaneAcross first{low, node[low]};
  const PlaneAcross second{3 - axis - low, node[3 - axis - low]};
  const int turn = turnSign(a, b, first, second);
  if (turn == 0 || turnSign(b, c, first, second) != turn || turnSign(c, a, first, second) != turn) {
    return 0;
  }
  // A triangle that turns left as seen from above has its normal upwards; x and z turn right about
  // y.
  const int facing = axis == 1 ? -turn : turn;
  return sideOfNode(triangle, node) == facing ? -facing : 0;
}

}  // namespace cutwater
