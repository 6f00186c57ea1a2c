#pragma once

#include <Cutwater/Mesh/PolygonSoup.hpp>
#include <Cutwater/Repair/Deadline.hpp>

// Private: not installed.

namespace cutwater::detail {

/// Triangles without (most of) their self-intersections; all are of patch 0. When the time is up,
/// what has been done by then.
/// @throws Error(Topology) unless they are an oriented manifold, or where CGAL fails.
[[nodiscard]] PolygonSoup withoutSelfIntersections(const PolygonSoup& triangles, int rounds,
                                                   const Deadline& deadline);

}  // namespace cutwater::detail
