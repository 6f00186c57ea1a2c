#pragma once

#include <Cutwater/Mesh/PolygonSoup.hpp>

// Private: not installed.

namespace cutwater::detail {

/// How far points of faces and their middles are from another surface.
struct DistanceRange {
  double least = 0;
  double greatest = 0;
};

/// Gives every polygon the patch of what is nearest to its middle on `original`, and tells how far
/// the polygons are from that. Points and polygons stay.
DistanceRange takeNearestPatches(PolygonSoup& soup, const PolygonSoup& original);

}  // namespace cutwater::detail
