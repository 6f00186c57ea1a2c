#pragma once

#include <Cutwater/Mesh/Cleaning/Openings.hpp>
#include <Cutwater/Mesh/PolygonSoup.hpp>

namespace cutwater {

/// Makes a whole of a half model: adds its mirror image at the plane.
///
/// Points at most `tolerance` (a length) from the plane are moved onto it and shared by both
/// halves; faces all of whose points are there, such as a cap, are removed, as they would divide
/// the whole, and so are points that no face has then. The mirrored faces are turned, so that they
/// face outward as well, and keep their patches. Exact for planes across an axis, but for the
/// rounding of 2 c - x.
///
/// Of the report, `closed` stays empty; `rimEdges` counts the edges at which the halves join.
/// @throws Error(Topology) if there are points of faces on both sides of the plane;
/// Error(Argument) as capOnPlane(). The soup is then as it was.
OpeningReport mirrorAt(PolygonSoup& soup, const SurfacePlane& plane, double tolerance = 0);

}  // namespace cutwater
