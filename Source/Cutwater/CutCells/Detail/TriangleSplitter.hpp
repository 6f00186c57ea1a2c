#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/Detail/GridPlanes.hpp>
#include <Cutwater/CutCells/Detail/MovedPredicates.hpp>

namespace cutwater {

/// What an edge of a fragment lies on: an edge of its triangle, from corner `number` to the next
/// one, or a plane of the grid.
struct FragmentEdge {
  int axis = -1;  ///< of the plane; -1: an edge of the triangle
  int number = 0;

  [[nodiscard]] bool isPlane() const { return axis >= 0; }
  bool operator==(const FragmentEdge&) const = default;
};

/// The part of a triangle in one cell: a convex polygon, oriented as the triangle.
///
/// Point i lies where edges i - 1 and i meet: at a corner of the triangle, on one of its edges and
/// a plane, or on two planes.
struct Fragment {
  /// A triangle has three edges, and a cell six faces.
  static constexpr int kMost = 9;

  std::array<std::int32_t, 3> cell{};
  int size = 0;
  std::array<Vec3<double>, kMost> points;
  std::array<FragmentEdge, kMost> edges;  ///< from point i to the next
};

/// Divides a triangle among the cells of a grid: calls visit(fragment) for each part in a cell;
/// parts beyond the grid's planes are left out.
///
/// Which cells the triangle has a part in, and in what planes and edges these parts end, are those
/// of the moved surface (see MovedPredicates.hpp), exactly. Points are computed in double from the
/// whole triangle and the planes that they lie on, so that all cells compute the same bits, and
/// triangles that share an edge do, too. They lie in the cell, to the bit.
///
/// `vertices` are three different numbers. Triangles that share an edge give its ends the same
/// ones.
void splitTriangle(const GridPlanes& planes, const std::array<MovedVertex, 3>& triangle,
                   const std::array<std::uint32_t, 3>& vertices,
                   FunctionRef<void(const Fragment&)> visit);

}  // namespace cutwater
