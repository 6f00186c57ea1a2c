#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater::benchmarks {

/// Halves the longest edges until there are `count` triangles (or one more). Neighbours share the
/// new points, so that closed surfaces stay closed. Needs a closed surface of triangles.
[[nodiscard]] PolygonSoup refined(PolygonSoup triangles, std::size_t count);

/// Moves every point along its normal by a smooth pseudo-random wave of the given amplitude, so
/// that what was flat before refinement is flat no more.
void displace(PolygonSoup& triangles, double amplitude);

}  // namespace cutwater::benchmarks
