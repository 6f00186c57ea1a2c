#pragma once

#include <Cutwater/Mesh/Detail/CappedWinding.hpp>
#include <Cutwater/Mesh/Detail/PassageWalk.hpp>

namespace cutwater {

/// The functions of a mesh from which its crossings are found; all in the surface's scaled units.
template <std::floating_point T>
struct MeshField {
  const TriangleSurface<T>& surface;
  TrianglesAlong along;
  FunctionRef<typename TriangleSurface<T>::Nearest(const Vec3<T>&)> nearest;
  /// Whether the function is negative.
  FunctionRef<bool(const Vec3<T>&)> isInside;
  /// Decides signs if the surface is not closed; without it, pseudonormals do.
  const CappedWinding* winding = nullptr;
  bool isClosed = true;
};

/// A segment in the surface's scaled units.
template <std::floating_point T>
struct MeshSegment {
  Segment<T> ends;           ///< these differ; their signs are those of the whole segment's ends
  Segment<double> searched;  ///< the segment, or all of it that may have crossings
  /// Passages that are sought at once, at most PassageWalk::kBatch; changes no answer.
  std::size_t atOnce = 64;
};

/// Where the function's sign changes along the segment, in order: parameters of the part searched,
/// points and normals in the mesh's own units. Their number is odd if and only if the signs at the
/// ends differ.
///
/// Passages through triangles are exact. Each changes the winding number by one, so on a closed
/// surface, all crossings are found. A surface that is not closed has others away from its
/// triangles, on the sheets that close its holes. These are isolated by bounds on the winding
/// number's gradient, down to a 256th of the stretch between triangles; what cannot be excluded is
/// counted as unresolved. Where pseudonormals decide the sign, it is evaluated beside triangles, as
/// far away as rounding demands: of crossings closer to each other, at most one is found.
template <std::floating_point T>
CrossingCount meshCrossings(const MeshField<T>& field, const MeshSegment<T>& segment,
                            CrossingVisitor<T> visit);

extern template CrossingCount meshCrossings(const MeshField<float>&, const MeshSegment<float>&,
                                            CrossingVisitor<float>);
extern template CrossingCount meshCrossings(const MeshField<double>&, const MeshSegment<double>&,
                                            CrossingVisitor<double>);

}  // namespace cutwater
