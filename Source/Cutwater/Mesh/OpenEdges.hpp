#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// An edge that triangles pass more often in one direction than in the other: the rim of a hole, a
/// seam between two orientations, a sheet that ends at another. What the winding number depends on.
struct OpenEdge {
  std::uint32_t lower;        ///< vertex
  std::uint32_t upper;        ///< vertex, a higher index
  std::int32_t multiplicity;  ///< passes from lower to upper, less those back; not 0
  std::uint32_t triangle;     ///< the first that has the edge
};

/// All of them, by lower vertex, then by upper vertex; n log n. None: the surface is closed.
///
/// Where `neighbours` tells the triangle across an edge of exactly two that run opposite ways, the
/// edge is passed over: it is not open. It may be left out.
[[nodiscard]] std::vector<OpenEdge> findOpenEdges(
    std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertexCount,
    std::span<const std::array<std::uint32_t, 3>> neighbours = {});

}  // namespace cutwater
