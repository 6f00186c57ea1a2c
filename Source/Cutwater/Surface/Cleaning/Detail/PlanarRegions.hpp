#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater::detail {

using Loop = std::vector<std::uint32_t>;

/// Triangles between loops of points in a plane, and how the loops lie.
struct PlanarFilling {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< each loop runs along their boundary
  std::vector<bool> left;  ///< per loop: not filled, it meets itself or another, or is within such
  std::vector<std::uint32_t> parents;  ///< per loop: the smallest around it, or kNone
  std::vector<bool> isHole;            ///< per loop: a hole in its parent's region
};

/// Fills loops of points in a plane, seen along `axis`, which must not lie in the plane. A loop is
/// the boundary of a region of its own, unless the smallest loop around it is such a boundary and
/// runs the other way: then it is a hole in that region. Triangles face the side from which their
/// region's boundary runs counter-clockwise.
///
/// Holes are joined to the boundary around them, from right to left (Eberly, "Triangulation by ear
/// clipping", 2002); clipEars() cuts what results, and flipToDelaunay() makes the best of that.
///
/// Decisions are exact, for positions of any size; those of no loop may be anywhere. n log n to
/// find what meets, and the number of loops times n for their nesting and joining.
[[nodiscard]] PlanarFilling fillLoops(std::span<const Vec3<double>> positions,
                                      std::span<const Loop> loops, int axis);

}  // namespace cutwater::detail
