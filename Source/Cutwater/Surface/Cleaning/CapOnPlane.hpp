#pragma once

#include <Cutwater/Surface/Cleaning/Openings.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater {

/// Options of capOnPlane().
struct CapOptions {
  /// Points at most this far from the plane count as on it (a length).
  double tolerance = 0;
  /// The patch of the caps; an existing patch of this name is extended. In a soup whose patches
  /// have no names, the others are called "surface" from then on.
  std::string patch = "cap";
};

/// Closes openings in a plane: half models at their plane of symmetry, inlets and outlets of ducts.
///
/// Every rim whose points all lie on the plane is filled with triangles between its points,
/// oriented consistently with the adjacent faces; no point moves. A rim within another that runs
/// the other way round leaves a hole in the cap, as for an annulus or a cavity that is cut open.
/// Rims that meet themselves or one another in the plane, with everything within them, and rims
/// that continue outside the plane are left as they are and reported. Rims follow from the
/// orientation of faces: run clean() first. findRims() and planeOf() find planes that have rims; a
/// plane at a side of the model is at PolygonSoup::boundingBox(), not at that of a MeshSDF, which
/// reaches beyond an open surface.
///
/// @throws Error(Argument) for a plane or tolerance that is not finite, a zero normal, or a soup
/// that does not pass PolygonSoup::validate(). The soup is then unchanged.
OpeningReport capOnPlane(PolygonSoup& soup, const SurfacePlane& plane,
                         const CapOptions& options = {});

}  // namespace cutwater
