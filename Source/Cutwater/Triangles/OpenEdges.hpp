#pragma once

#include <Cutwater/Core/FunctionRef.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// An edge that triangles run along more often in one direction than in the other: the rim of a
/// hole, a seam between two orientations, a sheet that ends at another. Winding numbers depend on
/// these.
struct OpenEdge {
  std::uint32_t lower;        ///< vertex
  std::uint32_t upper;        ///< vertex, a higher index
  std::int32_t multiplicity;  ///< passes from lower to upper, less those back; not 0
  std::uint32_t triangle;     ///< the first that has the edge
};

/// A triangle's passage along an edge, seen from the edge's lower vertex.
struct EdgePass {
  std::uint32_t upper;  ///< vertex
  std::uint32_t triangle;
  std::int32_t direction;  ///< 1: from the lower vertex to the upper one; else -1
};

/// Visits every edge that has a half-edge without a neighbour, by lower vertex, then by upper
/// vertex, with those half-edges in the order of their triangles; n log n. Visits every edge if
/// `neighbours` is empty.
void visitEdgesWithoutNeighbours(
    std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertexCount,
    std::span<const std::array<std::uint32_t, 3>> neighbours,
    FunctionRef<void(std::uint32_t lower, std::span<const EdgePass> passes)> visit);

/// Returns all open edges, by lower vertex, then by upper vertex; n log n. A closed surface has
/// none.
///
/// `neighbours`, which may be left out, gives the triangles across edges of exactly two that run
/// opposite ways: these edges are not open and are skipped.
[[nodiscard]] std::vector<OpenEdge> findOpenEdges(
    std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertexCount,
    std::span<const std::array<std::uint32_t, 3>> neighbours = {});

}  // namespace cutwater
