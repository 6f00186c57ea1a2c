#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace cutwater {

/// Whether two triangles of a mesh, as closed sets, meet at a point that is not on a vertex or an
/// edge that they share. Corners are shared if they have the same index; two triangles with the
/// same three corners meet. Touching counts, also at another vertex with the same position.
///
/// Exact; see ExactPredicates.hpp, also for the scaling. Both triangles must have area.
[[nodiscard]] bool intersect(std::span<const Vec3<double>> positions,
                             const std::array<std::uint32_t, 3>& a,
                             const std::array<std::uint32_t, 3>& b);

/// Whether two triangles do more than touch: a point of one of them lies within the other, not on
/// its edges. So they pass through or lie on one another. Triangles that touch along edges or at
/// corners do not, whichever these are.
///
/// Exact; see ExactPredicates.hpp, also for the scaling. Both triangles must have area.
[[nodiscard]] bool meetWithin(const std::array<Vec3<double>, 3>& a,
                              const std::array<Vec3<double>, 3>& b);

/// Whether two triangles are certainly farther from each other than this: a plane between them, one
/// of those that separate any two triangles that do not meet, has room for it. Coordinates are at
/// most about 4; allows for rounding.
[[nodiscard]] bool areFartherApart(const std::array<Vec3<double>, 3>& a,
                                   const std::array<Vec3<double>, 3>& b, double distance);

/// The order of two triangles along an axis: 1 if `b` lies above `a` where one is above the other,
/// -1 if below; 0 if nowhere, or if they touch in all these places. Triangles that pass through
/// each other have none.
///
/// Exact; see ExactPredicates.hpp, also for the scaling. Of one without area, what it is along the
/// axis that counts are its edges.
[[nodiscard]] int orderAlong(const std::array<Vec3<double>, 3>& a,
                             const std::array<Vec3<double>, 3>& b, int axis);

/// Returns false if the three points are collinear; exact.
[[nodiscard]] bool hasArea(const std::array<Vec3<double>, 3>& triangle);

}  // namespace cutwater
