#pragma once

#include <Cutwater/CutCells/Detail/Surface/MovedTriangles.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// A closed surface whose vertices are moved towards the fluid, which is outside of it.
///
/// Along each axis, a vertex is moved to the side to which the triangles at it that lie across this
/// axis face; if there is none, to which its normal points, the sum of its triangles' normals
/// weighted by angles; up where that is 0. So a wall that lies in a plane of the grid is moved into
/// the cells of the fluid that it bounds, and takes no sliver of fluid into those of the body.
///
/// At a saddle, a vertex with walls in one plane that face opposite ways, each of them has a copy
/// of the vertex of its own. Triangles without area close the gaps between copies, and follow those
/// of the mesh. Where parts of the surface touch in such a vertex, they overlap once they are
/// moved.
///
/// Baffles are triangles besides, between fluid and fluid: they follow all others, need no
/// neighbours, have no edges, and are moved up each axis.
class MovedSurface {
 public:
  using Corners = MovedTriangles::Corners;

  /// @throws Error(Topology) if an edge has more triangles on one side than on the other. Triangles
  /// have three different corners.
  MovedSurface(std::span<const Vec3<double>> positions, std::span<const Corners> triangles,
               std::span<const Corners> baffles = {});

  /// Of all triangles, of those that are closed, and of those of the mesh alone.
  [[nodiscard]] std::size_t triangleCount() const { return triangles_.corners.size(); }
  [[nodiscard]] std::size_t closedCount() const { return closedCount_; }
  [[nodiscard]] std::size_t meshTriangleCount() const { return triangles_.meshTriangles; }

  /// A triangle's vertices, and the edges between each and the next one. Each edge has two
  /// triangles, which bound the same fluid there if the surface does not overlap.
  [[nodiscard]] const Corners& corners(std::uint32_t id) const { return triangles_.corners[id]; }
  [[nodiscard]] const Corners& edges(std::uint32_t id) const { return triangles_.edges[id]; }
  [[nodiscard]] std::array<MovedVertex, 3> triangle(std::uint32_t id) const {
    const auto& [a, b, c] = triangles_.corners[id];
    return {triangles_.vertices[a], triangles_.vertices[b], triangles_.vertices[c]};
  }
  /// Where its vertices are, before they are moved.
  [[nodiscard]] std::array<Vec3<double>, 3> positionsOf(std::uint32_t id) const {
    const auto [a, b, c] = triangle(id);
    return {a.position, b.position, c.position};
  }
  [[nodiscard]] bool isBaffle(std::uint32_t id) const { return id >= closedCount_; }
  /// Triangles of the mesh at vertices around which moved parts overlap, in ascending order.
  [[nodiscard]] std::span<const std::uint32_t> overlapping() const { return overlapping_; }

 private:
  void moveVertices();
  void addBaffles(std::span<const Vec3<double>> positions, std::span<const Corners> baffles);

  MovedTriangles triangles_;
  std::size_t closedCount_ = 0;
  std::vector<std::uint32_t> overlapping_;
};

}  // namespace cutwater
