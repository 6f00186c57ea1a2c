#pragma once

#include <Cutwater/Mesh/PassageWalk.hpp>

namespace cutwater {

/// The functions of a mesh from which its crossings are found; all in the surface's scaled units.
template <std::floating_point T>
struct MeshField {
  const TriangleSurface<T>& surface;
  TrianglesAlong along;
  FunctionRef<typename TriangleSurface<T>::Nearest(const Vec3<T>&)> nearest;
  /// Whether the function is negative.
  FunctionRef<bool(const Vec3<T>&)> isInside;
  /// Whether the sign certainly does not change in the box except at triangles.
  FunctionRef<bool(const Box<double>&)> isJumpFree;
  bool isClosed = true;
};

/// Where the function's sign changes along the segment, in order; points and normals in the mesh's
/// own units. Their number is odd if and only if the signs at the ends differ.
///
/// On a closed surface, all are found: passages through triangles are exact and change the winding
/// number by one. A surface that is not closed has others away from its triangles, on the sheets
/// that close its holes. These are isolated by bounds on the winding number's gradient, down to a
/// 256th of the stretch between triangles; what cannot be excluded is counted as unresolved.
template <std::floating_point T>
CrossingCount meshCrossings(const MeshField<T>& field, const Segment<T>& segment,
                            CrossingVisitor<T> visit);

extern template CrossingCount meshCrossings(const MeshField<float>&, const Segment<float>&,
                                            CrossingVisitor<float>);
extern template CrossingCount meshCrossings(const MeshField<double>&, const Segment<double>&,
                                            CrossingVisitor<double>);

}  // namespace cutwater
