#pragma once

#include <Cutwater/Surface/MeshRanges.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <cstddef>
#include <vector>

namespace cutwater {

/// The polygons of a soup as triangles, with statistics.
struct Triangulation {
  std::vector<TriangleCorners> triangles;
  std::vector<std::uint32_t> polygons;  ///< per triangle: the polygon that it is part of; ascending

  std::size_t polygonsSplit = 0;    ///< polygons of more than three corners
  std::size_t polygonsDropped = 0;  ///< polygons of fewer than three corners, repeats not counted

  /// How far the worst polygon is from planar: the largest distance of a corner from the plane of
  /// the Newell normal through the mean of the corners, as a length and relative to the polygon's
  /// size (the largest distance of a corner from that mean).
  double warp = 0;
  double relativeWarp = 0;
  std::uint32_t mostWarped =
      kNone;  ///< the polygon with the largest relativeWarp; kNone if all are 0
  /// Polygons with a relative warp above 1e-6: more than the rounding of the digits in files
  /// explains.
  std::size_t polygonsWarped = 0;
};

/// Cuts polygons into triangles with the same corners and orientation, deterministically.
///
/// A corner that repeats the one before it is left out; a polygon of n corners then gives n - 2
/// triangles, and a triangle gives itself. Quads are cut along the diagonal that gives the better
/// triangles and stays inside. Larger polygons are cut by ear clipping, best ear first, in the
/// projection along the axis closest to the Newell normal: correct for concave and for non-planar
/// polygons as long as the projection does not overlap itself, and always n - 2 triangles. No
/// corner is added or moved and every edge of a polygon is kept, so a closed mesh stays closed.
///
/// Linear for triangles and quads; for n corners, n log n + n times the number of reflex corners in
/// the way.
/// Every corner must be the index of a point (DcelMesh checks that, this function does not).
/// @throws Error(Limit) for more than 2^32 - 2 polygons or corners.
[[nodiscard]] Triangulation triangulate(const PolygonSoup& soup);

/// Returns the soup with triangulate()'s triangles in place of its polygons; points and patches
/// stay.
[[nodiscard]] PolygonSoup triangulated(const PolygonSoup& soup);

}  // namespace cutwater
