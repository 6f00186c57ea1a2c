#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

void visitEdgesWithoutNeighbours(
    std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertexCount,
    std::span<const std::array<std::uint32_t, 3>> neighbours,
    FunctionRef<void(std::uint32_t lower, std::span<const EdgePass> passes)> visit) {
  const auto visitHalfEdges = [&](auto visitor) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (!neighbours.empty() && neighbours[t][i] != kNone) continue;
        const auto from = triangles[t][i];
        const auto to = triangles[t][(i + 1) % 3];
        if (from < to) visitor(from, EdgePass{to, t, 1});
        if (to < from) visitor(to, EdgePass{from, t, -1});
      }
    }
  };
  // Sorted by lower vertex (counting sort), then within each vertex (by comparison).
  std::vector<std::size_t> begin(vertexCount + 1);
  visitHalfEdges([&](std::uint32_t lower, const EdgePass&) { ++begin[lower]; });
  std::size_t count = 0;
  for (auto& entry : begin) count += std::exchange(entry, count);
  if (count == 0) return;
  std::vector<EdgePass> passes(count);
  visitHalfEdges([&](std::uint32_t lower, const EdgePass& pass) { passes[begin[lower]++] = pass; });

  std::size_t first = 0;  // filling has moved every begin to the end of its vertex
  for (std::uint32_t lower = 0; lower < vertexCount; ++lower) {
    auto own = std::span(passes).subspan(first, begin[lower] - first);
    first = begin[lower];
    std::ranges::sort(own, {}, [](const EdgePass& p) { return std::pair(p.upper, p.triangle); });
    while (!own.empty()) {
      const auto upper = own.front().upper;
      const auto end =
          std::ranges::find_if(own, [upper](const EdgePass& pass) { return pass.upper != upper; });
      const auto uses = static_cast<std::size_t>(end - own.begin());
      visit(lower, own.first(uses));
      own = own.subspan(uses);
    }
  }
}

std::vector<OpenEdge> findOpenEdges(std::span<const std::array<std::uint32_t, 3>> triangles,
                                    std::size_t vertexCount,
                                    std::span<const std::array<std::uint32_t, 3>> neighbours) {
  std::vector<OpenEdge> result;
  visitEdgesWithoutNeighbours(
      triangles, vertexCount, neighbours,
      [&](std::uint32_t lower, std::span<const EdgePass> passes) {
        OpenEdge edge{lower, passes.front().upper, 0, passes.front().triangle};
        for (const auto& pass : passes) edge.multiplicity += pass.direction;
        if (edge.multiplicity != 0) result.push_back(edge);
      });
  return result;
}

}  // namespace cutwater
