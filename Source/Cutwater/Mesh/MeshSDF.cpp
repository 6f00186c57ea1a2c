#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Detail/SoundnessCheck.hpp>
#include <Cutwater/Mesh/Detail/TriangleSurfaceArrays.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Detail/PatchNames.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Triangles/Search/BoxSearch.hpp>

#include <atomic>
#include <cmath>

namespace cutwater {

namespace {

/// Joins the names, each terminated by a zero.
std::string joined(std::span<const std::string> names) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    require(names[i].find('\0') == std::string::npos, "MeshSDF: a patch name contains a zero",
            Named{"patch", i});
    result += names[i] + '\0';
  }
  return result;
}

/// The surface's triangles between points in the mesh's own units.
template <std::floating_point T>
PolygonSoup trianglesOf(const TriangleSurface<T>& surface, std::span<const Vec3<T>> positions) {
  PolygonSoup soup;
  soup.points.reserve(positions.size());
  for (const auto& p : positions) soup.points.emplace_back(p);
  for (std::uint32_t id = 0; id < surface.triangles.size(); ++id) {
    soup.addPolygon(surface.triangles[id], surface.owner(id).patch);
  }
  return soup;
}

}  // namespace

template <std::floating_point T>
MeshSDF<T>::MeshSDF(const PolygonSoup& soup, const MeshSDFOptions& options) : options_(options) {
  std::string names;
  const auto data = [&] {
    const DcelMesh<T> mesh(soup);  // needed only here
    names = joined(detail::patchNamesOf(mesh));
    return TriangleSurfaceArrays<T>(mesh);
  }();
  build(data, buildTriangleTree(data.positions(), data.triangles()), names,
        [&] { return check(DcelMesh<T>(soup)).summary(); });
}

template <std::floating_point T>
MeshSDF<T>::MeshSDF(const DcelMesh<T>& mesh, const MeshSDFOptions& options) : options_(options) {
  const TriangleSurfaceArrays<T> data(mesh);
  build(data, buildTriangleTree(data.positions(), data.triangles()),
        joined(detail::patchNamesOf(mesh)), [&] { return check(mesh).summary(); });
}

template <std::floating_point T>
MeshSDF<T> MeshSDF<T>::refitted(std::span<const Vec3<T>> positions) const {
  const auto& surface = this->surface();
  require(positions.size() == surface.positions.size(),
          "refitted: need one position for each vertex", Named{"positions", positions.size()},
          Named{"vertices", surface.positions.size()});
  for (std::size_t i = 0; i < positions.size(); ++i) {
    require(std::isfinite(lengthSquared(Vec3<double>(positions[i]))),
            "refitted: need finite coordinates with finite squares", Named{"vertex", i},
            Named{"position", positions[i]});
  }
  MeshSDF result;
  result.options_ = options_;
  result.setPlacement(this->placement());
  const auto insideOut = block_.array<std::uint32_t>(layout_.insideOut);
  const TriangleSurfaceArrays<T> data(surface, this->signReport(), insideOut, positions);
  result.build(data, refittedTriangleTree(tree_, data.positions(), data.triangles()),
               block_.array<char>(layout_.patchNames),
               [&] { return check(DcelMesh<T>(trianglesOf(surface, positions))).summary(); });
  return result;
}

