#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace cutwater {

/// Whether two triangles of a mesh, as closed sets, meet in a point of no vertex and no edge that
/// they share. Corners are shared if they have the same number; two triangles with the same three
/// corners meet. Touching counts, of another vertex, too, that has the same position.
///
/// Exact, see ExactPredicates.hpp, also for how to scale. Both triangles must have area.
[[nodiscard]] bool intersect(std::span<const Vec3<double>> positions,
                             const std::array<std::uint32_t, 3>& a,
                             const std::array<std::uint32_t, 3>& b);

/// Exactly: false if the three points lie on a line.
[[nodiscard]] bool hasArea(const std::array<Vec3<double>, 3>& triangle);

}  // namespace cutwater
