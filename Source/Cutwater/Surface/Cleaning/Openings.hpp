#pragma once

#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <string>

namespace cutwater {

/// A plane through a point; the normal need not have unit length.
struct SurfacePlane {
  Vec3<double> point;
  Vec3<double> normal;
};

/// What capOnPlane(), mirrorAt(), extendTo() or extendToBox() did. Look at it: a plane that no rim
/// lies on closes nothing, and is no error.
struct [[nodiscard]] OpeningReport {
  Findings<Vec3<double>> closed;  ///< openings: a point of the rim of each
  /// Rims in the plane that were left as they are, because they meet themselves or one another or
  /// continue outside the plane: a point of each.
  Findings<Vec3<double>> left;
  std::size_t rimEdges = 0;     ///< of the openings that are closed now
  std::size_t pointsMoved = 0;  ///< onto the plane
  double farthestMove = 0;      ///< a length
  std::size_t facesRemoved = 0;
  std::size_t facesAdded = 0;
  double areaAdded = 0;  ///< of those
  SurfaceMeasure before;
  SurfaceMeasure after;

  /// The results that apply, one line each, ended by '\n'.
  [[nodiscard]] std::string text() const;
};

}  // namespace cutwater
