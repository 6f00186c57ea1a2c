#pragma once

#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Mesh/Detail/TriangleSurfaceSDF.hpp>
#include <Cutwater/Surface/DcelMesh.hpp>

#include <memory>

namespace cutwater {

/// A closed DCEL mesh as a signed distance function without a tree: every query tests every face.
///
/// For small meshes, and as the plain definition of MeshSDF's results: both return the same values
/// to the bit. Faces may be polygons of any size.
template <std::floating_point T>
class DcelSDF final : public TriangleSurfaceSDF<T> {
 public:
  /// Patches that have no name in the mesh are called "surface".
  /// @throws Error(Topology) with a one-line report unless the mesh, once its shells are oriented,
  /// is closed: along each edge, as many faces run one way as the other; Error(Argument) for a
  /// patch id from 2^20 on without a name.
  explicit DcelSDF(DcelMesh<T> mesh);

  [[nodiscard]] const DcelMesh<T>& mesh() const { return *mesh_; }

 private:
  typename TriangleSurface<T>::Nearest nearest(const Vec3<T>& p) const override;
  void along(const Segment<double>& segment, TriangleVisitor visit) const override;
  BoxOverlap overlapWith(const OrientedBox<double>& box, std::uint32_t& place) const override;
  void around(const OrientedBox<double>& box, double limit, TriangleVisitor visit) const override;
  // Never called: the surface is closed.
  bool isSurrounded(const Vec3<T>&) const override { return false; }
  bool isDecided(const Box<double>&) const override { return true; }
  std::vector<std::string> localPatchNames() const override { return patchNames_; }

  std::shared_ptr<const DcelMesh<T>> mesh_;
  std::vector<std::string> patchNames_;
  Block block_;
};

extern template class DcelSDF<float>;
extern template class DcelSDF<double>;

}  // namespace cutwater
