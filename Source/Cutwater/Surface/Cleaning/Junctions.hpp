#pragma once

#include <Cutwater/Surface/Cleaning/CleanReport.hpp>

namespace cutwater {

/// Closes cracks between surfaces that were meshed separately: a point of one rim that lies on an
/// edge of another rim, or within `tolerance` (a length) of it, becomes part of that edge, so it is
/// no longer a T-junction. Triangles with the edge are cut, larger polygons get another corner; no
/// point moves.
///
/// A rim consists of edges with an odd number of faces. A point is inserted into an edge only if it
/// is farther than the tolerance from both of its ends, and nearer to each than they are to each
/// other. Weld first, so that closer points are one.
///
/// The correction counts the points inserted, with the distance of the farthest. n log n for n
/// corners.
/// @throws Error(Argument) unless 0 < tolerance < infinity.
Correction splitJunctions(PolygonSoup& soup, double tolerance);

}  // namespace cutwater
