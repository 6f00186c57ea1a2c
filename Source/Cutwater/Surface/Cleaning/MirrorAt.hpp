#pragma once

#include <Cutwater/Surface/Cleaning/Openings.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater {

/// Completes a half model: adds its mirror image at the plane.
///
/// Points at most `tolerance` (a length) from the plane are moved onto it and shared by both
/// halves. Faces with all of their points there, such as a cap, are removed, as they would divide
/// the whole, and so are points that no face uses then. The mirrored faces are turned, so they face
/// outward as well, and keep their patches. Exact for planes perpendicular to an axis, except for
/// the rounding of 2 c - x.
///
/// In the report, `closed` stays empty; `rimEdges` counts the edges at which the halves join.
/// @throws Error(Topology) if points of faces lie on both sides of the plane; Error(Argument) as
/// capOnPlane(). The soup is then unchanged.
OpeningReport mirrorAt(PolygonSoup& soup, const SurfacePlane& plane, double tolerance = 0);

}  // namespace cutwater
