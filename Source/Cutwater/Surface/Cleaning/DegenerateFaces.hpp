#pragma once

#include <Cutwater/Surface/Cleaning/CleanReport.hpp>

namespace cutwater {

/// Removes faces without area or without three distinct corners, and corners that repeat another.
///
/// This opens nothing: along every edge, the number of polygons that run one way minus that of
/// those that run the other way stays the same. A corner that repeats the one before is removed,
/// and so is a spike (a b a). A polygon that passes a corner twice becomes triangles. The corners
/// of a face without area lie on a line; its longer edges are passed to and fro, and the faces
/// across them get the corners in between: the neighbour of a needle is cut in two at the needle's
/// third corner.
///
/// Whether a face has area is decided as by check(): exactly, except for a rounding of 2^-98 of the
/// product of its sides. The correction counts faces that were removed or lost corners.
///
/// Corners must be indices of points. At most n log n for n corners, times the number of needles
/// that lean on one another.
Correction removeDegenerateFaces(PolygonSoup& soup);

}  // namespace cutwater
