#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Segment.hpp>
#include <Cutwater/Triangles/TriangleSurface.hpp>

namespace cutwater {

/// Receives ids of triangles (the list ends at the first kNone, if there is one) and returns how
/// far along the segment, from 0 to 1, further triangles are still wanted.
using TriangleVisitor = FunctionRef<double(std::span<const std::uint32_t>)>;

/// Passes at least all triangles that the segment meets to the visitor, each once: found with a
/// tree, or simply all triangles.
using TrianglesAlong = FunctionRef<void(const Segment<double>&, TriangleVisitor)>;

/// Where a point lies relative to a closed surface, determined without error.
struct SurfaceLocation {
  /// How often the surface winds around the point: the sum over its shells, cavities negative. For
  /// a point on the surface, the value of a point next to it.
  int winding = 0;
  bool onSurface = false;

  /// Overlaps count once, and the surface itself counts as outside.
  [[nodiscard]] bool isInside() const { return winding >= 1 && !onSurface; }
};

/// Sums the directions in which the segment passes through the surface's triangles: for a closed
/// surface, the winding number at its start minus that at its end. Exact.
template <std::floating_point T>
[[nodiscard]] int windingAlong(const TriangleSurface<T>& surface, const Segment<double>& segment,
                               TrianglesAlong along);

/// Counts the passages through the surface along an axis-parallel segment from the point to the
/// nearest side of the surface's box, outward ones as 1, inward ones as -1. Exact predicates work
/// on the original coordinates, so no point is too close to an edge. The point is in the surface's
/// units.
template <std::floating_point T>
[[nodiscard]] SurfaceLocation locate(const TriangleSurface<T>& surface, const Vec3<double>& point,
                                     TrianglesAlong along);

/// The shortest axis-parallel segment that leads from a point within the box to the outside.
[[nodiscard]] Segment<double> exitOf(const Box<double>& box, const Vec3<double>& point);

/// Visits the triangles that the segment passes through, with the direction from passage(); see
/// there for edges and vertices on the segment. `visit(id, direction)` returns what a
/// TriangleVisitor returns.
template <std::floating_point T>
void visitPassages(const TriangleSurface<T>& surface, const Segment<double>& segment,
                   TrianglesAlong along, FunctionRef<double(std::uint32_t, int)> visit);

#define CUTWATER_DECLARE(T)                                                              \
  extern template int windingAlong(const TriangleSurface<T>&, const Segment<double>&,    \
                                   TrianglesAlong);                                      \
  extern template SurfaceLocation locate(const TriangleSurface<T>&, const Vec3<double>&, \
                                         TrianglesAlong);                                \
  extern template void visitPassages(const TriangleSurface<T>&, const Segment<double>&,  \
                                     TrianglesAlong, FunctionRef<double(std::uint32_t, int)>);
CUTWATER_DECLARE(float)
CUTWATER_DECLARE(double)
#undef CUTWATER_DECLARE

}  // namespace cutwater
