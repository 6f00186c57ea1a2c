#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace cutwater::detail {

// The cube is the cell of marching cubes, scaled to unit edges. Its corners are numbered i + 2 j +
// 4 k; its edges 4 axis + (0 ... 3), by their lower corners in order; its faces 2 axis + (0: lower,
// 1: upper). A set of corners, or faces, is a mask of bits.

struct CubeEdge {
  int axis;
  int corner;  ///< the lower of its two ends
};
[[nodiscard]] CubeEdge cubeEdge(int edge);
/// The edge between two neighbouring corners.
[[nodiscard]] int cubeEdgeBetween(int corner, int other);
/// Corners of a face, counter-clockwise as seen from outside the cube.
[[nodiscard]] std::array<int, 4> cubeFace(int face);

/// Faces whose corners alternate between inside and outside: their signs do not determine which of
/// them belong together.
[[nodiscard]] unsigned ambiguousFaces(unsigned inside);

/// A polygon in a cell of marching cubes. Its corners are the points where the surface cuts edges
/// of the cube (0 ... 11), or corners of the cube (12 + corner).
struct CellPolygon {
  static constexpr int kMost = 12;

  std::array<std::uint8_t, kMost> corners{};
  int count = 0;

  void add(int corner) {
    corners[static_cast<std::size_t>(count++)] = static_cast<std::uint8_t>(corner);
  }
};

/// Finds the polygons that separate the inside corners of a cube from the others (Lorensen and
/// Cline 1987), oriented so that their normals point out of the solid. `joined`: the ambiguous
/// faces whose inside corners belong together. Cells that share a face agree on how it is cut, so
/// that all polygons together form a closed surface, with two polygons at each edge and one fan
/// about each corner, whatever the signs. Returns their number, at most 4.
int surfacePolygons(unsigned inside, unsigned joined, std::array<CellPolygon, 4>& polygons);

/// Finds the parts of a face that are inside, oriented so that their normals point out of the cube:
/// they close the surface where the grid ends. Returns their number, at most 2.
int facePolygons(unsigned inside, unsigned joined, int face, std::array<CellPolygon, 2>& polygons);

/// Triangles, each given by three corners of the polygon, as numbered there.
using PolygonTriangles = std::array<std::array<std::uint8_t, 3>, CellPolygon::kMost - 2>;

/// Triangulates a polygon with the diagonals whose squared lengths have the smallest sum. None of
/// them lies in a face of the cube, where a neighbouring cell might have the same one, unless the
/// whole polygon does. Returns the number of triangles: 0 if there is no such triangulation, as for
/// a few polygons of 8, 9 and 12 corners.
int triangulate(const CellPolygon& polygon, std::span<const Vec3<double>> positions,
                PolygonTriangles& triangles);
/// Whether a polygon has no such triangulation, wherever its edges are cut.
[[nodiscard]] bool needsMiddle(const CellPolygon& polygon);

}  // namespace cutwater::detail
