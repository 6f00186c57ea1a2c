#pragma once

#include <Cutwater/Surface/Cleaning/CleanReport.hpp>
#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>

#include <optional>

namespace cutwater {

/// What clean() does besides the steps that are always taken. Tolerances are lengths.
struct CleanOptions {
  /// Merge points within this of one another, see weldWithin(); if empty, only equal ones.
  std::optional<double> weldWithin = {};
  /// Insert points of rims into edges of others within this, see splitJunctions(); if empty, none.
  std::optional<double> splitJunctionsWithin = {};
  /// Treatment of equal faces with opposite orientations. Models of vehicles have panels of no
  /// thickness made of such pairs: they are walls of the flow, and signs do not depend on them.
  OppositeFaces opposite = OppositeFaces::Keep;
  /// Turn faces outward.
  bool orient = true;
  /// How shells within shells are oriented.
  NestedShells nested = NestedShells::AsTheyAre;
};

/// Cleans a surface, in steps that are also functions of their own: merges points (weldExactly(),
/// and weldWithin() on request), removes degenerate and duplicate faces, inserts points of
/// T-junctions into edges on request, removes unused points, and turns faces outward. With
/// T-junctions, these and the faces are examined again until nothing more is found. Cleaning a
/// clean surface changes nothing (except polygons that are far from planar: turned, they may
/// enclose another volume).
///
/// A point moves only to the place of another, and only within `weldWithin`. What was closed stays
/// closed, unless duplicates or cancelled pairs were part of it. Holes are not filled, nor
/// self-intersections removed. The result does not depend on the number of threads; n log n for n
/// corners.
///
/// If it throws, the soup is unchanged.
/// @throws Error(Argument) for tolerances that are not positive and finite, and for soups that do
/// not pass PolygonSoup::validate(); Error(Limit) beyond 2^32 - 2 corners.
CleanReport clean(PolygonSoup& soup, const CleanOptions& options = {});

}  // namespace cutwater