template <std::floating_point T>
void MeshSDF<T>::build(const TriangleSurfaceArrays<T>& data, const TriangleTreeArrays& tree,
                       std::span<const char> patchNames, FunctionRef<std::string()> defects) {
  const auto packets = packTriangles(data.positions(), data.triangles(), tree.tree());
  const auto hulls = buildHulls(data.positions(), data.triangles(), tree.tree());
  const bool needsWinding =
      !data.openEdges().empty() && options_.signs != SignScheme::NearestFeature;
  const auto winding = needsWinding ? CappedWindingArrays(data.positions(), data.openEdges())
                                    : CappedWindingArrays();

  BlockWriter writer;
  MeshLayout<T> layout;  // sections in the order of visitArrays()
  layout.surface = data.addTo(writer);
  layout.nodes = writer.add(tree.nodes);
  layout.slots = writer.add(tree.slots);
  layout.frame = tree.frame;
  layout.depth = tree.depth;
  layout.packets = writer.add(packets);
  layout.hulls = writer.add(hulls.hulls);
  layout.hullsOfNode = writer.add(hulls.ofNode);
  layout.winding = winding.addTo(writer);
  layout.reach = winding.reach();
  layout.insideOut = writer.add(data.orientation().insideOut);
  layout.patchNames = writer.add(patchNames);
  takeBlock(writer.finish(), layout);

  checkSurface(data, needsWinding);
  if (options_.requireWatertight && !this->signReport().isSound()) {
    throw Error(ErrorKind::Topology, "the surface does not bound a solid: " +
                                         this->signReport().summary() + "; " + defects());
  }
}

template <std::floating_point T>
void MeshSDF<T>::takeBlock(Block block, const MeshLayout<T>& layout) {
  block_ = std::move(block);
  layout_ = layout;
  this->setSurface(layout.surface.view(block_), layout.reach);
  tree_ = layout.tree(block_);
  search_ = TriangleSearch(tree_, block_.array<TrianglePacket>(layout.packets),
                           block_.array<ChildHulls>(layout.hulls),
                           block_.array<std::uint32_t>(layout.hullsOfNode));
  winding_ = layout.winding.view(block_);
}

template <std::floating_point T>
void MeshSDF<T>::checkSurface(const TriangleSurfaceArrays<T>& data, bool needsWinding) {
  auto signs = checkSigns<T>(this->surface(), data, this->search(), options_.probes);
  if (needsWinding) probeAmbiguity(options_.probes, signs);
  if (options_.findSelfIntersections) {
    signs.selfIntersections =
        findSelfIntersections<T>(data.positions(), data.triangles(), tree_).pairs.count;
  }
  this->setSigns(signs, options_.signs);
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
  return nearestWithin(p, TriangleSearch::kAnywhere);
}

template <std::floating_point T>
auto MeshSDF<T>::nearestWithin(const Vec3<T>& p, double reach) const -> Nearest {
  auto best = this->surface().nothing(p);
  search_.nearest(this->surface(), p, best, reach);
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
BoxOverlap MeshSDF<T>::overlapWith(const OrientedBox<double>& box, std::uint32_t& place) const {
  return overlapOf(search_, this->surface(), box, place);
}

template <std::floating_point T>
void MeshSDF<T>::around(const OrientedBox<double>& box, double limit, TriangleVisitor visit) const {
  tree_.nearest(box, limit, visit);
}

template <std::floating_point T>
bool MeshSDF<T>::isSurrounded(const Vec3<T>& p) const {
  return winding_.isInside(this->surface(), this->search(), Vec3<double>(p));
}

template <std::floating_point T>
bool MeshSDF<T>::isDecided(const Box<double>& box) const {
  return winding_.isDecided(this->surface(), this->search(), box);
}

template <std::floating_point T>
std::vector<std::string> MeshSDF<T>::localPatchNames() const {
  std::vector<std::string> names;
  for (auto rest = block_.array<char>(layout_.patchNames); !rest.empty();
       rest = rest.subspan(names.back().size() + 1)) {
    names.emplace_back(rest.data());
  }
  return names;
}

template <std::floating_point T>
PolygonSoup MeshSDF<T>::soup() const {
  const auto& surface = this->surface();
  std::vector<Vec3<T>> positions;
  positions.reserve(surface.positions.size());
  for (const auto& p : surface.positions) positions.push_back(p / surface.scale);
  auto soup = trianglesOf<T>(surface, positions);
  soup.patchNames = localPatchNames();
  return soup;
}

template class MeshSDF<float>;
template class MeshSDF<double>;

}  // namespace cutwater
