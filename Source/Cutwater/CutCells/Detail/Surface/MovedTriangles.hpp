#pragma once

#include <Cutwater/CutCells/Detail/Surface/MovedPredicates.hpp>
#include <Cutwater/CutCells/Detail/Surface/SidePairs.hpp>

#include <cstddef>
#include <vector>

namespace cutwater {

/// The triangles of a MovedSurface. Side i of triangle t, from corner i to the next, is number
/// 3 t + i.
struct MovedTriangles {
  using Corners = std::array<std::uint32_t, 3>;

  std::vector<MovedVertex> vertices;
  std::vector<Corners> corners;
  std::vector<Corners> edges;     ///< of each side: an edge has two sides
  std::size_t meshTriangles = 0;  ///< those that follow close gaps between copies of vertices
  std::uint32_t edgeCount = 0;

  [[nodiscard]] std::uint32_t startOf(std::uint32_t side) const {
    return corners[side / 3][side % 3];
  }
  [[nodiscard]] std::uint32_t endOf(std::uint32_t side) const {
    return corners[side / 3][(side % 3 + 1) % 3];
  }
  [[nodiscard]] std::uint32_t oppositeOf(std::uint32_t side) const {
    return corners[side / 3][(side % 3 + 2) % 3];
  }
  [[nodiscard]] const Vec3<double>& positionOf(std::uint32_t vertex) const {
    return vertices[vertex].position;
  }
  /// Makes two sides an edge.
  void pair(std::uint32_t one, std::uint32_t other) {
    edges[one / 3][one % 3] = edges[other / 3][other % 3] = edgeCount++;
  }
  /// The exact way from one vertex to another.
  [[nodiscard]] DoubleDouble3 wayBetween(std::uint32_t from, std::uint32_t to) const;
  /// Where a triangle that lies across the axis faces along it: 1 or -1; else 0.
  [[nodiscard]] int facing(std::uint32_t triangle, int axis) const;
};

/// Makes an edge of each two sides that belong together: see pairedAround().
/// @throws Error(Topology) if there are edges with more sides one way than the other.
void pairSides(MovedTriangles& triangles);

}  // namespace cutwater
