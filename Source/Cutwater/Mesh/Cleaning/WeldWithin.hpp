#pragma once

#include <Cutwater/Mesh/Cleaning/CleanReport.hpp>

namespace cutwater {

/// Merges points that are within `tolerance` (a length) of one another.
///
/// In their order, a point joins the first of those that stay within the tolerance, and if there is
/// none, it stays itself, where it is. So no point moves by more than the tolerance, chains of
/// close points do not contract, those that stay are farther apart than that, and welding again
/// changes nothing. The tolerance is to be well below the length of the edges that matter: shorter
/// ones vanish. Faces may be left with repeated corners; see removeDegenerateFaces().
///
/// Near linear time, by a grid of cells of twice the tolerance. The correction tells the points
/// merged away and how far the farthest of them was moved.
/// @throws Error(Argument) unless 0 < tolerance < infinity, or for a point that is not finite.
Correction weldWithin(PolygonSoup& soup, double tolerance);

}  // namespace cutwater
