#pragma once

#include <Cutwater/Mesh/PolygonSoup.hpp>
#include <Cutwater/Mesh/SurfaceMeasure.hpp>

#include <optional>
#include <string>

namespace cutwater {

/// Options of wrap(); lengths in the units of the surface.
struct WrapOptions {
  /// Holes, gaps and hollows that a ball of this diameter does not pass are closed (a length).
  /// Details below it are lost.
  double gap = 0;
  /// How far the wrap is outside of the surface (a length); nothing: a thirtieth of the gap.
  std::optional<double> offset = {};
  /// More than about so many triangles are refused before work begins.
  std::size_t mostTriangles = 50'000'000;
  double seconds = 600;
};

/// What wrap() did.
struct WrapReport {
  std::size_t facesBefore = 0;
  std::size_t facesAfter = 0;
  double offset = 0;  ///< a length
  /// The least and greatest distance from the surface of the wrap's points and the middles of its
  /// faces; the latter is in the middle of what was closed.
  double nearest = 0;
  double farthest = 0;
  SurfaceMeasure before;
  SurfaceMeasure after;
  double seconds = 0;

  /// A line each, ended by '\n'.
  [[nodiscard]] std::string text() const;
};

/// Puts a watertight surface around anything: holes, cracks, overlaps, faces turned at random,
/// panels without thickness. The wrap is closed, oriented, manifold and free of self-intersections,
/// it encloses every face, and its points are about the offset away from them, but where it spans
/// what is narrower than the gap (Portaneri et al., "Alpha wrapping with an offset", 2022; by CGAL,
/// the gap is twice its alpha). Hollows that nothing leads into from outside are filled.
///
/// Faces have the patch of what is nearest to them. Sizes and distances from the origin do not
/// matter: it works on coordinates about 1 in size. Time and memory grow with area / gap^2.
///
/// If it throws, the soup is as it was. Not to be called while other threads use CGAL, whose
/// handlers of errors it replaces meanwhile.
/// @throws Error(Argument) unless gap, offset and seconds are positive, gap and offset finite, and
/// for a soup that does not pass PolygonSoup::validate(); Error(Topology) if there are no faces or
/// CGAL fails; Error(Limit) if it would be too large, the offset is lost in rounding, or the time
/// is up.
WrapReport wrap(PolygonSoup& soup, const WrapOptions& options);

}  // namespace cutwater
