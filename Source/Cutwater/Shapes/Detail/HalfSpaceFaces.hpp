#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <span>
#include <vector>

namespace cutwater::detail {

/// A half-space: all p with normal . (p - point) <= 0. The length of the normal is arbitrary.
struct ExactHalfSpace {
  Vec3<double> point;
  Vec3<double> normal;
};

/// A face of an intersection of half-spaces: a convex polygon, counterclockwise seen from outside.
struct HalfSpaceFace {
  std::uint32_t plane;
  struct Corner {
    Vec3<double> position;
    std::uint32_t across;  ///< the plane on the other side of the polygon side that starts here
  };
  std::vector<Corner> corners;
};

/// The faces of the intersection, found by clipping each plane with all others in twice the
/// precision; O(n^2) for n half-spaces. Redundant half-spaces, and all but the first of equal ones,
/// have no face.
/// @throws Error naming the shape `name` unless the intersection is bounded and has an interior.
[[nodiscard]] std::vector<HalfSpaceFace> halfSpaceFaces(const char* name,
                                                        std::span<const ExactHalfSpace> halfSpaces);

/// The unit vector along normal x across.
[[nodiscard]] Vec3<double> sideDirection(const Vec3<double>& normal, const Vec3<double>& across);

}  // namespace cutwater::detail
