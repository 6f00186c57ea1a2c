#pragma once

#include <Cutwater/Mesh/PassageWalk.hpp>

namespace cutwater {

/// A mesh as its crossings are found; all in the surface's scaled units.
template <std::floating_point T>
struct MeshField {
  const TriangleSurface<T>& surface;
  TrianglesAlong along;
  FunctionRef<typename TriangleSurface<T>::Nearest(const Vec3<T>&)> nearest;
  /// Whether the function is negative.
  FunctionRef<bool(const Vec3<T>&)> isInside;
  /// Whether the sign certainly changes nowhere in the box but at triangles.
  FunctionRef<bool(const Box<double>&)> isJumpFree;
  bool isClosed = true;
};

/// Where the function's sign changes along the segment, in order; points and normals in the mesh's
/// own units. An odd number exactly if the signs at the ends differ.
///
/// Of a closed surface all are found: passages through triangles are exact and move the winding
/// number by one. A surface that is not closed has others away from its triangles, on the sheets
/// that close its holes; they are isolated by bounds of the winding number's gradient, down to a
/// 256th of the stretch between triangles; what cannot be excluded is counted as unresolved.
template <std::floating_point T>
CrossingCount meshCrossings(const MeshField<T>& field, const Segment<T>& segment,
                            CrossingVisitor<T> visit);

extern template CrossingCount meshCrossings(const MeshField<float>&, const Segment<float>&,
                                            CrossingVisitor<float>);
extern template CrossingCount meshCrossings(const MeshField<double>&, const Segment<double>&,
                                            CrossingVisitor<double>);

}  // namespace cutwater
