#pragma once

#include <Cutwater/Mesh/TriangleSurfaceSDF.hpp>

#include <memory>

namespace cutwater {

/// A DCEL mesh as a signed distance function without a tree: every query tries every face.
///
/// For small meshes, and as the plain definition of what MeshSDF answers: the same values to the
/// bit. Faces may be polygons of any size.
template <std::floating_point T>
class DcelSDF final : public TriangleSurfaceSDF<T> {
 public:
  /// @throws Error(Topology) with a one-line report unless the mesh is closed and consistently
  /// oriented.
  explicit DcelSDF(DcelMesh<T> mesh);

  [[nodiscard]] const DcelMesh<T>& mesh() const { return *mesh_; }

 private:
  [[nodiscard]] typename TriangleSurface<T>::Nearest nearest(const Vec3<T>& p) const override;
  [[nodiscard]] std::vector<std::string> localPatchNames() const override;

  std::shared_ptr<const DcelMesh<T>> mesh_;
  Block block_;
};

extern template class DcelSDF<float>;
extern template class DcelSDF<double>;

}  // namespace cutwater
