#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <span>
#include <vector>

namespace cutwater::benchmarks {

/// The signed distance by looking at every triangle, in double, with the last digits in long
/// double. The sign is that of the winding number, a sum of solid angles: nothing in it is shared
/// with those whose answers it checks. In parallel.
[[nodiscard]] std::vector<double> bruteForce(const PolygonSoup& triangles,
                                             std::span<const Vec3<double>> points);

}  // namespace cutwater::benchmarks
