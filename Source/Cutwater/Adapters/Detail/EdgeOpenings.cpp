#include <Cutwater/Adapters/Detail/EdgeOpenings.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

/// The order of edges.
auto placeOf(const Index3& cell, int axis) {
  return std::tuple(cell.k, cell.j, cell.i, axis);
}

/// A part of an edge, in lengths of the edge from its lower end.
struct Stretch {
  Index3 cell;
  int axis = 0;
  double from = 0;
  double to = 0;

  [[nodiscard]] auto order() const { return std::tuple(placeOf(cell, axis), from, to); }
};

/// Appends what the outline of an arc has of the borders of its face.
void addStretches(const CutCells& cells, std::size_t arc, std::vector<Stretch>& stretches) {
  const auto cell = cells.arcs.cell[arc];
  const auto box = cells.boxOf(cell);
  const auto outline = cells.arcPolygons.of(arc);
  for (std::size_t n = 0; n < outline.size(); ++n) {
    const auto& a = outline[n];
    const auto& b = outline[(n + 1) % outline.size()];
    for (int turn = 1; turn < 3; ++turn) {
      const int across = (cells.arcs.axis[arc] + turn) % 3;
      if (a[across] != b[across]) continue;
      const bool isHigh = a[across] == box.upper[across];
      if (!isHigh && a[across] != box.lower[across]) continue;
      const int axis = 3 - cells.arcs.axis[arc] - across;
      const double from = std::min(a[axis], b[axis]);
      const double to = std::max(a[axis], b[axis]);
      if (from == to) continue;
      const double width = box.upper[axis] - box.lower[axis];
      auto& stretch = stretches.emplace_back(Stretch{.cell = cell,
                                                     .axis = axis,
                                                     .from = (from - box.lower[axis]) / width,
                                                     .to = (to - box.lower[axis]) / width});
      if (isHigh) ++along(stretch.cell, across);
    }
  }
}

void sortOnce(std::vector<EdgeOpening>& edges) {
  const auto order = [](const EdgeOpening& edge) { return placeOf(edge.cell, edge.axis); };
  std::ranges::sort(edges, {}, order);
  const auto same = [&](const EdgeOpening& a, const EdgeOpening& b) {
    return order(a) == order(b);
  };
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
}

}  // namespace

std::vector<EdgeOpening> edgesOfCells(const CutCells& cells) {
  std::vector<EdgeOpening> edges;
  edges.reserve(12 * cells.cellCount);
  for (std::size_t row = 0; row < cells.cellCount; ++row) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int corner = 0; corner < 4; ++corner) {
        auto& edge = edges.emplace_back(EdgeOpening{.cell = cells.cells.index[row], .axis = axis});
        along(edge.cell, (axis + 1) % 3) += corner & 1;
        along(edge.cell, (axis + 2) % 3) += corner >> 1;
      }
    }
  }
  sortOnce(edges);
  return edges;
}

EdgeOpenings::EdgeOpenings(const CutCells& cells) {
  std::vector<Stretch> stretches;
  for (const auto& edge : edgesOfCells(cells)) {
    stretches.push_back({.cell = edge.cell, .axis = edge.axis});
  }
  for (std::size_t arc = 0; arc < cells.arcs.area.size(); ++arc) {
    addStretches(cells, arc, stretches);
  }
  std::ranges::sort(stretches, {}, &Stretch::order);
  for (auto next = stretches.begin(); next != stretches.end();) {
    EdgeOpening edge{.cell = next->cell, .axis = next->axis};
    double reached = 0;
    double moment = 0;
    for (; next != stretches.end() && next->cell == edge.cell && next->axis == edge.axis; ++next) {
      const double from = std::max(reached, next->from);
      if (next->to <= from) continue;
      edge.share += next->to - from;
      moment += (next->to - from) * (from + next->to) / 2;
      reached = next->to;
    }
    if (edge.share > 0) edge.centroid = moment / edge.share - 0.5;
    edges_.push_back(edge);
  }
}

EdgeOpenings::EdgeOpenings(std::vector<EdgeOpening> edges) : edges_(std::move(edges)) {
  sortOnce(edges_);
}

std::optional<EdgeOpening> EdgeOpenings::at(const Index3& cell, int axis) const {
  const auto found = std::ranges::lower_bound(
      edges_, placeOf(cell, axis), {},
      [](const EdgeOpening& edge) { return placeOf(edge.cell, edge.axis); });
  if (found == edges_.end() || found->cell != cell || found->axis != axis) return std::nullopt;
  return *found;
}

}  // namespace cutwater
