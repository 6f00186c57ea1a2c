#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Mesh/SelfIntersections.hpp>
#include <Cutwater/Mesh/SoundnessCheck.hpp>
#include <Cutwater/Mesh/TriangleSurfaceData.hpp>

#include <atomic>
#include <cmath>

namespace cutwater {

template <std::floating_point T>
MeshSDF<T>::MeshSDF(const PolygonSoup& soup, const MeshSDFOptions& options)
    : MeshSDF(DcelMesh<T>(soup), options) {}

template <std::floating_point T>
MeshSDF<T>::MeshSDF(const DcelMesh<T>& mesh, const MeshSDFOptions& options) {
  const TriangleSurfaceData<T> data(mesh);
  const auto tree = buildTriangleTree(data.positions(), data.triangles());
  const auto packets = packTriangles(data.positions(), data.triangles(), tree.tree());
  std::string names;
  for (const auto& name : mesh.patchNames()) names += name + '\0';

  const bool needsWinding =
      !data.openEdges().empty() && options.signs != SignScheme::NearestFeature;
  const auto winding =
      needsWinding ? OpenWindingData(data.positions(), data.openEdges()) : OpenWindingData();

  BlockWriter writer;
  const auto sections = data.addTo(writer);
  const auto nodes = writer.add(tree.nodes);
  const auto slots = writer.add(tree.slots);
  const auto leaves = writer.add(packets);
  const auto windingSections = winding.addTo(writer);
  const auto nameBytes = writer.add(std::span<const char>(names));
  block_ = writer.finish();

  this->setSurface(sections.view(block_), winding.reach());
  const auto& surface = this->surface();
  tree_ = TriangleTree(tree.frame, block_.array<BvhNode<TriangleTree::kArity>>(nodes),
                       block_.array<std::uint32_t>(slots), tree.depth);
  search_ = TriangleSearch(tree_, block_.array<TrianglePacket>(leaves));
  winding_ = windingSections.view(block_);
  patchNames_ = block_.array<char>(nameBytes);
  auto signs = checkSigns<T>(surface, data, this->search(), options.probes);
  if (needsWinding) probeAmbiguity(options.probes, signs);
  if (options.findSelfIntersections) {
    signs.selfIntersections =
        findSelfIntersections<T>(data.positions(), data.triangles(), tree_).pairs.count;
  }
  this->setSigns(signs, options.signs);
  if (options.requireWatertight && !signs.isSound()) {
    throw Error(ErrorKind::Topology,
                "the surface does not bound a solid: " + this->signReport().summary() + "; " +
                    check(mesh).summary());
  }
}

template <std::floating_point T>
void MeshSDF<T>::probeAmbiguity(std::size_t count, SignReport& signs) const {
  constexpr double kAmbiguous = 0.1;
  const auto& surface = this->surface();
  std::atomic<std::size_t> ambiguous{0};
  signs.probes = runProbes(
      count, surface.triangles.size(), this->search(), [&](std::size_t i, TrianglesAlong metered) {
        Vec3<double> p = evenlySpread(i);
        for (int axis = 0; axis < 3; ++axis) {
          const double lower = surface.box.lower[axis];
          p[axis] = lower + p[axis] * (surface.box.upper[axis] - lower);
        }
        const double w = winding_.estimate(surface, metered, p, kAmbiguous / 100).value;
        if (std::abs(w - std::round(w)) > kAmbiguous) ++ambiguous;
      });
  signs.ambiguous = ambiguous;
}

template <std::floating_point T>
auto MeshSDF<T>::nearest(const Vec3<T>& p) const -> Nearest {
  auto best = this->surface().nothing(p);
  search_.nearest(this->surface(), p, best);
  return best;
}

template <std::floating_point T>
void MeshSDF<T>::nearest(std::span<const Vec3<T>> points, std::span<Nearest> nearest) const {
  for (std::size_t i = 0; i < points.size(); ++i) nearest[i] = this->surface().nothing(points[i]);
  search_.nearest(this->surface(), points, nearest);
}

template <std::floating_point T>
void MeshSDF<T>::along(const Segment<double>& segment, TriangleVisitor visit) const {
  tree_.along(segment, visit);
}

template <std::floating_point T>
bool MeshSDF<T>::isSurrounded(const Vec3<T>& p) const {
  return winding_.isInside(this->surface(), this->search(), Vec3<double>(p));
}

template <std::floating_point T>
bool MeshSDF<T>::isDecided(const Box<double>& box) const {
  const double change = 0.5 * box.diagonal() * winding_.gradientBound(box);
  if (!(change < 1)) return false;
  const auto atCenter = winding_.estimate(this->surface(), this->search(), box.center(), 0x1p-20);
  return std::abs(atCenter.value - OpenWinding::kThreshold) > change + atCenter.error;
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
