#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace cutwater {

// Which side of the planes, lines and nodes of a grid a surface passes on, without ties.
//
// Each vertex is moved by (s_x e_1, s_y e_2, s_z e_3), where s is 1 or -1 along each axis, and the
// grid by (d_1, d_2, d_3): simulation of simplicity (Edelsbrunner and Muecke, ACM Trans. Graph. 9
// (1990)) with e_1 >> e_2 >> e_3 > 0 and e_3 << e_1 e_2, then d_1 >> d_2 >> d_3 > 0, smaller than
// all products of the e, with d_c / d_a >> e_c / e_a for a < c. All answers are those for one
// surface and one grid, so they never contradict each other.
//
// Coordinates must be scaled as ExactPredicates.hpp says.

/// A vertex, and whether it is moved up or down each axis.
struct MovedVertex {
  Vec3<double> position;
  std::array<std::int8_t, 3> shift{1, 1, 1};  ///< 1 or -1
};

/// Whether the vertex lies above the plane where the coordinate has this value.
[[nodiscard]] inline bool isAbove(const MovedVertex& v, int axis, double plane) {
  return v.position[axis] > plane ||
         (v.position[axis] == plane && v.shift[static_cast<std::size_t>(axis)] > 0);
}

/// Whether points lie in one plane across the axis.
[[nodiscard]] inline bool lieAcross(std::span<const Vec3<double>> points, int axis) {
  return std::ranges::all_of(points,
                             [&](const Vec3<double>& p) { return p[axis] == points[0][axis]; });
}

/// A plane across an axis.
struct PlaneAcross {
  int axis = 0;
  double position = 0;
};

/// Whether the point in which an edge crosses the first plane lies above the second, which is
/// across another axis. The ends must lie on different sides of the first plane.
[[nodiscard]] bool isCrossingAbove(const MovedVertex& p, const MovedVertex& q,
                                   const PlaneAcross& crossed, const PlaneAcross& plane);

/// The side of the triangle's plane on which a node lies: 1 where the normal (b - a) x (c - a)
/// points, else -1; 0 only for triangles that are seen edge-on along every axis, however moved.
[[nodiscard]] int sideOfNode(const std::array<MovedVertex, 3>& triangle, const Vec3<double>& node);

/// By how much the winding number rises, going up an axis, where the line through the node passes
/// through the triangle below the node: 1 into the solid, -1 out of it; 0 if it does not.
[[nodiscard]] int riseBelowNode(const std::array<MovedVertex, 3>& triangle,
                                const Vec3<double>& node, int axis);

}  // namespace cutwater
