#pragma once

#include <Cutwater/Bvh/BvhTree.hpp>
#include <Cutwater/Mesh/TriangleSurfaceSDF.hpp>

namespace cutwater {

/// A closed, consistently oriented surface mesh as a signed distance function over a LinearBVH.
///
/// Exact: the value is within 8 eps (|p| + |V|max) of the distance to the mesh rounded to T, and
/// does not depend on the tree. The sign is that of the pseudonormal of the nearest feature; where
/// sheets come so close that two features tie within rounding it may be that of the other. Shells
/// that are inside out are turned; shells within shells count as their orientation says.
///
/// closestPoint() tells the polygon of the soup (face), its patch, and barycentrics that refer to
/// `triangle(id)`. Copies share one read-only block of memory.
template <std::floating_point T>
class MeshSDF final : public TriangleSurfaceSDF<T> {
 public:
  /// @throws Error(Topology) with a one-line report unless the surface is closed and consistently
  /// oriented; what DcelMesh throws for a soup that is none.
  explicit MeshSDF(const PolygonSoup& soup);
  explicit MeshSDF(const DcelMesh<T>& mesh);

  /// Bytes of the block that queries use.
  [[nodiscard]] std::size_t memoryBytes() const { return block_.bytes().size(); }

 private:
  using Tree = BvhTree<16, 4>;

  [[nodiscard]] typename TriangleSurface<T>::Nearest nearest(const Vec3<T>& p) const override;
  [[nodiscard]] std::vector<std::string> localPatchNames() const override;

  Block block_;
  Tree tree_;
  std::span<const char> patchNames_;  // each ended by a zero
};

extern template class MeshSDF<float>;
extern template class MeshSDF<double>;

}  // namespace cutwater
