#pragma once

#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Triangles/Search/TriangleTree.hpp>

namespace cutwater {

/// findSelfIntersections(), with a tree over these triangles. The largest coordinate must be about
/// 1: see ExactPredicates.hpp.
template <std::floating_point T>
[[nodiscard]] SelfIntersections findSelfIntersections(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const TriangleTree& tree, const SelfIntersectionOptions& options = {});

}  // namespace cutwater
