#include <Cutwater/Mesh/Detail/MeshIndex.hpp>
#include <Cutwater/Mesh/Detail/SoundnessCheck.hpp>
#include <Cutwater/Surface/Detail/ContactSearch.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace cutwater {

namespace {

/// Whether signs depend on the winding number of an open surface.
template <std::floating_point T>
bool needsWinding(const TriangleSurfaceArrays<T>& arrays, const MeshSDFOptions& options) {
  return !arrays.openEdges().empty() && options.signs != SignScheme::NearestFeature;
}

/// For each triangle, whether a corner has moved, in scaled units, in which they are compared.
template <std::floating_point T>
std::vector<std::uint8_t> changedTriangles(const TriangleSurface<T>& before,
                                           const TriangleSurface<T>& after) {
  std::vector<std::uint8_t> changed(after.triangles.size());
  for (std::size_t t = 0; t < changed.size(); ++t) {
    const auto hasMoved = [&](auto v) { return before.positions[v] != after.positions[v]; };
    changed[t] = std::ranges::any_of(after.triangles[t], hasMoved) ? 1 : 0;
  }
  return changed;
}

}  // namespace

template <std::floating_point T>
MeshIndex<T>::MeshIndex(Block block, const MeshLayout<T>& layout, const SignReport& signs,
                        const MeshSDFOptions& options)
    : options_(options) {
  take(std::move(block), layout);
  this->setSigns(signs, signs.scheme);
}

template <std::floating_point T>
MeshIndex<T>::MeshIndex(const TriangleSurfaceArrays<T>& arrays, const TriangleTreeArrays& tree,
                        std::span<const char> patchNames, const MeshSDFOptions& options,
                        const MeshIndex* before)
    : options_(options) {
  fill(arrays, tree, patchNames, before);
}

template <std::floating_point T>
void MeshIndex<T>::fill(const TriangleSurfaceArrays<T>& arrays, const TriangleTreeArrays& tree,
                        std::span<const char> patchNames, const MeshIndex* before) {
  const auto packets = packTriangles(arrays.positions(), arrays.triangles(), tree.tree());
  const auto hulls = buildHulls(arrays.positions(), arrays.triangles(), tree.tree());
  const auto winding = needsWinding(arrays, options_)
                           ? CappedWindingArrays(arrays.positions(), arrays.openEdges())
                           : CappedWindingArrays();
  BlockWriter writer;
  MeshLayout<T> layout;  // sections in the order of visitArrays()
  layout.surface = arrays.addTo(writer);
  layout.nodes = writer.add(tree.nodes);
  layout.slots = writer.add(tree.slots);
  layout.frame = tree.frame;
  layout.depth = tree.depth;
  layout.packets = writer.add(packets);
  layout.hulls = writer.add(hulls.hulls);
  layout.hullsOfNode = writer.add(hulls.ofNode);
  layout.winding = winding.addTo(writer);
  layout.reach = winding.reach();
  layout.insideOut = writer.add(arrays.orientation().insideOut);
  layout.patchNames = writer.add(patchNames);
  layout.fronts = layout.signCells = writer.add(std::span<const std::uint8_t>());
  take(writer.finish(), layout);
  auto signs = checkSigns<T>(surface(), arrays, trianglesAlong(), options_,
                             [&] { return contacts(before); });
  if (needsWinding(arrays, options_)) probeAmbiguity(signs);
  this->setSigns(signs, options_.signs);
  if (this->signs().scheme != SignScheme::WindingNumber || !options_.findSelfIntersections) return;
  const auto fronts = frontWindings();
  layout.fronts = writer.add(fronts);
  const auto cells = signs.isClosed() ? std::vector<std::uint8_t>() : bytesOfSignCells();
  layout.signCells = writer.add(cells);
  take(writer.finish(), layout);
  this->setSigns(signs, options_.signs);
}

template <std::floating_point T>
void MeshIndex<T>::take(Block block, const MeshLayout<T>& layout) {
  block_ = std::move(block);
  layout_ = layout;
  this->setSurface(layout.surface.view(block_), layout.reach);
  tree_ = layout.tree(block_);
  search_ = TriangleSearch(tree_, block_.array<TrianglePacket>(layout.packets),
                           block_.array<ChildHulls>(layout.hulls),
                           block_.array<std::uint32_t>(layout.hullsOfNode));
  winding_ = layout.winding.view(block_);
  fronts_ = FrontWindings(block_.array<std::uint8_t>(layout.fronts));
  signCells_ = SignCells(surface().box, surface().triangles.size(),
                         block_.array<std::uint8_t>(layout.signCells));
}

template <std::floating_point T>
SurfaceContacts MeshIndex<T>::contacts(const MeshIndex* before) const {
  const auto find = [&](std::span<const std::uint8_t> changed) {
    return findContacts<T>(surface().positions, surface().triangles, tree_, changed);
  };
  if (before == nullptr || !before->signs().isProven) return find({});
  const auto changed = changedTriangles(before->surface(), surface());
  const auto count = static_cast<std::size_t>(std::ranges::count(changed, 1));
  // Triangles that have not moved overlap as little as before. Where only these touch, either side
  // bounds the solid if the other does, as before: so their edges need no marks.
  return 2 * count > changed.size() ? find({}) : find(changed);
}

