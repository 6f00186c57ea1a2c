#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace cutwater::detail {

// The cube's corners are numbered i + 2 j + 4 k; its edges 4 axis + (0 ... 3), by their lower
// corners in order; its faces 2 axis + (0: lower, 1: upper). A set of corners, or faces, is a mask
// of bits.

struct CubeEdge {
  int axis;
  int corner;  ///< the lower of its two ends
};
[[nodiscard]] CubeEdge cubeEdge(int edge);
/// The edge between two neighbouring corners.
[[nodiscard]] int cubeEdgeBetween(int corner, int other);
/// Corners of a face, counter-clockwise as seen from outside of the cube.
[[nodiscard]] std::array<int, 4> cubeFace(int face);

/// Faces with corners inside and outside in turn: which of them belong together, is not told by
/// their signs.
[[nodiscard]] unsigned ambiguousFaces(unsigned inside);

/// A polygon in a cell of marching cubes. Its corners are where the surface cuts edges of the cube
/// (0 ... 11), or corners of the cube (12 + corner).
struct CellPolygon {
  static constexpr int kMost = 12;

  std::array<std::uint8_t, kMost> corners{};
  int count = 0;

  void add(int corner) {
    corners[static_cast<std::size_t>(count++)] = static_cast<std::uint8_t>(corner);
  }
};

/// The polygons that divide the inside corners of a cube from the others (Lorensen and Cline 1987),
/// each turned so that its normal looks out of the solid. `joined`: those of the ambiguous faces
/// whose inside corners belong together. Cells that share a face agree on what is cut from it, so
/// that all polygons together are a closed surface with two at each edge and one fan about each
/// corner, whatever the signs. Returns how many there are, 4 at most.
int surfacePolygons(unsigned inside, unsigned joined, std::array<CellPolygon, 4>& polygons);

/// The parts of a face that are inside, turned so that their normals look out of the cube: what
/// closes the surface where the grid ends. Returns how many there are, 2 at most.
int facePolygons(unsigned inside, unsigned joined, int face, std::array<CellPolygon, 2>& polygons);

/// A triangle by three corners of its polygon, as numbered there.
using PolygonTriangles = std::array<std::array<std::uint8_t, 3>, CellPolygon::kMost - 2>;

/// Divides a polygon into triangles by the diagonals that are shortest in all (in their squares);
/// none of them lies in a face of the cube, where a neighbouring cell might have the same, unless
/// all of the polygon does. Returns how many triangles there are: none, if that cannot be, as for
/// a few polygons of 8, 9 and 12 corners.
int triangulate(const CellPolygon& polygon, std::span<const Vec3<double>> positions,
                PolygonTriangles& triangles);
/// Whether a polygon has no such triangles, wherever its edges are cut.
[[nodiscard]] bool needsMiddle(const CellPolygon& polygon);

}  // namespace cutwater::detail
