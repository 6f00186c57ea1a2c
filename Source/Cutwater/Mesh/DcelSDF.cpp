#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/Detail/SoundnessCheck.hpp>
#include <Cutwater/Mesh/Detail/TriangleSurfaceArrays.hpp>
#include <Cutwater/Surface/Detail/PatchNames.hpp>
#include <Cutwater/Surface/MeshReport.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
DcelSDF<T>::DcelSDF(DcelMesh<T> mesh)
    : mesh_(std::make_shared<const DcelMesh<T>>(std::move(mesh))),
      patchNames_(detail::patchNamesOf(*mesh_)) {
  const TriangleSurfaceArrays<T> data(*mesh_);
  if (!data.openEdges().empty()) {
    throw Error(ErrorKind::Topology,
                "the surface is not closed and consistently oriented: " + check(*mesh_).summary());
  }
  BlockWriter writer;
  const auto sections = data.addTo(writer);
  block_ = writer.finish();
  this->setSurface(sections.view(block_));
  const MeshSDFOptions options;
  const auto signs = checkSigns<T>(this->surface(), data, this->search(), options.probes);
  this->setSigns(signs, options.signs);
}

template <std::floating_point T>
auto DcelSDF<T>::nearest(const Vec3<T>& p) const -> typename TriangleSurface<T>::Nearest {
  const auto& surface = this->surface();
  auto best = surface.nothing(p);
  for (std::uint32_t id = 0; id < surface.triangles.size(); ++id) {
    surface.compete(p, {&id, 1}, best);
  }
  return best;
}

template <std::floating_point T>
void DcelSDF<T>::along(const Segment<double>&, TriangleVisitor visit) const {
  for (std::uint32_t id = 0; id < this->surface().triangles.size(); ++id) visit({&id, 1});
}

template <std::floating_point T>
BoxOverlap DcelSDF<T>::overlapWith(const OrientedBox<double>& box, std::uint32_t& /*place*/) const {
  const QueryBox query(box);
  auto result = BoxOverlap::None;
  for (std::uint32_t id = 0; id < this->surface().triangles.size(); ++id) {
    result = query.overlapWith(this->surface().corners(id), result);
    if (result == BoxOverlap::Certain) break;
  }
  return result;
}

template <std::floating_point T>
void DcelSDF<T>::around(const OrientedBox<double>&, double, TriangleVisitor visit) const {
  for (std::uint32_t id = 0; id < this->surface().triangles.size(); ++id) {
    if (visit({&id, 1}) <= 0) return;
  }
}

template class DcelSDF<float>;
template class DcelSDF<double>;

}  // namespace cutwater
