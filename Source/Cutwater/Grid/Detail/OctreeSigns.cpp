#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Grid/Detail/OctreeSigns.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Points or edges that are queried together.
constexpr std::size_t kSignBatch = 256;

/// Indices of the values that are not 0.
template <typename Value>
std::vector<std::size_t> placesOf(const std::vector<std::atomic<Value>>& values) {
  std::vector<std::size_t> places;
  for (std::size_t n = 0; n < values.size(); ++n) {
    if (values[n].load(std::memory_order_relaxed) != 0) places.push_back(n);
  }
  return places;
}

/// Calls visit(batch of the places) until all have been visited, in parallel.
template <typename Visit>
void forPlaces(std::span<const std::size_t> places, const ParallelOptions& options,
               const Visit& visit) {
  parallelBatches(places.size(), kSignBatch, options, [&](std::size_t first, std::size_t count) {
    visit(places.subspan(first, count));
  });
}

}  // namespace

template <std::floating_point T>
OctreeSigns<T>::OctreeSigns(const SignedDistanceFunction<T>& solid, const OctreeCells<T>& mesh,
                            const ParallelOptions& options)
    : solid_(solid),
      mesh_(mesh),
      nodes_(mesh, {.threads = options.threads}),
      cells_(static_cast<std::size_t>(mesh.deepest()) + 1),
      values_(nodes_.count()),
      edges_(3 * nodes_.count()) {
  const auto cells = mesh.cells();
  for (std::size_t n = 0; n < cells.size(); ++n) {
    if (mayBeCut(cells[n].kind)) cells_[cells[n].level].push_back(n);
  }
  evaluate(options);
}

template <std::floating_point T>
template <typename Visit>
void OctreeSigns<T>::forCells(std::span<const std::size_t> cells, const ParallelOptions& options,
                              const Visit& visit) const {
  constexpr auto kTogether = 16 * kMost;
  parallelBatches(cells.size(), kTogether, options, [&](std::size_t first, std::size_t count) {
    Scratch<typename OctreeNodes<T>::Corners, kTogether> scratch;
    const auto corners = scratch.first(count);
    nodes_.corners(cells.subspan(first, count), corners);
    for (const auto& each : corners) visit(each);
  });
}

template <std::floating_point T>
void OctreeSigns<T>::evaluate(const ParallelOptions& options) {
  std::vector<std::atomic<bool>> isCorner(nodes_.count());
  for (const auto& cells : cells_) {
    forCells(cells, {.threads = options.threads}, [&](const auto& corners) {
      for (const auto node : corners) isCorner[node].store(true, std::memory_order_relaxed);
    });
  }
  forPlaces(placesOf(isCorner), options, [&](std::span<const std::size_t> nodes) {
    Scratch<Vec3<T>, kSignBatch> points;
    Scratch<T, kSignBatch> values;
    for (std::size_t i = 0; i < nodes.size(); ++i) points[i] = nodes_.position(nodes[i]);
    solid_.signedDistances(points.first(nodes.size()), values.first(nodes.size()), {.threads = 1});
    for (std::size_t i = 0; i < nodes.size(); ++i) values_[nodes[i]] = values[i];
  });
}

template <std::floating_point T>
void OctreeSigns<T>::countCrossings(int level, const ParallelOptions& options) {
  markEdges(level, options);
  stretches_.clear();
  forPlaces(placesOf(edges_), options,
            [&](std::span<const std::size_t> edges) { countCrossingsOf(level, edges); });
  std::ranges::sort(stretches_, {}, &NumberedStretch::edge);
}

template <std::floating_point T>
void OctreeSigns<T>::markEdges(int level, const ParallelOptions& options) {
  for (auto& mark : edges_) mark.store(kFree, std::memory_order_relaxed);
  const auto promise = solid_.guarantee();
  const auto domain = mesh_.domain().box();
  // An edge whose ends have one sign is free of the surface if the Lipschitz constant does not
  // allow the value to reach 0 on the way between their two values.
  T enough = std::numeric_limits<T>::infinity();
  if (promise.lipschitz && OrientedBox<T>::of(domain).isWithin(promise.domain)) {
    constexpr T kOutward = 1 + 8 * std::numeric_limits<T>::epsilon();
    const T farthest = length(max(abs(domain.lower), abs(domain.upper)));
    const T width = mesh_.domain().level(level).spacing().x + promise.error(farthest);
    enough = kOutward * (*promise.lipschitz * width + 2 * promise.error(farthest));
  }
  forCells(cells(level), {.threads = options.threads}, [&](const auto& corners) {
    for (const auto& edge : kCellEdges) {
      const auto from = corners[static_cast<std::size_t>(edge.from)];
      const auto to = corners[static_cast<std::size_t>(edge.to())];
      const bool isCrossed = isInside(from) != isInside(to);
      if (!isCrossed && std::abs(values_[from]) + std::abs(values_[to]) > enough) continue;
      edges_[edgeNumber(from, edge.axis)].store(isCrossed ? kCrossed : kToClassify,
                                                std::memory_order_relaxed);
    }
  });
}

