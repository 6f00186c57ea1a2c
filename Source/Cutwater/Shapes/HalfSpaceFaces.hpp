#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <span>
#include <vector>

namespace cutwater::detail {

/// A half-space: all p with normal . (p - point) <= 0. The normal has any length.
struct ExactHalfSpace {
  Vec3<double> point;
  Vec3<double> normal;
};

/// A face of an intersection of half-spaces: a convex polygon, seen from outside counterclockwise.
struct HalfSpaceFace {
  std::uint32_t plane;
  struct Corner {
    Vec3<double> position;
    std::uint32_t across;  ///< the plane on the other side of the polygon's side that begins here
  };
  std::vector<Corner> corners;
};

/// The faces of the intersection, by clipping each plane with all others, in twice the precision;
/// O(n^2) for n half-spaces. Half-spaces that hold no face, and all but the first of equal ones,
/// have none.
/// @throws Error, as from the shape `name`, unless the intersection is bounded and has an inside.
[[nodiscard]] std::vector<HalfSpaceFace> halfSpaceFaces(const char* name,
                                                        std::span<const ExactHalfSpace> halfSpaces);

/// The unit vector along normal x across.
[[nodiscard]] Vec3<double> sideDirection(const Vec3<double>& normal, const Vec3<double>& across);

}  // namespace cutwater::detail
