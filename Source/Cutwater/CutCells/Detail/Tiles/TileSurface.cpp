#include <Cutwater/CutCells/Detail/Tiles/TileSurface.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

bool isUnderPlane(const Fragment& fragment, const FragmentEdge& plane) {
  return fragment.cell[asIndex(plane.axis)] < plane.number;
}

/// The node of lowest indices at which the planes of two edges, and the cell, begin.
TilePlace placeOnPlanes(const Fragment& fragment, const FragmentEdge& a, const FragmentEdge& b) {
  auto place = fragment.cell;
  place[asIndex(a.axis)] = a.number;
  place[asIndex(b.axis)] = b.number;
  return place;
}

/// The rise of the winding number along the third axis where the fragment's edges lie on two
/// planes.
int riseAt(const Fragment& fragment, const FragmentEdge& in, const FragmentEdge& out) {
  // A polygon that faces up goes up along the plane that limits it in x, then back along the one
  // that limits it in y; the other way round beyond either of them.
  const bool isCyclic = (in.axis + 1) % 3 == out.axis;
  const bool facesUp = (isCyclic == isUnderPlane(fragment, in)) == isUnderPlane(fragment, out);
  return facesUp ? -1 : 1;
}

/// The order of items by a number below `count`, and of equal ones as they are.
template <typename Item, typename Key>
std::vector<std::uint32_t> orderedBy(std::span<const Item> items, std::uint32_t count, Key key) {
  std::vector<std::uint32_t> first(count + 1);
  for (const auto& item : items) ++first[item.*key + 1];
  for (std::uint32_t n = 0; n < count; ++n) first[n + 1] += first[n];
  std::vector<std::uint32_t> order(items.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) order[first[items[i].*key]++] = i;
  return order;
}

template <typename Item>
std::vector<Item> permuted(const std::vector<Item>& items, std::span<const std::uint32_t> order) {
  std::vector<Item> result;
  result.reserve(items.size());
  for (const auto i : order) result.push_back(items[i]);
  return result;
}

}  // namespace

TileSurface::TileSurface(const MovedSurface& surface, std::span<const std::uint32_t> patches,
                         std::span<const std::uint32_t> triangles, const GridPlanes& planes,
                         std::span<const SheetKind> kinds, std::span<const OpenKind> openKinds)
    : surface_(surface),
      numbers_(planes.sizes()),
      patches_(patches),
      kinds_(kinds),
      openKinds_(openKinds) {
  // Twice what fine meshes have, as growing costs more.
  fragments_.reserve(2 * triangles.size());
  points_.reserve(8 * triangles.size());
  meshEdges_.reserve(8 * triangles.size());
  traces_.reserve(2 * triangles.size());
  below_.reserve(2 * triangles.size());
  TriangleSplitter splitter(planes);
  for (const auto id : triangles) {
    if (isBaffle(id)) {
      splitBaffle(id, planes, splitter);
      continue;
    }
    splitter.split(surface.triangle(id), surface.corners(id),
                   [&](const Fragment& fragment) { add(id, fragment); });
  }
  sort();
  if (!kinds_.empty()) sortBuried();
}

std::span<const EdgeCrossing> TileSurface::crossingsOf(std::uint32_t edge) const {
  return sortedUnder(std::span(crossings_), edge, &EdgeCrossing::edge);
}

/// Moved both ways along each axis across which it touches a plane.
void TileSurface::splitBaffle(std::uint32_t triangle, const GridPlanes& planes,
                              TriangleSplitter& splitter) {
  auto vertices = surface_.triangle(triangle);
  unsigned touching = 0;  // a bit for each axis
  for (int axis = 0; axis < 3; ++axis) {
    const auto& across = planes.positions[asIndex(axis)];
    for (const auto& vertex : vertices) {
      const bool touches = std::binary_search(across.begin(), across.end(), vertex.position[axis]);
      touching |= (touches ? 1U : 0U) << static_cast<unsigned>(axis);
    }
  }
  for (unsigned up = 0; up < 8; ++up) {
    if ((up & ~touching) != 0) continue;
    for (auto& vertex : vertices) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        vertex.shift[axis] = (up >> axis & 1U) != 0 ? 1 : -1;
      }
    }
    splitter.split(vertices, surface_.corners(triangle), [&](const Fragment& fragment) {
      add(triangle, fragment);
      addOutline(triangle, fragment, planes);
    });
  }
}

/// If it lies in a face of its cell.
void TileSurface::addOutline(std::uint32_t triangle, const Fragment& fragment,
                             const GridPlanes& planes) {
  const auto corners = cornersOf(triangle);
  for (int axis = 0; axis < 3; ++axis) {
    if (!lieAcross(corners, axis)) continue;
    const double at = corners[0][axis];
    for (const int side : {0, 1}) {
      auto place = fragment.cell;
      place[asIndex(axis)] += side;
      if (planes.at(axis, place[asIndex(axis)]) != at) continue;
      const auto size = static_cast<std::size_t>(fragment.size);
      for (std::size_t i = 0; i < size; ++i) {
        traces_.push_back({.face = numbers_.face(axis, place),
                           .triangle = triangle,
                           .from = fragment.points[i],
                           .to = fragment.points[(i + 1) % size],
                           .start = {},
                           .end = {}});
      }
    }
  }
}

