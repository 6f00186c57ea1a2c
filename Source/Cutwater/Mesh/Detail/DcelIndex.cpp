#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Detail/DcelIndex.hpp>
#include <Cutwater/Mesh/Detail/SoundnessCheck.hpp>
#include <Cutwater/Surface/Detail/ContactSearch.hpp>
#include <Cutwater/Surface/Detail/PatchNames.hpp>
#include <Cutwater/Surface/MeshReport.hpp>

namespace cutwater {

template <std::floating_point T>
DcelIndex<T>::DcelIndex(DcelMesh<T> mesh)
    : mesh_(std::move(mesh)), patchNames_(detail::patchNamesOf(mesh_)) {
  const TriangleSurfaceArrays<T> arrays(mesh_);
  if (!arrays.openEdges().empty()) {
    throw Error(ErrorKind::Topology,
                "the surface is not closed and consistently oriented: " + check(mesh_).summary());
  }
  BlockWriter writer;
  const auto sections = arrays.addTo(writer);
  block_ = writer.finish();
  this->setSurface(sections.view(block_));
  const MeshSDFOptions options;
  const auto contacts = [&] { return findContacts<T>(arrays.positions(), arrays.triangles()); };
  this->setSigns(checkSigns<T>(surface(), arrays, trianglesAlong(), options, contacts),
                 options.signs);
}

template <std::floating_point T>
auto DcelIndex<T>::nearest(const Vec3<T>& p) const -> Nearest {
  auto best = surface().nothing(p);
  for (std::uint32_t id = 0; id < surface().triangles.size(); ++id) {
    surface().compete(p, {&id, 1}, best);
  }
  return best;
}

template <std::floating_point T>
void DcelIndex<T>::nearest(std::span<const Vec3<T>> points, std::span<Nearest> nearest) const {
  for (std::size_t i = 0; i < points.size(); ++i) nearest[i] = this->nearest(points[i]);
}

template <std::floating_point T>
BoxOverlap DcelIndex<T>::overlapWith(const OrientedBox<double>& box,
                                     std::uint32_t& /*place*/) const {
  const QueryBox query(box);
  auto result = BoxOverlap::None;
  for (std::uint32_t id = 0; id < surface().triangles.size(); ++id) {
    result = query.overlapWith(surface().corners(id), result);
    if (result == BoxOverlap::Certain) break;
  }
  return result;
}

template <std::floating_point T>
void DcelIndex<T>::around(const OrientedBox<double>& /*box*/, double /*limit*/,
                          TriangleVisitor visit) const {
  for (std::uint32_t id = 0; id < surface().triangles.size(); ++id) {
    if (visit({&id, 1}) <= 0) return;
  }
}

template class DcelIndex<float>;
template class DcelIndex<double>;

}  // namespace cutwater
