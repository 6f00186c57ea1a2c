#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <optional>
#include <string>

namespace cutwater {

/// Options of wrap(); lengths in the units of the surface.
struct WrapOptions {
  /// Holes, gaps and hollows that a ball of this diameter cannot pass are closed (a length).
  /// Smaller details are lost.
  double gap = 0;
  /// Distance of the wrap outside the surface (a length); nothing: a thirtieth of the gap.
  std::optional<double> offset = {};
  /// If more than about this many triangles are expected, the surface is refused before work
  /// begins.
  std::size_t mostTriangles = 50'000'000;
  double seconds = 600;
  /// The fraction is that of the triangles expected.
  Progress progress = {};
};

/// What wrap() is expected to take.
struct WrapEstimate {
  double gap = 0;        ///< that it is of
  double triangles = 0;  ///< of the wrap
  double seconds = 0;

  /// The least gap that takes about so long, with two digits; times grow with 1 / gap^2.
  [[nodiscard]] double gapWithin(double seconds) const;

  double secondsAtOnce = 0;  ///< of `seconds`, what any gap takes
};

/// Estimates wrap(soup, options) from wraps with wider gaps, which have some thousand triangles.
/// Takes a second or two, more for surfaces of millions of triangles. `options.mostTriangles` is
/// ignored. Docs/repair.md has the errors that were measured.
/// @throws Error as wrap(); of kind Limit if even these take longer than `options.seconds`.
[[nodiscard]] WrapEstimate estimateWrap(const PolygonSoup& soup, const WrapOptions& options);

/// What wrap() did.
struct WrapReport {
  std::size_t facesBefore = 0;
  std::size_t facesAfter = 0;
  double offset = 0;  ///< a length
  /// The least and greatest distance of the wrap's points and of the middles of its faces from the
  /// surface; the greatest occurs in the middle of a part that was closed.
  double nearest = 0;
  double farthest = 0;
  SurfaceMeasure before;
  SurfaceMeasure after;
  double seconds = 0;

  /// One finding per line, each ending with '\n'.
  [[nodiscard]] std::string text() const;
};

/// Replaces any soup, whatever its holes, cracks, overlaps, randomly oriented faces or panels
/// without thickness, by a watertight surface around it. The wrap is closed, oriented, manifold and
/// free of self-intersections, and encloses every face. Its points are about the offset away from
/// the faces, except where it spans openings narrower than the gap (Portaneri et al., "Alpha
/// wrapping with an offset", 2022; by CGAL, the gap is twice its alpha). Hollows that cannot be
/// reached from outside are filled.
///
/// Faces get the patch that is nearest to them. Size and distance from the origin do not matter: it
/// works on coordinates of magnitude about 1. Time and memory grow with area / gap^2.
///
/// If it throws, the soup is unchanged. Do not call while other threads use CGAL, whose error
/// handlers it replaces meanwhile.
/// @throws Error(Argument) unless gap, offset and seconds are positive, gap and offset finite, and
/// for a soup that does not pass PolygonSoup::validate(); Error(Topology) if there are no faces or
/// CGAL fails; Error(Limit) if it would be too large, the offset is lost in rounding, or the time
/// is up.
WrapReport wrap(PolygonSoup& soup, const WrapOptions& options);

}  // namespace cutwater
