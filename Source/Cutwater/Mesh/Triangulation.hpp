#pragma once

#include <Cutwater/Mesh/MeshRanges.hpp>
#include <Cutwater/Mesh/PolygonSoup.hpp>

#include <cstddef>
#include <vector>

namespace cutwater {

/// The polygons of a soup as triangles, and what was met on the way.
struct Triangulation {
  std::vector<TriangleCorners> triangles;
  std::vector<std::uint32_t> polygons;  ///< per triangle: the polygon it is part of; ascending

  std::size_t polygonsSplit = 0;    ///< polygons of more than three corners
  std::size_t polygonsDropped = 0;  ///< polygons of fewer than three corners, repeats not counted

  /// How far from flat the worst polygon is: the largest distance of a corner from the plane of the
  /// Newell normal through the corners' mean, in units of length and over the polygon's size (the
  /// largest distance of a corner from that mean).
  double warp = 0;
  double relativeWarp = 0;
  std::uint32_t mostWarped =
      kNone;  ///< the polygon of the largest relativeWarp; kNone if all are 0
  /// Polygons of a relative warp above 1e-6: more than the digits that files are written with.
  std::size_t polygonsWarped = 0;
};

/// Cuts polygons into triangles of the same corners and orientation, deterministically.
///
/// A corner that repeats the one before it is left out; a polygon of n corners then gives n - 2
/// triangles, a triangle itself. Quads are cut along the diagonal that gives the better triangles
/// and stays inside; larger polygons by clipping ears, best first, in the projection along the axis
/// that the Newell normal is nearest to: right for concave and for non-planar polygons as long as
/// the projection does not overlap itself, and always n - 2 triangles. Corners are neither added
/// nor moved and every edge of a polygon is kept, so a closed mesh stays closed.
///
/// Linear for triangles and quads; n log n + n times the number of reflex corners in the way, for n
/// corners.
/// Needs corners that are points (DcelMesh checks that, this does not).
/// @throws Error(Limit) for more than 2^32 - 2 polygons or corners.
[[nodiscard]] Triangulation triangulate(const PolygonSoup& soup);

/// The soup with triangulate()'s triangles for polygons; points and patches stay.
[[nodiscard]] PolygonSoup triangulated(const PolygonSoup& soup);

}  // namespace cutwater
