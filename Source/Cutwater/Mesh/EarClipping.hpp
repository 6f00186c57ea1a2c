#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater::detail {

/// A triangle of places in a list of corners.
using PlaceTriangle = std::array<std::uint32_t, 3>;

/// Appends corners.size() - 2 triangles, as places in `corners`, that cover the polygon.
///
/// `normal` says which side is up; the polygon is projected along its largest component, without
/// rounding. Needs at least three corners. Where the projection is not a simple polygon, the result
/// overlaps, but has the same number of triangles and the polygon for its boundary.
///
/// Meisters, "Polygons have ears", Amer. Math. Monthly 82 (1975); held in a queue by quality, as
/// Held, "FIST: fast industrial-strength triangulation of polygons", Algorithmica 30 (2001).
void clipEars(std::span<const Vec3<double>> corners, const Vec3<double>& normal,
              std::vector<PlaceTriangle>& triangles);

/// How close to equilateral: 4 sqrt(3) area / (sum of squared edges), 1 for equilateral, 0 for
/// flat.
[[nodiscard]] double triangleQuality(const Vec3<double>& a, const Vec3<double>& b,
                                     const Vec3<double>& c);

}  // namespace cutwater::detail
