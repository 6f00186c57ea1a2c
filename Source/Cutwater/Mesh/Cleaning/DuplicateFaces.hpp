#pragma once

#include <Cutwater/Mesh/Cleaning/CleanReport.hpp>

namespace cutwater {

/// What becomes of two faces with the same corners and opposite orientations.
enum class OppositeFaces : std::uint8_t {
  Cancel,  ///< both go: together they bound nothing
  Keep,    ///< both stay: sheets of no thickness, such as baffles with a face on either side
};

/// Removes faces with the same cycle of corners and the same orientation as an earlier face.
///
/// Orientations may be wrong yet, and so of two faces of opposite orientation the later one is a
/// duplicate, too, if more than half of their edges have an odd number of faces: the surface needs
/// one of them there. Where it needs none or both, see cancelOppositeFaces().
///
/// Polygons with repeated corners are passed over: see removeDegenerateFaces(). n log n for n
/// corners, as often as duplicates of that kind lie side by side.
Correction removeDuplicateFaces(PolygonSoup& soup);

/// Removes pairs of faces with the same cycle of corners and opposite orientations; both faces are
/// counted. Of several equal faces the last ones go first. As above, in linear time.
Correction cancelOppositeFaces(PolygonSoup& soup);

}  // namespace cutwater
