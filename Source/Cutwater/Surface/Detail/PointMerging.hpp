#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater::detail {

/// Returns, for every point, the first point that equals it, which may be itself; -0 equals 0, and
/// a point that is not finite equals no other. Linear time.
[[nodiscard]] std::vector<std::uint32_t> firstEqualPoints(std::span<const Vec3<double>> points);

/// Replaces every point i by point firsts[i] <= i, which must be its own first. The remaining
/// points keep their order. Returns how many were removed, and each point's new index in `firsts`.
/// Allocates nothing, so the soup is either merged or unchanged.
std::size_t mergePoints(PolygonSoup& soup, std::span<std::uint32_t> firsts);

}  // namespace cutwater::detail
