#pragma once

#include <Cutwater/Mesh/PolygonSoup.hpp>

// Private: not installed.

namespace cutwater::detail {

/// For every point the first that equals it, itself perhaps; -0 equals 0, and points that are not
/// finite are equal to none. Linear time.
[[nodiscard]] std::vector<std::uint32_t> firstEqualPoints(std::span<const Vec3<double>> points);

/// Lets point firsts[i] <= i, which stands for itself, take the place of point i. The others keep
/// their order. Returns how many are gone, and each point's new number in `firsts`. Allocates
/// nothing: a soup is merged, or it is as it was.
std::size_t mergePoints(PolygonSoup& soup, std::span<std::uint32_t> firsts);

}  // namespace cutwater::detail
