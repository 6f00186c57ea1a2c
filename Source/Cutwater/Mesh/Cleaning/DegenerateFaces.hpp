#pragma once

#include <Cutwater/Mesh/Cleaning/CleanReport.hpp>

namespace cutwater {

/// Removes faces without area and without three distinct corners, and corners that repeat another.
///
/// Nothing is opened by it: along every edge as many polygons run one way less those that run the
/// other as before. A corner that repeats the one before goes, and so does a spike (a b a). A
/// polygon that passes a corner twice becomes triangles. The corners of a face without area lie on
/// a line; its longer edges are passed to and fro, and the faces across them get the corners in
/// between: a needle's neighbour is cut in two at the needle's third corner.
///
/// Whether a face has area is decided as by check(): exactly, but for a rounding of 2^-98 of the
/// product of its sides. The correction counts what is gone or has fewer corners.
///
/// Needs corners that are points. n log n at most, n the number of corners, as often as needles
/// lean on one another.
Correction removeDegenerateFaces(PolygonSoup& soup);

}  // namespace cutwater
