#pragma once

#include <Cutwater/Core/OrientedBox.hpp>
#include <Cutwater/Sdf/SurfacePoint.hpp>

#include <array>

namespace cutwater {

/// A flat piece of a surface: a triangle, or a single sample point, with all three corners equal.
template <std::floating_point T>
struct SurfaceFacet {
  std::array<Vec3<T>, 3> corners;
  Vec3<T> normal;  ///< unit vector, out of the solid; zero if undefined
  /// Normals of the facets across the edges from corner 0 to 1, 1 to 2 and 2 to 0. Zero for edges
  /// that cannot meet the box of the query, and where there is no facet.
  std::array<Vec3<T>, 3> across;
  SurfaceOwner owner;
};

/// Called with one facet after the other, in any order; returns whether to continue.
template <std::floating_point T>
using FacetVisitor = FunctionRef<bool(const SurfaceFacet<T>&)>;

}  // namespace cutwater
