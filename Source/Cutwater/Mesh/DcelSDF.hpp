#pragma once

#include <Cutwater/Mesh/MeshFunction.hpp>
#include <Cutwater/Surface/DcelMesh.hpp>

namespace cutwater {

/// A closed DCEL mesh as a signed distance function without a tree: every query tests every face.
///
/// For small meshes, and as the plain definition of MeshSDF's results: both return the same values
/// to the bit. Faces may be polygons of any size.
template <std::floating_point T>
class DcelSDF final : public MeshFunction<T, DcelIndex<T>> {
 public:
  /// Patches that have no name in the mesh are called "surface".
  /// @throws Error(Topology) with a one-line report unless the mesh, once its shells are oriented,
  /// is closed: along each edge, as many faces run one way as the other; Error(Argument) for a
  /// patch id from 2^20 on without a name.
  explicit DcelSDF(DcelMesh<T> mesh);

  /// The mesh as it was given.
  [[nodiscard]] const DcelMesh<T>& mesh() const;
};

extern template class DcelSDF<float>;
extern template class DcelSDF<double>;

}  // namespace cutwater
