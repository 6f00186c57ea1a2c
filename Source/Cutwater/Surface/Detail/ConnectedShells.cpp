#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Surface/Detail/ConnectedShells.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

#include <algorithm>
#include <numeric>

namespace cutwater {

ConnectedShells connectShells(std::span<const std::array<std::uint32_t, 3>> triangles,
                              std::size_t vertexCount,
                              std::span<const std::array<std::uint32_t, 3>> neighbours) {
  ConnectedShells result;
  auto& parent = result.shellOf;
  parent.resize(triangles.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t triangle) {
    while (parent[triangle] != triangle) triangle = parent[triangle] = parent[parent[triangle]];
    return triangle;
  };
  const auto join = [&](std::uint32_t one, std::uint32_t other) {
    const auto first = root(one);
    const auto second = root(other);
    parent[std::max(first, second)] = std::min(first, second);
  };
  for (std::uint32_t t = 0; t < neighbours.size(); ++t) {
    for (const auto across : neighbours[t]) {
      if (across != kNone && t < across) join(t, across);
    }
  }
  visitEdgesWithoutNeighbours(triangles, vertexCount, neighbours,
                              [&](std::uint32_t, std::span<const EdgePass> passes) {
                                for (const auto& pass : passes) {
                                  join(passes.front().triangle, pass.triangle);
                                }
                              });
  // A root is the lowest triangle of its shell: those before it are already numbered.
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (parent[t] != t) {
      parent[t] = parent[parent[t]];
      continue;
    }
    parent[t] = static_cast<std::uint32_t>(result.firstTriangles.size());
    result.firstTriangles.push_back(t);
  }
  return result;
}

}  // namespace cutwater
