#pragma once

#include <Cutwater/Mesh/PolygonSoup.hpp>
#include <Cutwater/Mesh/SelfIntersections.hpp>
#include <Cutwater/Mesh/SurfaceMeasure.hpp>

#include <string>

namespace cutwater {

/// Options of removeSelfIntersections().
struct SelfIntersectionRepairOptions {
  /// How often what is left, or was made by the repair itself, is gone about again.
  int rounds = 7;
  /// More pairs of faces than this are refused: such a surface wants wrap().
  std::size_t mostPairs = 100'000;
  /// What is not mended by then stays.
  double seconds = 120;
};

/// What removeSelfIntersections() did.
struct SelfIntersectionRepairReport {
  std::size_t pairsBefore = 0;
  std::size_t pairsAfter = 0;  ///< of faces that meet in more than they share
  std::size_t facesBefore = 0;
  std::size_t facesAfter = 0;
  /// The greatest distance of the result from the surface before, as WrapReport::farthest.
  double farthest = 0;
  SurfaceMeasure before;
  SurfaceMeasure after;
  double seconds = 0;

  /// A line each, ended by '\n'.
  [[nodiscard]] std::string text() const;
};

/// Mends places where a surface folds over or passes through itself a little: faces around them are
/// smoothed or cut out, and the hole is filled anew (by CGAL, where it counts as
/// experimental). Shells that overlap are not made one: signs by winding number see their union as
/// they are.
///
/// Polygons become triangles; new ones have the patch of what is nearest. If it does not end with
/// fewer pairs than before, the soup is as it was, as it is if it throws. Not to be called while
/// other threads use CGAL, whose handlers of errors it replaces meanwhile.
/// @throws Error(Topology) unless the surface is oriented and manifold, open or closed, or if CGAL
/// fails; Error(Limit) for more than `mostPairs`; Error(Argument) for rounds or seconds that are
/// not positive, and for a soup that does not pass PolygonSoup::validate().
SelfIntersectionRepairReport removeSelfIntersections(
    PolygonSoup& soup, const SelfIntersectionRepairOptions& options = {});

}  // namespace cutwater
