#pragma once

#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Triangles/Search/TriangleTree.hpp>

#include <cstdint>

namespace cutwater {

/// findSelfIntersections(), with a tree over these triangles. The largest coordinate must be about
/// 1: see ExactPredicates.hpp. If `changed` is given, one value for each triangle, only pairs of
/// which at least one is not 0 are looked for.
template <std::floating_point T>
[[nodiscard]] SelfIntersections findSelfIntersections(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
    const TriangleTree& tree, const SelfIntersectionOptions& options = {},
    std::span<const std::uint8_t> changed = {});

}  // namespace cutwater
