#include <Cutwater/Grid/Detail/SurfaceTile.hpp>
#include <Cutwater/Grid/Fill.hpp>

#include <algorithm>
#include <bit>

namespace cutwater::detail {

namespace {

/// The corner of the wanted sign that is nearest to a point of the unit cube.
int nearestCorner(unsigned inside, bool wanted, const Vec3<double>& p) {
  int best = -1;
  double least = 4;
  for (int corner = 0; corner < 8; ++corner) {
    if ((((inside >> static_cast<unsigned>(corner)) & 1U) != 0) != wanted) continue;
    const Vec3<double> at(corner & 1, (corner >> 1) & 1, corner >> 2);
    const double squared = dot(p - at, p - at);
    if (squared >= least) continue;
    least = squared;
    best = corner;
  }
  return best;
}

/// Middles of the cut edges, in the unit cube.
std::array<Vec3<double>, CellPolygon::kMost> edgeMiddles(const CellPolygon& polygon) {
  std::array<Vec3<double>, CellPolygon::kMost> result;
  for (std::size_t n = 0; n < static_cast<std::size_t>(polygon.count); ++n) {
    const auto [axis, corner] = cubeEdge(polygon.corners[n]);
    result[n] = Vec3<double>(corner & 1, (corner >> 1) & 1, corner >> 2);
    result[n][axis] = 0.5;
  }
  return result;
}

}  // namespace

template <std::floating_point T>
bool SurfaceGrid<T>::isJoined(const NodeOffset& cell, int face) const {
  const auto corners = cubeFace(face);
  const auto [low, high] = std::minmax({corners[0], corners[2]});
  const auto a = position(cornerOf(cell, low));
  const auto b = position(cornerOf(cell, high));
  return solid.signedDistance(T(0.5) * (a + b)) < 0;
}

template <std::floating_point T>
SurfaceTile<T>::SurfaceTile(const SurfaceGrid<T>& grid, const NodeOffset& first) : first_(first) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t left = grid.count(axis) - first[axis];
    nodes_[axis] = std::min(left, kCells + 1);
    own_[axis] = left <= kCells + 1 ? left : kCells;
  }
  Values values;
  sample(grid, values);
  numberEdges();
  findEdgePoints(grid, values);
  resolveAmbiguousCells(grid, values);
}

template <std::floating_point T>
void SurfaceTile<T>::sample(const SurfaceGrid<T>& grid, Values& values) {
  const auto& all = grid.nodes.indices;
  const auto last = inGrid({nodes_[0] - 1, nodes_[1] - 1, nodes_[2] - 1});
  const GridPatch<T> nodes{
      grid.nodes.level,
      {all.at(first_[0], first_[1], first_[2]), all.at(last[0], last[1], last[2])}};
  const GridView<T> view{values.data(), {1, kCells + 1, (kCells + 1) * (kCells + 1)}};
  fill(grid.solid, nodes, view, {.band = 1, .threads = 1});
  for (std::uint32_t k = 0; k < nodes_[2]; ++k) {
    for (std::uint32_t j = 0; j < nodes_[1]; ++j) {
      for (std::uint32_t i = 0; i < nodes_[0]; ++i) {
        rows_[k][j] |= static_cast<Row>((view.at(i, j, k) < 0 ? 1U : 0U) << i);
      }
    }
  }
}

template <std::floating_point T>
typename SurfaceTile<T>::Row SurfaceTile<T>::cutEdges(std::uint32_t j, std::uint32_t k,
                                                      int axis) const {
  const NodeOffset next{0, j + (axis == 1 ? 1 : 0), k + (axis == 2 ? 1 : 0)};
  if (next[1] >= nodes_[1] || next[2] >= nodes_[2]) return 0;
  const unsigned row = rows_[k][j];
  const unsigned other = axis == 0 ? row >> 1U : rows_[next[2]][next[1]];
  const unsigned begins = axis == 0 ? nodes_[0] - 1 : own_[0];  // nodes that begin such edges
  return static_cast<Row>((row ^ other) & ((1U << begins) - 1U));
}

template <std::floating_point T>
void SurfaceTile<T>::numberEdges() {
  for (std::uint32_t k = 0; k < own_[2]; ++k) {
    for (std::uint32_t j = 0; j < own_[1]; ++j) {
      firstPoint_[k][j] = static_cast<std::uint16_t>(edgePoints_);
      for (int axis = 0; axis < 3; ++axis) {
        edgePoints_ += static_cast<std::size_t>(std::popcount(cutEdges(j, k, axis)));
      }
    }
  }
}

template <std::floating_point T>
std::uint32_t SurfaceTile<T>::edgePoint(const NodeOffset& node, int axis) const {
  const auto [i, j, k] = node;
  int before = 0;
  for (int a = 0; a < axis; ++a) before += std::popcount(cutEdges(j, k, a));
  before += std::popcount(static_cast<Row>(cutEdges(j, k, axis) & ((1U << i) - 1U)));
  return firstPoint_[k][j] + static_cast<std::uint32_t>(before);
}

