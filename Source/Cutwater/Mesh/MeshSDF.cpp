#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Mesh/SoundnessCheck.hpp>
#include <Cutwater/Mesh/TriangleSurfaceData.hpp>

namespace cutwater {

template <std::floating_point T>
MeshSDF<T>::MeshSDF(const PolygonSoup& soup, const MeshSDFOptions& options)
    : MeshSDF(DcelMesh<T>(soup), options) {}

template <std::floating_point T>
MeshSDF<T>::MeshSDF(const DcelMesh<T>& mesh, const MeshSDFOptions& options) {
  const TriangleSurfaceData<T> data(mesh);
  const auto boxes = data.triangleBoxes();
  const auto tree = buildBvh<Tree::kArity, Tree::kLeafWidth>(boxes);
  std::string names;
  for (const auto& name : mesh.patchNames()) names += name + '\0';

  BlockWriter writer;
  const auto sections = data.addTo(writer);
  const auto nodes = writer.add(tree.nodes);
  const auto slots = writer.add(tree.slots);
  const auto nameBytes = writer.add(std::span<const char>(names));
  block_ = writer.finish();

  this->setSurface(sections.view(block_));
  tree_ = Tree(tree.frame, block_.array<BvhNode<Tree::kArity>>(nodes),
               block_.array<std::uint32_t>(slots));
  patchNames_ = block_.array<char>(nameBytes);
  const auto signs = checkSigns<T>(this->surface(), data, this->search(), options);
  if (options.requireWatertight && !signs.isSound()) {
    throw Error(ErrorKind::Topology, "the surface does not bound a solid: " + signs.summary() +
                                         "; " + check(mesh).summary());
  }
  this->setSigns(signs);
}

template <std::floating_point T>
auto MeshSDF<T>::nearest(const Vec3<T>& p) const -> typename TriangleSurface<T>::Nearest {
  const auto& surface = this->surface();
  auto best = surface.nothing(p);
  tree_.nearest(Vec3<double>(p), std::numeric_limits<double>::max(), double{best.error},
                [&](std::span<const std::uint32_t> slots) {
                  surface.compete(p, slots, best);
                  return std::sqrt(double{best.hit.distanceSquared});
                });
  return best;
}

template <std::floating_point T>
void MeshSDF<T>::along(const Segment<double>& segment, TriangleVisitor visit) const {
  tree_.along(segment, visit);
}

template <std::floating_point T>
bool MeshSDF<T>::isSurrounded(const Vec3<T>&) const {
  return false;
}

template <std::floating_point T>
std::vector<std::string> MeshSDF<T>::localPatchNames() const {
  std::vector<std::string> names;
  for (auto rest = patchNames_; !rest.empty(); rest = rest.subspan(names.back().size() + 1)) {
    names.emplace_back(rest.data());
  }
  return names;
}

template class MeshSDF<float>;
template class MeshSDF<double>;

}  // namespace cutwater
