#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Mesh/OpenEdges.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

/// A half-edge as its lower vertex keeps it.
struct Pass {
  std::uint32_t upper;
  std::uint32_t triangle;
  std::int32_t direction;  // 1: from the lower vertex to the upper one
};

}  // namespace

std::vector<OpenEdge> findOpenEdges(std::span<const std::array<std::uint32_t, 3>> triangles,
                                    std::size_t vertexCount,
                                    std::span<const std::array<std::uint32_t, 3>> neighbours) {
  const auto visitHalfEdges = [&](auto visit) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (!neighbours.empty() && neighbours[t][i] != kNone) continue;
        const auto from = triangles[t][i];
        const auto to = triangles[t][(i + 1) % 3];
        if (from < to) visit(from, Pass{to, t, 1});
        if (to < from) visit(to, Pass{from, t, -1});
      }
    }
  };
  // Sorted by lower vertex by counting, within a vertex by comparing.
  std::vector<std::size_t> begin(vertexCount + 1);
  visitHalfEdges([&](std::uint32_t lower, const Pass&) { ++begin[lower]; });
  std::size_t count = 0;
  for (auto& entry : begin) count += std::exchange(entry, count);
  std::vector<Pass> passes(count);
  visitHalfEdges([&](std::uint32_t lower, const Pass& pass) { passes[begin[lower]++] = pass; });

  std::vector<OpenEdge> result;
  std::size_t first = 0;  // filling has moved every begin to the end of its vertex
  for (std::uint32_t lower = 0; lower < vertexCount; ++lower) {
    const auto own = std::span(passes).subspan(first, begin[lower] - first);
    first = begin[lower];
    std::ranges::sort(own, {}, [](const Pass& p) { return std::pair(p.upper, p.triangle); });
    for (std::size_t i = 0; i < own.size();) {
      OpenEdge edge{lower, own[i].upper, 0, own[i].triangle};
      for (; i < own.size() && own[i].upper == edge.upper; ++i) {
        edge.multiplicity += own[i].direction;
      }
      if (edge.multiplicity != 0) result.push_back(edge);
    }
  }
  return result;
}

}  // namespace cutwater
