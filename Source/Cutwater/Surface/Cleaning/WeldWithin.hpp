#pragma once

#include <Cutwater/Surface/Cleaning/CleanReport.hpp>

namespace cutwater {

/// Merges points that are within `tolerance` (a length) of one another.
///
/// Points are processed in order: each joins the first of the kept points within the tolerance, or,
/// if there is none, is kept where it is. So no point moves by more than the tolerance, chains of
/// close points do not contract, kept points are farther apart than the tolerance, and welding
/// again changes nothing. The tolerance should be well below the length of the edges that matter:
/// shorter ones vanish. Faces may be left with repeated corners; see removeDegenerateFaces().
///
/// Near-linear time, with a grid of cells of twice the tolerance. The correction counts the points
/// merged away and holds how far the farthest of them moved.
/// @throws Error(Argument) unless 0 < tolerance < infinity, or for a point that is not finite.
Correction weldWithin(PolygonSoup& soup, double tolerance);

}  // namespace cutwater