void TileSurface::add(std::uint32_t triangle, const Fragment& fragment) {
  const auto size = static_cast<std::size_t>(fragment.size);
  auto& fragments = kindOf(triangle) == SheetKind::Buried ? buriedFragments_ : fragments_;
  fragments.push_back({numbers_.cell(fragment.cell), triangle,
                       static_cast<std::uint32_t>(points_.size()),
                       static_cast<std::uint32_t>(size)});
  for (std::size_t i = 0; i < size; ++i) {
    const auto& edge = fragment.edges[i];
    points_.push_back(fragment.points[i]);
    meshEdges_.push_back(edge.isPlane() ? kNone : surface_.edges(triangle)[asIndex(edge.number)]);
    if (edge.isPlane()) addTrace(triangle, fragment, i);
  }
}

/// Whether the fragment's cell is the one that gives what lies in this plane: above it, if it has a
/// cell there.
bool TileSurface::isOwner(const Fragment& fragment, const FragmentEdge& plane) const {
  const auto axis = asIndex(plane.axis);
  return fragment.cell[axis] == std::min(plane.number, numbers_.cells()[axis] - 1);
}

/// That of the last fragment's side on a plane, and the crossing where it begins, if it does at
/// another one.
void TileSurface::addTrace(std::uint32_t triangle, const Fragment& fragment, std::size_t side) {
  const bool isBuried = kindOf(triangle) == SheetKind::Buried;
  const auto number =
      static_cast<std::uint32_t>((isBuried ? buriedFragments_ : fragments_).size() - 1);
  const auto size = static_cast<std::size_t>(fragment.size);
  const auto& edge = fragment.edges[side];
  const auto face = numbers_.face(edge.axis, placeOnPlanes(fragment, edge, edge));
  if (!isOwner(fragment, edge)) {
    if (!isBuried) below_.push_back({face, triangle, number});
    return;
  }
  const auto end = [&](const FragmentEdge& other) {
    if (!other.isPlane()) {
      return TraceEnd{.meshEdge = surface_.edges(triangle)[asIndex(other.number)]};
    }
    return TraceEnd{.gridEdge = numbers_.edge(3 - edge.axis - other.axis,
                                              placeOnPlanes(fragment, edge, other))};
  };
  const auto& before = fragment.edges[side > 0 ? side - 1 : size - 1];
  const auto next = side + 1 < size ? side + 1 : 0;
  FaceTrace trace{.face = face,
                  .triangle = triangle,
                  .from = fragment.points[side],
                  .to = fragment.points[next],
                  .start = end(before),
                  .end = end(fragment.edges[next])};
  if (before.isPlane() && isOwner(fragment, before)) {
    const int axis = 3 - edge.axis - before.axis;
    EdgeCrossing crossing{trace.start.gridEdge, triangle, fragment.points[side][axis]};
    if (isBaffle(triangle)) {
      baffleCrossings_.push_back(crossing);
    } else {
      crossing.rise = riseAt(fragment, before, edge);
      crossings_.push_back(crossing);
    }
  }
  if (isUnderPlane(fragment, edge)) {
    trace.below = number;
  } else {
    trace.above = number;
    std::swap(trace.from, trace.to);
    std::swap(trace.start, trace.end);
  }
  (isBuried ? buriedTraces_ : traces_).push_back(trace);
}

void TileSurface::sort() {
  // All are in the order of triangles so far.
  const auto order =
      orderedBy(std::span(std::as_const(fragments_)), numbers_.cellCount(), &TileFragment::cell);
  std::vector<std::uint32_t> numberOf(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) numberOf[order[i]] = i;
  fragments_ = permuted(fragments_, order);
  sortTraces(numberOf);
  crossings_ = permuted(crossings_, orderedBy(std::span(std::as_const(crossings_)),
                                              numbers_.edgeCount(), &EdgeCrossing::edge));
}

/// Numbers fragments anew.
void TileSurface::sortTraces(std::span<const std::uint32_t> numberOf) {
  const auto hasFragment = [](const FaceTrace& trace) {
    return trace.below != kNone || trace.above != kNone;
  };
  std::vector<FaceTrace> traces;
  traces.reserve(traces_.size());
  for (const auto i :
       orderedBy(std::span(std::as_const(traces_)), numbers_.faceCount(), &FaceTrace::face)) {
    auto trace = traces_[i];
    if (trace.below != kNone) trace.below = numberOf[trace.below];
    if (trace.above != kNone) trace.above = numberOf[trace.above];
    if (!traces.empty() && traces.back().face == trace.face &&
        traces.back().triangle == trace.triangle && hasFragment(trace) &&
        hasFragment(traces.back())) {  // of a baffle, moved one way and the other
      traces.back().below = std::min(traces.back().below, trace.below);
      traces.back().above = std::min(traces.back().above, trace.above);
    } else {
      traces.push_back(trace);
    }
  }
  traces_ = std::move(traces);

  auto trace = traces_.begin();
  for (const auto i :
       orderedBy(std::span(std::as_const(below_)), numbers_.faceCount(), &FragmentBelow::face)) {
    const auto& [face, triangle, fragment] = below_[i];
    while (trace->face != face || trace->triangle != triangle || !hasFragment(*trace)) ++trace;
    trace->below = std::min(trace->below, numberOf[fragment]);
  }
  below_ = {};
}

/// As the others; who has a fragment does not matter.
void TileSurface::sortBuried() {
  std::ranges::stable_sort(buriedFragments_, {}, &TileFragment::cell);
  const auto key = [](const FaceTrace& trace) { return std::pair(trace.face, trace.triangle); };
  std::ranges::stable_sort(buriedTraces_, {}, key);
  const auto isSame = [&](const FaceTrace& a, const FaceTrace& b) { return key(a) == key(b); };
  buriedTraces_.erase(std::unique(buriedTraces_.begin(), buriedTraces_.end(), isSame),
                      buriedTraces_.end());
}

}  // namespace cutwater