template <std::floating_point T>
Segment<T> OctreeSigns<T>::edge(std::size_t number, int level) const {
  const auto start = nodes_.index(number / 3);
  const std::int32_t width = 1 << (mesh_.deepest() - level);
  auto end = start;
  (number % 3 == 0 ? end.i : number % 3 == 1 ? end.j : end.k) += width;
  return {nodes_.position(start), nodes_.position(end)};
}

template <std::floating_point T>
void OctreeSigns<T>::countCrossingsOf(int level, std::span<const std::size_t> edges) {
  Scratch<Box<T>, kSignBatch> boxes;
  Scratch<BoxClass, kSignBatch> classes;
  Scratch<std::size_t, kSignBatch> open;
  std::size_t opened = 0;
  for (const auto number : edges) {
    if (edges_[number].load(std::memory_order_relaxed) != kToClassify) continue;
    const auto [start, end] = edge(number, level);
    boxes[opened] = {start, end};
    open[opened++] = number;
  }
  solid_.classify(boxes.first(opened), classes.first(opened), {}, {.threads = 1});
  for (std::size_t i = 0; i < opened; ++i) {
    if (!mayBeCut(classes[i])) edges_[open[i]].store(kFree, std::memory_order_relaxed);
  }
  std::vector<Segment<T>> segments;
  opened = 0;
  for (const auto number : edges) {
    if (edges_[number].load(std::memory_order_relaxed) == kFree) continue;
    segments.push_back(edge(number, level));
    open[opened++] = number;
  }
  const auto lists = solid_.crossings(segments, {.threads = 1});
  for (std::size_t i = 0; i < opened; ++i) {
    EdgeStretch<T> thickest{};
    const auto found = countOf(segments[i], lists.of(i), thickest);
    edges_[open[i]].store(found, std::memory_order_relaxed);
    if (found < 2) continue;
    const std::lock_guard lock(stretchesMutex_);
    stretches_.push_back({open[i], thickest});
  }
}

template <std::floating_point T>
auto OctreeSigns<T>::countOf(const Segment<T>& edge, std::span<const Crossing<T>> crossings,
                             EdgeStretch<T>& thickest) const -> Mark {
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const auto stretch = stretchBetween(solid_, edge, crossings[i - 1], crossings[i]);
    if (stretch && std::abs(stretch->distance) > std::abs(thickest.distance)) thickest = *stretch;
  }
  return thickest.distance != 0 ? 2 : crossings.size() % 2;
}

template <std::floating_point T>
auto OctreeSigns<T>::thickestOf(std::size_t edge) const -> const EdgeStretch<T>& {
  return std::ranges::lower_bound(stretches_, edge, {}, &NumberedStretch::edge)->thickest;
}

template <std::floating_point T>
void OctreeSigns<T>::signs(std::span<const std::size_t> cells,
                           std::span<CellSigns<T>> result) const {
  Scratch<typename OctreeNodes<T>::Corners, kMost> scratch;
  const auto corners = scratch.first(cells.size());
  nodes_.corners(cells, corners);
  for (std::size_t n = 0; n < cells.size(); ++n) {
    result[n] = {};
    for (std::size_t i = 0; i < 8; ++i) {
      result[n].inside |= (isInside(corners[n][i]) ? 1U : 0U) << i;
    }
    for (std::size_t e = 0; e < kCellEdges.size(); ++e) {
      const auto& [from, axis] = kCellEdges[e];
      const auto number = edgeNumber(corners[n][static_cast<std::size_t>(from)], axis);
      result[n].crossings[e] = edges_[number].load(std::memory_order_relaxed);
      if (result[n].crossings[e] < 2) continue;
      const auto& thickest = thickestOf(number);
      if (std::abs(thickest.distance) > std::abs(result[n].thickest.distance)) {
        result[n].thickest = thickest;
      }
    }
  }
}

template class OctreeSigns<float>;
template class OctreeSigns<double>;

}  // namespace cutwater::detail
