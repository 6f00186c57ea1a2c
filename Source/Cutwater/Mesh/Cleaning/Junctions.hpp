#pragma once

#include <Cutwater/Mesh/Cleaning/CleanReport.hpp>

namespace cutwater {

/// Closes cracks where surfaces were meshed each for itself: a point of one rim that lies on an
/// edge of another rim, or comes within `tolerance` (a length) of it, becomes part of that edge (a
/// T-junction no more). Triangles with the edge are cut, larger polygons get another corner; no
/// point moves.
///
/// A rim's edges are those with an odd number of faces. A point is put into an edge only if it is
/// farther than the tolerance from both of its ends, and nearer to each than they are to each
/// other. Weld first: what is closer is one point.
///
/// The correction counts points put into edges, with the distance of the farthest. n log n for n
/// corners.
/// @throws Error(Argument) unless 0 < tolerance < infinity.
Correction splitJunctions(PolygonSoup& soup, double tolerance);

}  // namespace cutwater
