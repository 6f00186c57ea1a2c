#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <string>

namespace cutwater {

/// Options of removeSelfIntersections().
struct SelfIntersectionRepairOptions {
  /// Number of rounds, in which intersections that remain, or that the repair itself caused, are
  /// repaired again.
  int rounds = 7;
  /// More pairs of faces than this are refused: use wrap() for such a surface.
  std::size_t mostPairs = 100'000;
  /// Intersections not repaired within this time remain.
  double seconds = 120;
};

/// What removeSelfIntersections() did.
struct SelfIntersectionRepairReport {
  std::size_t pairsBefore = 0;
  std::size_t pairsAfter = 0;  ///< pairs of faces that intersect beyond shared points and edges
  std::size_t facesBefore = 0;
  std::size_t facesAfter = 0;
  /// The greatest distance of the result from the original surface, as WrapReport::farthest.
  double farthest = 0;
  SurfaceMeasure before;
  SurfaceMeasure after;
  double seconds = 0;

  /// One finding per line, each ending with '\n'.
  [[nodiscard]] std::string text() const;
};

/// Repairs places where a surface folds over or passes slightly through itself: faces around them
/// are smoothed or cut out, and the hole is filled again (by CGAL, in which this is experimental).
/// Overlapping shells are not merged: signs by winding number see their union anyway.
///
/// Polygons become triangles; new ones get the patch that is nearest to them. The soup is unchanged
/// if the result does not have fewer pairs than before, or if it throws. Do not call while other
/// threads use CGAL, whose error handlers it replaces meanwhile.
/// @throws Error(Topology) unless the surface is oriented and manifold, open or closed, or if CGAL
/// fails; Error(Limit) for more than `mostPairs`; Error(Argument) for rounds or seconds that are
/// not positive, and for a soup that does not pass PolygonSoup::validate().
SelfIntersectionRepairReport removeSelfIntersections(
    PolygonSoup& soup, const SelfIntersectionRepairOptions& options = {});

}  // namespace cutwater
