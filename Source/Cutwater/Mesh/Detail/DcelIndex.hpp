#pragma once

#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Mesh/Detail/CappedWinding.hpp>
#include <Cutwater/Mesh/Detail/SignedSurface.hpp>
#include <Cutwater/Surface/DcelMesh.hpp>
#include <Cutwater/Triangles/QueryBox.hpp>

namespace cutwater {

/// The plain counterpart of MeshIndex, behind a DcelSDF: the same searches, by their definitions.
/// Each looks at every triangle. Only for closed surfaces.
template <std::floating_point T>
class DcelIndex final : public SignedSurface<T> {
 public:
  using typename SignedSurface<T>::Nearest;
  using SignedSurface<T>::surface;

  /// @throws as the constructor of DcelSDF.
  explicit DcelIndex(DcelMesh<T> mesh);

  [[nodiscard]] const DcelMesh<T>& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<std::string>& patchNames() const { return patchNames_; }

  // See MeshIndex.
  [[nodiscard]] Nearest nearest(const Vec3<T>& p) const;
  [[nodiscard]] Nearest nearestWithin(const Vec3<T>& p, double /*reach*/) const {
    return nearest(p);
  }
  void nearest(std::span<const Vec3<T>> points, std::span<Nearest> nearest) const;
  void nearestWithin(std::span<const Vec3<T>> points, std::span<Nearest> nearest,
                     double /*reach*/) const {
    this->nearest(points, nearest);
  }
  [[nodiscard]] auto trianglesAlong() const {
    return [this](const Segment<double>& /*segment*/, TriangleVisitor visit) {
      for (std::uint32_t id = 0; id < surface().triangles.size(); ++id) visit({&id, 1});
    };
  }
  [[nodiscard]] BoxOverlap overlapWith(const OrientedBox<double>& box, std::uint32_t& place) const;
  void around(const OrientedBox<double>& box, double limit, TriangleVisitor visit) const;
  [[nodiscard]] std::optional<int> windingBeside(const Vec3<T>& /*p*/,
                                                 const Nearest& /*nearest*/) const {
    return {};
  }
  // Never asked: the surface is closed.
  [[nodiscard]] bool isSurrounded(const Vec3<T>& /*p*/, const Nearest& /*nearest*/) const {
    return false;
  }
  [[nodiscard]] bool isDecided(const Box<double>& /*box*/) const { return true; }
  [[nodiscard]] bool isSteady(const Box<double>& /*box*/) const { return true; }
  [[nodiscard]] std::optional<int> leastInside(const Box<double>& /*box*/) const { return 1; }
  [[nodiscard]] const CappedWinding* winding() const { return nullptr; }

 private:
  DcelMesh<T> mesh_;
  std::vector<std::string> patchNames_;
  Block block_;
};

extern template class DcelIndex<float>;
extern template class DcelIndex<double>;

}  // namespace cutwater
