#pragma once

#include <Cutwater/CutCells/Detail/MovedPredicates.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// A closed surface whose vertices are moved towards the fluid, which is outside of it.
///
/// Along each axis, a vertex is moved to the side to which its normal, the sum of its triangles'
/// normals weighted by angles, points; up where that is 0. So a wall that lies in a plane of the
/// grid is moved into the cells of the fluid that it bounds, and takes no sliver of fluid into
/// those of the body. Only at a saddle, a vertex with walls in one plane that face opposite ways,
/// can one of them be on the wrong side.
class MovedSurface {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  /// Views the triangles.
  MovedSurface(std::span<const Vec3<double>> positions, std::span<const Corners> triangles);

  [[nodiscard]] std::size_t triangleCount() const { return triangles_.size(); }
  [[nodiscard]] const Corners& corners(std::uint32_t id) const { return triangles_[id]; }
  [[nodiscard]] std::array<MovedVertex, 3> triangle(std::uint32_t id) const {
    const auto& [a, b, c] = triangles_[id];
    return {vertices_[a], vertices_[b], vertices_[c]};
  }

  /// How often the moved surface winds around a node. Asks all triangles.
  [[nodiscard]] int windingAt(const Vec3<double>& node) const;

 private:
  std::vector<MovedVertex> vertices_;
  std::span<const Corners> triangles_;
};

}  // namespace cutwater
