#include <Cutwater/CutCells/Detail/TileSurface.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace cutwater {

namespace {

bool isUnderPlane(const Fragment& fragment, const FragmentEdge& plane) {
  return fragment.cell[static_cast<std::size_t>(plane.axis)] < plane.number;
}

/// The node of lowest indices at which the planes of two edges, and the cell, begin.
TilePlace placeOnPlanes(const Fragment& fragment, const FragmentEdge& a, const FragmentEdge& b) {
  auto place = fragment.cell;
  place[static_cast<std::size_t>(a.axis)] = a.number;
  place[static_cast<std::size_t>(b.axis)] = b.number;
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

}  // namespace

TileSurface::TileSurface(const MovedSurface& surface, std::span<const std::uint32_t> patches,
                         std::span<const std::uint32_t> triangles, const GridPlanes& planes)
    : numbers_({planes.cells(0), planes.cells(1), planes.cells(2)}), patches_(patches) {
  for (const auto id : triangles) {
    splitTriangle(planes, surface.triangle(id), surface.corners(id),
                  [&](const Fragment& fragment) { add(surface, id, fragment); });
  }
  sort();
}

void TileSurface::add(const MovedSurface& surface, std::uint32_t triangle,
                      const Fragment& fragment) {
  const auto number = static_cast<std::uint32_t>(fragments_.size());
  const auto size = static_cast<std::size_t>(fragment.size);
  fragments_.push_back({numbers_.cell(fragment.cell), triangle,
                        static_cast<std::uint32_t>(points_.size()),
                        static_cast<std::uint32_t>(size)});
  const auto meshEdgeOf = [&](const FragmentEdge& edge) {
    return surface.edges(triangle)[static_cast<std::size_t>(edge.number)];
  };
  for (std::size_t i = 0; i < size; ++i) {
    const auto& edge = fragment.edges[i];
    points_.push_back(fragment.points[i]);
    meshEdges_.push_back(edge.isPlane() ? kNone : meshEdgeOf(edge));
    if (!edge.isPlane()) continue;

    const auto end = [&](const FragmentEdge& other) {
      if (!other.isPlane()) return TraceEnd{.meshEdge = meshEdgeOf(other)};
      return TraceEnd{.gridEdge = numbers_.edge(3 - edge.axis - other.axis,
                                                placeOnPlanes(fragment, edge, other))};
    };
    const auto& before = fragment.edges[(i + size - 1) % size];
    const auto& after = fragment.edges[(i + 1) % size];
    FaceTrace trace{.face = numbers_.face(edge.axis, placeOnPlanes(fragment, edge, edge)),
                    .triangle = triangle,
                    .from = fragment.points[i],
                    .to = fragment.points[(i + 1) % size],
                    .start = end(before),
                    .end = end(after)};
    if (isUnderPlane(fragment, edge)) {
      trace.below = number;
    } else {
      trace.above = number;
      std::swap(trace.from, trace.to);
      std::swap(trace.start, trace.end);
    }
    traces_.push_back(trace);
    if (before.isPlane()) {
      const int axis = 3 - edge.axis - before.axis;
      crossings_.push_back({end(before).gridEdge, triangle, fragment.points[i][axis],
                            riseAt(fragment, before, edge)});
    }
  }
}

void TileSurface::sort() {
  std::vector<std::uint32_t> order(fragments_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return fragments_[i].cell; });
  std::vector<TileFragment> sorted;
  std::vector<std::uint32_t> numberOf(order.size());
  sorted.reserve(order.size());
  for (const auto i : order) {
    numberOf[i] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(fragments_[i]);
  }
  fragments_ = std::move(sorted);

  // Both sides of a face have the trace, and up to four cells the crossing.
  std::ranges::sort(traces_, {}, [](const FaceTrace& t) { return std::pair(t.face, t.triangle); });
  std::size_t count = 0;
  for (auto& trace : traces_) {
    if (trace.below != kNone) trace.below = numberOf[trace.below];
    if (trace.above != kNone) trace.above = numberOf[trace.above];
    if (count > 0 && traces_[count - 1].face == trace.face &&
        traces_[count - 1].triangle == trace.triangle) {
      auto& known = traces_[count - 1];
      known.below = std::min(known.below, trace.below);
      known.above = std::min(known.above, trace.above);
    } else {
      traces_[count++] = trace;
    }
  }
  traces_.resize(count);

  const auto key = [](const EdgeCrossing& c) { return std::pair(c.edge, c.triangle); };
  std::ranges::sort(crossings_, {}, key);
  const auto same = std::ranges::unique(crossings_, {}, key);
  crossings_.erase(same.begin(), same.end());
}

}  // namespace cutwater
