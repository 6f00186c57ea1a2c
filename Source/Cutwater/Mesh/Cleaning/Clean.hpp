#pragma once

#include <Cutwater/Mesh/Cleaning/CleanReport.hpp>
#include <Cutwater/Mesh/Cleaning/DuplicateFaces.hpp>
#include <Cutwater/Mesh/Shells.hpp>

#include <optional>

namespace cutwater {

/// What clean() does beside what is always done. Tolerances are lengths.
struct CleanOptions {
  /// Merge points within this of one another, see weldWithin(); nothing: equal ones only.
  std::optional<double> weldWithin = {};
  /// Put points of rims into the edges of others within this, see splitJunctions(); nothing: none.
  std::optional<double> splitJunctionsWithin = {};
  /// Two equal faces of opposite orientation. Models of vehicles have panels of no thickness that
  /// are made of such pairs: they are walls of the flow, and signs do not depend on them.
  OppositeFaces opposite = OppositeFaces::Keep;
  /// Turn faces outward.
  bool orient = true;
  /// How shells within shells are turned.
  NestedShells nested = NestedShells::AsTheyAre;
};

/// Puts a surface in order, each step a function of its own: merges points (weldExactly(), and
/// weldWithin() on request), removes degenerate and duplicate faces, puts points of T-junctions
/// into edges on request, removes unused points, and turns faces outward. With T-junctions, these
/// and the faces are looked at again until nothing more is found. Cleaning a clean surface changes
/// nothing (polygons that are far from plane aside: turned, they may enclose another volume).
///
/// No point moves but to where another is, and only within `weldWithin`. What was closed stays
/// closed, unless duplicates or cancelled pairs had a part in it. Holes are not filled, nor
/// self-intersections removed. The result does not depend on the number of threads; n log n for n
/// corners.
///
/// If it throws, the soup is as it was.
/// @throws Error(Argument) for tolerances that are not positive and finite, and for soups that do
/// not pass PolygonSoup::validate(); Error(Limit) beyond 2^32 - 2 corners.
CleanReport clean(PolygonSoup& soup, const CleanOptions& options = {});

}  // namespace cutwater
