#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// The tree of a triangle mesh: a view of arrays.
using TriangleTree = BvhTree<16, 16>;
/// The arrays of a TriangleTree, freshly built.
using TriangleTreeArrays = BvhArrays<TriangleTree::kArity, TriangleTree::kLeafWidth>;

/// Builds the tree over the boxes of the triangles, whose corners are indices of positions.
template <std::floating_point T>
[[nodiscard]] TriangleTreeArrays buildTriangleTree(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles);

/// Returns the tree with the same triangles in every leaf, refitted to vertices that have moved.
template <std::floating_point T>
[[nodiscard]] TriangleTreeArrays refittedTriangleTree(
    const TriangleTree& tree, std::span<const Vec3<T>> positions,
    std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace cutwater