template <std::floating_point T>
void SurfaceTile<T>::findEdgePoints(const SurfaceGrid<T>& grid, const Values& values) {
  std::vector<SignChange<T>> changes;
  changes.reserve(edgePoints_);
  for (std::uint32_t k = 0; k < own_[2]; ++k) {
    for (std::uint32_t j = 0; j < own_[1]; ++j) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        unsigned cut = cutEdges(j, k, static_cast<int>(axis));
        for (; cut != 0; cut &= cut - 1) {
          const NodeOffset from{static_cast<std::uint32_t>(std::countr_zero(cut)), j, k};
          auto to = from;
          ++to[axis];
          changes.push_back({grid.position(inGrid(from)), grid.position(inGrid(to)),
                             valueAt(values, from), valueAt(values, to)});
        }
      }
    }
  }
  const auto found = locate<T>(grid.solid, changes, grid.tolerance);
  points_.reserve(changes.size());
  for (std::size_t n = 0; n < changes.size(); ++n) {
    const Vec3<double> from(changes[n].from);
    points_.push_back(from + found[n] * (Vec3<double>(changes[n].to) - from));
  }
}

template <std::floating_point T>
std::vector<typename SurfaceTile<T>::CutCell> SurfaceTile<T>::cutCells() const {
  std::vector<CutCell> result;
  auto joined = joined_.begin();
  for (std::uint32_t k = 0; k + 1 < nodes_[2]; ++k) {
    for (std::uint32_t j = 0; j + 1 < nodes_[1]; ++j) {
      const std::array<unsigned, 4> rows{rows_[k][j], rows_[k][j + 1], rows_[k + 1][j],
                                         rows_[k + 1][j + 1]};
      const unsigned any = rows[0] | rows[1] | rows[2] | rows[3];
      const unsigned all = rows[0] & rows[1] & rows[2] & rows[3];
      const unsigned cells = (1U << (nodes_[0] - 1)) - 1U;
      unsigned cut = (any | any >> 1U) & ~(all & all >> 1U) & cells;
      for (; cut != 0; cut &= cut - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(cut));
        CutCell cell{{i, j, k}, 0, 0};
        for (unsigned row = 0; row < 4; ++row) cell.inside |= ((rows[row] >> i) & 3U) << 2 * row;
        if (ambiguousFaces(cell.inside) != 0 && joined != joined_.end()) cell.joined = *joined++;
        result.push_back(cell);
      }
    }
  }
  return result;
}

template <std::floating_point T>
void SurfaceTile<T>::resolveAmbiguousCells(const SurfaceGrid<T>& grid, const Values& values) {
  std::vector<SignChange<T>> middles;
  for (const auto& [cell, inside, unknown] : cutCells()) {
    unsigned open = ambiguousFaces(inside);
    if (open == 0) continue;
    unsigned joined = 0;
    for (; open != 0; open &= open - 1) {
      const int face = std::countr_zero(open);
      if (grid.isJoined(inGrid(cell), face)) joined |= 1U << static_cast<unsigned>(face);
    }
    joined_.push_back(joined);
    std::array<CellPolygon, 4> polygons;
    const int count = surfacePolygons(inside, joined, polygons);
    for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
      if (needsMiddle(polygons[n]))
        middles.push_back(throughMiddle(polygons[n], {cell, inside, joined}, grid, values));
    }
  }
  const auto found = locate<T>(grid.solid, middles, grid.tolerance);
  for (std::size_t n = 0; n < middles.size(); ++n) points_.emplace_back(middles[n].at(found[n]));
}

template <std::floating_point T>
SignChange<T> SurfaceTile<T>::throughMiddle(const CellPolygon& polygon, const CutCell& cut,
                                            const SurfaceGrid<T>& grid,
                                            const Values& values) const {
  const auto& [cell, inside, joined] = cut;
  const auto edges = edgeMiddles(polygon);
  Vec3<double> middle{};
  for (int i = 0; i < polygon.count; ++i) middle = middle + edges[static_cast<std::size_t>(i)];
  middle = (1.0 / polygon.count) * middle;
  const Vec3<double> a(grid.position(inGrid(cell)));
  const Vec3<double> size = Vec3<double>(grid.position(inGrid(cornerOf(cell, 7)))) - a;
  const Vec3<T> from(a + Vec3<double>{middle.x * size.x, middle.y * size.y, middle.z * size.z});
  const auto value = static_cast<double>(grid.solid.signedDistance(from));
  const auto node = cornerOf(cell, nearestCorner(inside, !(value < 0), middle));
  return {from, grid.position(inGrid(node)), value, valueAt(values, node)};
}

template struct SurfaceGrid<float>;
template struct SurfaceGrid<double>;
template class SurfaceTile<float>;
template class SurfaceTile<double>;

}  // namespace cutwater::detail
