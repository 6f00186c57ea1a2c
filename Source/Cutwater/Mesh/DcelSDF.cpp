#include <Cutwater/Mesh/DcelSDF.hpp>

namespace cutwater {

template <std::floating_point T>
DcelSDF<T>::DcelSDF(DcelMesh<T> mesh)
    : mesh_(std::make_shared<const DcelMesh<T>>(std::move(mesh))) {
  const TriangleSurfaceData<T> data(*mesh_);
  BlockWriter writer;
  const auto sections = data.addTo(writer);
  block_ = writer.finish();
  this->setSurface(sections.view(block_), data.turnedShells());
}

template <std::floating_point T>
auto DcelSDF<T>::nearest(const Vec3<T>& p) const -> typename TriangleSurface<T>::Nearest {
  const auto& surface = this->surface();
  typename TriangleSurface<T>::Nearest best;
  for (std::uint32_t id = 0; id < surface.triangles.size(); ++id) {
    surface.compete(p, {&id, 1}, best);
  }
  return best;
}

template <std::floating_point T>
std::vector<std::string> DcelSDF<T>::localPatchNames() const {
  return {mesh_->patchNames().begin(), mesh_->patchNames().end()};
}

template class DcelSDF<float>;
template class DcelSDF<double>;

}  // namespace cutwater
