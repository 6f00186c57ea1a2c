#include <Cutwater/CutCells/Detail/Faces/SheetDividers.hpp>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

/// An edge of a sheet, under its ends.
struct SheetEdge {
  std::array<Vec3<double>, 2> ends;
  const Sheet* sheet = nullptr;

  [[nodiscard]] auto key() const {
    const auto& [p, q] = ends;
    return std::tuple(p.x, p.y, p.z, q.x, q.y, q.z);
  }
};

std::vector<SheetEdge> edgesOfBaffles(std::span<const Sheet> sheets) {
  std::vector<SheetEdge> edges;
  for (const auto& sheet : sheets) {
    for (std::size_t i = 0; i < sheet.points.size() && sheet.isBaffle; ++i) {
      SheetEdge edge{{sheet.points[i], sheet.points[(i + 1) % sheet.points.size()]}, &sheet};
      auto& [p, q] = edge.ends;
      if (std::tie(q.x, q.y, q.z) < std::tie(p.x, p.y, p.z)) std::swap(p, q);
      edges.push_back(edge);
    }
  }
  std::ranges::sort(edges, {}, &SheetEdge::key);
  return edges;
}

/// Two baffles whose planes cross in a line that is known poorly.
bool areNearlyParallel(const Sheet& one, const Sheet& other) {
  constexpr double kSmallAngle = 1e-3;
  return length(cross(one.plane.normal, other.plane.normal)) < kSmallAngle;
}

/// Across a sheet at one of its edges.
Sheet dividerAt(const SheetEdge& edge) {
  const auto& [p, q] = edge.ends;
  const auto& normal = edge.sheet->plane.normal;
  const auto across = cross(q - p, normal);
  Sheet divider{.points = {}, .plane = {across / length(across), 0}, .isDivider = true};
  divider.plane.offset = dot(divider.plane.normal, p);
  const auto height = length(q - p) * normal;
  divider.points = {p - height, q - height, q + height, p + height};
  return divider;
}

}  // namespace

std::vector<Sheet> dividersOf(std::span<const Sheet> sheets) {
  const auto edges = edgesOfBaffles(sheets);
  std::vector<Sheet> dividers;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto& one = *edges[i - 1].sheet;
    const auto& other = *edges[i].sheet;
    if (edges[i].key() != edges[i - 1].key() || one.points == other.points) continue;
    const bool isEdge = length(edges[i].ends[1] - edges[i].ends[0]) > SheetTree::kNear;
    if (isEdge && areNearlyParallel(one, other)) dividers.push_back(dividerAt(edges[i]));
  }
  return dividers;
}

}  // namespace cutwater
