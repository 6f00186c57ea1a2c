#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Segment.hpp>
#include <Cutwater/Mesh/TriangleSurface.hpp>

namespace cutwater {

/// Is shown ids of triangles (the list ends at the first kNone, if there is one); answers how far
/// along the segment, from 0 to 1, others are still wanted.
using TriangleVisitor = FunctionRef<double(std::span<const std::uint32_t>)>;

/// Shows at least all triangles that the segment meets, each once: through a tree, or simply all.
using TrianglesAlong = FunctionRef<void(const Segment<double>&, TriangleVisitor)>;

/// Where a point lies relative to a closed surface, without error.
struct SurfaceLocation {
  /// How often the surface surrounds the point: the sum over its shells, cavities negative. On the
  /// surface, that of a point beside it.
  int winding = 0;
  bool onSurface = false;

  /// What overlaps counts once, and the surface itself counts as outside.
  [[nodiscard]] bool isInside() const { return winding >= 1 && !onSurface; }
};

/// The sum of the directions in which the segment passes the surface's triangles: of a closed
/// surface the winding number at its start less that at its end. Exact.
template <std::floating_point T>
[[nodiscard]] int windingAlong(const TriangleSurface<T>& surface, const Segment<double>& segment,
                               TrianglesAlong along);

/// Counts passages of the surface along an axis-parallel segment from the point to the nearest side
/// of the surface's box, outward ones as 1, inward ones as -1: exact predicates on the original
/// coordinates, so that no point is too close to an edge. The point is in the surface's units.
template <std::floating_point T>
[[nodiscard]] SurfaceLocation locate(const TriangleSurface<T>& surface, const Vec3<double>& point,
                                     TrianglesAlong along);

/// The shortest axis-parallel segment from a point within the box that ends outside of it.
[[nodiscard]] Segment<double> exitOf(const Box<double>& box, const Vec3<double>& point);

/// Visits the triangles that the segment passes, with passage()'s direction; see there for edges
/// and vertices in its way. `visit(id, direction)` answers as a TriangleVisitor.
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
