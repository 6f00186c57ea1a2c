#pragma once

#include <Cutwater/Surface/Cleaning/CleanReport.hpp>

namespace cutwater {

/// The treatment of two faces with the same corners and opposite orientations.
enum class OppositeFaces : std::uint8_t {
  Cancel,  ///< both are removed: together they bound nothing
  Keep,    ///< both stay: sheets of no thickness, such as baffles with a face on either side
};

/// Removes faces with the same cycle of corners and the same orientation as an earlier face.
///
/// Orientations may still be wrong. So of two faces with opposite orientations, the later one is a
/// duplicate, too, if more than half of their edges have an odd number of faces: the surface needs
/// one of them there. Where it needs none or both, see cancelOppositeFaces().
///
/// Polygons with repeated corners are skipped: see removeDegenerateFaces(). n log n for n corners,
/// times the number of duplicates of that kind that lie side by side.
Correction removeDuplicateFaces(PolygonSoup& soup);

/// Removes pairs of faces with the same cycle of corners and opposite orientations; both faces are
/// counted. Of several equal faces, the last ones are removed first. Skips the same polygons;
/// linear time.
Correction cancelOppositeFaces(PolygonSoup& soup);

}  // namespace cutwater
