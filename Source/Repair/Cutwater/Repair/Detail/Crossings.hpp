#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <cstddef>

namespace cutwater::detail {

/// Number of pairs of triangles that intersect beyond shared points and edges, at least one of them
/// among the soup's last `count` polygons; up to about a million.
[[nodiscard]] std::size_t crossingsOfLast(const PolygonSoup& soup, std::size_t count);

}  // namespace cutwater::detail