template <std::floating_point T>
int MeshIndex<T>::windingAlong(const Segment<double>& segment) const {
  return cutwater::windingAlong(surface(), segment, trianglesAlong()) + winding_.capsAlong(segment);
}

template <std::floating_point T>
std::vector<std::uint8_t> MeshIndex<T>::frontWindings() const {
  const auto winding = [this](const Vec3<double>& p) {
    return winding_.closedWinding(surface(), trianglesAlong(), p);
  };
  return findFrontWindings<T>(
      surface(), tree_, winding_.caps(),
      {[this](const Vec3<T>& p) { return nearest(p); }, winding,
       [this](const Segment<double>& segment) { return windingAlong(segment); }});
}

template <std::floating_point T>
std::vector<std::uint8_t> MeshIndex<T>::bytesOfSignCells() const {
  // Where there is a hole almost everywhere, little could be known, and it would take long.
  constexpr std::size_t kFewest = 8;  // triangles for each cap
  if (kFewest * winding_.caps().triangles.size() > surface().triangles.size()) return {};
  const auto mayHoldTriangle = [this](const Box<double>& box) {
    std::uint32_t place = 0;
    return overlapWith(OrientedBox<double>::of(box), place) != BoxOverlap::None;
  };
  return findSignCells(
      signCells_,
      {mayHoldTriangle, [this](const Box<double>& box) { return winding_.mayHoldCap(box); },
       [this](const Box<double>& box) { return winding_.leastInside(box); },
       [this](const Vec3<double>& p) {
         return winding_.closedWinding(surface(), trianglesAlong(), p);
       }});
}

template <std::floating_point T>
std::optional<int> MeshIndex<T>::windingBeside(const Vec3<T>& p, const Nearest& nearest) const {
  const Vec3<double> q(p);
  if (const auto beside = fronts_.beside(nearest)) {
    const double distance = std::sqrt(double{nearest.distanceSquared}) + double{nearest.error};
    if (signCells_.isFarFromCaps(q, distance) || winding_.isFarFromCaps(q, distance)) {
      return beside;
    }
    const auto [a, b, c] = surface().corners(nearest.triangle);
    const Triangle<double> triangle{a, b, c, isSliver(a, b, c)};
    const auto weights = closestBarycentric(q, triangle, triangleDistance(q, triangle).part);
    return *beside + winding_.capsAlong({q, weights.x * a + weights.y * b + weights.z * c});
  }
  const auto before = fronts_.before(nearest.triangle);
  if (!before || nearest.distanceSquared <= nearest.error * nearest.error) return {};
  return *before +
         windingAlong({q, FrontWindings::pointBefore(surface().corners(nearest.triangle))});
}

template <std::floating_point T>
bool MeshIndex<T>::isSurrounded(const Vec3<T>& p, const Nearest& nearest) const {
  const Vec3<double> here(p);
  const auto cell = signCells_.at(here);
  if (cell.side() != 0) return cell.side() < 0;
  const bool mayBeWithin = surface().box.contains(here);
  const auto beside = mayBeWithin ? windingBeside(p, nearest) : std::optional(0);
  const auto winding = [&](const Vec3<double>& q) {
    return beside && q == here ? *beside : winding_.closedWinding(surface(), trianglesAlong(), q);
  };
  if (const auto least = cell.leastInside()) return winding(here) >= *least;
  return winding_.isInside(winding, here);
}

template <std::floating_point T>
void MeshIndex<T>::probeAmbiguity(SignReport& signs) const {
  constexpr double kAmbiguous = 0.1;
  std::atomic<std::size_t> ambiguous{0};
  const auto probe = [&](std::size_t i, TrianglesAlong metered) {
    Vec3<double> p = evenlySpread(i);
    for (int axis = 0; axis < 3; ++axis) {
      const double lower = surface().box.lower[axis];
      p[axis] = lower + p[axis] * (surface().box.upper[axis] - lower);
    }
    const double w = winding_.estimate(surface(), metered, p, kAmbiguous / 100).value;
    if (std::abs(w - std::round(w)) > kAmbiguous) ++ambiguous;
  };
  signs.probes = runProbes(options_.probes, surface().triangles.size(), trianglesAlong(), probe);
  signs.ambiguous = ambiguous;
}

template <std::floating_point T>
void MeshIndex<T>::nearest(std::span<const Vec3<T>> points, std::span<Nearest> nearest) const {
  for (std::size_t i = 0; i < points.size(); ++i) nearest[i] = surface().nothing(points[i]);
  search_.nearest(surface(), points, nearest);
}

template <std::floating_point T>
void MeshIndex<T>::nearestWithin(std::span<const Vec3<T>> points, std::span<Nearest> nearest,
                                 double reach) const {
  for (std::size_t i = 0; i < points.size(); ++i) nearest[i] = surface().nothing(points[i]);
  search_.nearest(surface(), points, nearest, reach);
}

template <std::floating_point T>
std::vector<std::string> MeshIndex<T>::patchNames() const {
  std::vector<std::string> names;
  for (auto rest = block_.array<char>(layout_.patchNames); !rest.empty();
       rest = rest.subspan(names.back().size() + 1)) {
    names.emplace_back(rest.data());
  }
  return names;
}

template class MeshIndex<float>;
template class MeshIndex<double>;

}  // namespace cutwater
