#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater::detail {

/// A triangle whose corners are indices into a list of corners.
using PlaceTriangle = std::array<std::uint32_t, 3>;

/// Appends corners.size() - 2 triangles, as indices into `corners`, that cover the polygon.
///
/// `normal` points to the upper side; the polygon is projected along its largest component, without
/// rounding. Needs at least three corners. Where the projection is not a simple polygon, the
/// triangles overlap, but their number is the same and their boundary is the polygon.
///
/// Meisters, "Polygons have ears", Amer. Math. Monthly 82 (1975); with a queue of ears by quality,
/// as in Held, "FIST: fast industrial-strength triangulation of polygons", Algorithmica 30 (2001).
void clipEars(std::span<const Vec3<double>> corners, const Vec3<double>& normal,
              std::vector<PlaceTriangle>& triangles);

/// How close a triangle is to equilateral: 4 sqrt(3) area / (sum of squared edges), 1 if
/// equilateral, 0 if flat.
[[nodiscard]] double triangleQuality(const Vec3<double>& a, const Vec3<double>& b,
                                     const Vec3<double>& c);

}  // namespace cutwater::detail
