#pragma once

#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

namespace cutwater {

/// What one step of cleaning found and corrected.
struct Correction {
  /// Where: the points, or the middles of the faces, in the coordinates of the soup.
  Findings<Vec3<double>> places;
  /// A length: how far a point is from its old position or from the edge that it is now part of;
  /// for a face, its size, that is, the diagonal of its box. 0 if there is no such length.
  double largest = 0;

  /// Adds one finding.
  void add(const Vec3<double>& place, double size = 0) {
    places.add(place);
    if (size > largest) largest = size;
  }
  /// Appends later findings.
  void add(const Correction& later) {
    places.add(later.places);
    if (later.largest > largest) largest = later.largest;
  }
  [[nodiscard]] explicit operator bool() const { return static_cast<bool>(places); }
};

/// The kinds of corrections that clean() makes.
enum class CleanKind : std::uint8_t {
  EqualPoints,        ///< merged: the same coordinates as an earlier point
  ClosePoints,        ///< merged: closer to another than the tolerance
  DegenerateFaces,    ///< removed, or rid of repeated corners
  DuplicateFaces,     ///< removed: the same corners as an earlier face
  OppositeFaces,      ///< removed, both of a pair of opposite orientation
  Junctions,          ///< points inserted into the edges that they lie on
  UnusedPoints,       ///< removed: no face uses them
  TurnedFaces,        ///< turned to agree with their neighbours
  TurnedShells,       ///< turned as a whole; the place is a face of each
  UnorientableShells  ///< like a Moebius strip: reported, not corrected
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

/// What clean() did, in order. Steps that ran but found nothing are listed, too.
struct CleanReport {
  std::vector<CleanStep> steps;

  /// Whether the soup is unchanged.
  [[nodiscard]] bool changedNothing() const;
  /// The number of findings of this kind, in all steps.
  [[nodiscard]] std::size_t count(CleanKind kind) const;
  /// One line per step, each ended by '\n': how many, how large, the changes in area and volume,
  /// and the first places.
  [[nodiscard]] std::string text() const;
};

}  // namespace cutwater
