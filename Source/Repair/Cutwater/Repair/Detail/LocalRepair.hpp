#pragma once

#include <Cutwater/Repair/Detail/Deadline.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater::detail {

/// The triangles without (most of) their self-intersections, all in patch 0. If the time is up,
/// returns what was achieved until then.
/// @throws Error(Topology) unless they are an oriented manifold, or where CGAL fails.
[[nodiscard]] PolygonSoup withoutSelfIntersections(const PolygonSoup& triangles, int rounds,
                                                   const Deadline& deadline);

}  // namespace cutwater::detail
