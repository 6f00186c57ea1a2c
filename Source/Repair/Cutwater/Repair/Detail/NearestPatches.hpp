#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater::detail {

/// Range of distances of points and middles of faces from another surface.
struct DistanceRange {
  double least = 0;
  double greatest = 0;
};

/// Gives every polygon the patch of the point on `original` nearest to its middle, and returns the
/// distances of the polygons from `original`. Points and polygons are unchanged.
DistanceRange takeNearestPatches(PolygonSoup& soup, const PolygonSoup& original);

}  // namespace cutwater::detail
