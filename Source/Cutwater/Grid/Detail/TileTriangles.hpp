#pragma once

#include <Cutwater/Grid/Detail/SharpFeatures.hpp>
#include <Cutwater/Grid/Detail/SurfaceTiles.hpp>

namespace cutwater::detail {

/// A triangle of an isosurface: indices of its corners among the mesh's points.
using Triangle = std::array<std::uint32_t, 3>;

/// Triangulates the surface in all tiles, whose points are `points`. Appends those that stand for
/// sharp features to them.
template <std::floating_point T>
[[nodiscard]] std::vector<Triangle> tileTriangles(const SurfaceGrid<T>& grid,
                                                  const SurfaceTiles<T>& tiles,
                                                  const SharpFeatures<T>& features,
                                                  std::vector<Vec3<double>>& points,
                                                  const ParallelOptions& options);

/// Adds the triangles that close the surface where the grid ends, and their new points.
template <std::floating_point T>
void closeGridEnds(const SurfaceGrid<T>& grid, const SurfaceTiles<T>& tiles,
                   std::vector<Vec3<double>>& points, std::vector<Triangle>& triangles);

}  // namespace cutwater::detail
