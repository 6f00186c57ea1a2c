#pragma once

#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/SurfaceMeasure.hpp>

namespace cutwater {

/// What one step of cleaning found and put right.
struct Correction {
  /// Where: the points, the middles of the faces, in the coordinates of the soup.
  Findings<Vec3<double>> places;
  /// A length: how far a point is from where it was or from the edge that it is now part of; how
  /// large a face is, that is, the diagonal of its box. 0 where there is none to speak of.
  double largest = 0;

  /// Counts one more.
  void add(const Vec3<double>& place, double size = 0) {
    places.add(place);
    if (size > largest) largest = size;
  }
  /// Appends what was found later.
  void add(const Correction& later) {
    places.add(later.places);
    if (later.largest > largest) largest = later.largest;
  }
  [[nodiscard]] explicit operator bool() const { return static_cast<bool>(places); }
};

/// What clean() puts right.
enum class CleanKind : std::uint8_t {
  EqualPoints,        ///< merged: the same coordinates as an earlier point
  ClosePoints,        ///< merged: closer to another than the tolerance
  DegenerateFaces,    ///< removed, or rid of repeated corners
  DuplicateFaces,     ///< removed: the same corners as an earlier face
  OppositeFaces,      ///< removed, both of a pair of opposite orientation
  Junctions,          ///< points put into the edges that they lie on
  UnusedPoints,       ///< removed: no face has them
  TurnedFaces,        ///< to agree with those around
  TurnedShells,       ///< as a whole; a face of each is the place
  UnorientableShells  ///< like a Moebius strip: not put right, only said
};

/// What was done, in the words of the report: "close points merged".
[[nodiscard]] const char* nameOf(CleanKind kind);

/// A step of clean(), with the size of the surface before and after it.
struct CleanStep {
  CleanKind kind{};
  Correction correction;
  SurfaceMeasure before;
  SurfaceMeasure after;
};

/// What clean() did, in order. Steps that found nothing are listed, too, as long as they ran.
struct CleanReport {
  std::vector<CleanStep> steps;

  /// Whether the soup is as it was.
  [[nodiscard]] bool changedNothing() const;
  /// How often something of this kind was found, in all steps.
  [[nodiscard]] std::size_t count(CleanKind kind) const;
  /// A line per step, each ended by '\n': how many, how large, what changed in area and volume, and
  /// the first places.
  [[nodiscard]] std::string text() const;
};

}  // namespace cutwater
