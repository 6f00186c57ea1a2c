#pragma once

#include <Cutwater/Core/OrientedBox.hpp>
#include <Cutwater/Sdf/SurfacePoint.hpp>

#include <array>

namespace cutwater {

/// A flat piece of a surface: a triangle; or a mere sample of one, whose corners are one point.
template <std::floating_point T>
struct SurfaceFacet {
  std::array<Vec3<T>, 3> corners;
  Vec3<T> normal;  ///< unit, out of the solid; zero where it has none
  /// Normals of the facets across the edges from corner 0 to 1, 1 to 2 and 2 to 0, of those edges
  /// that may meet the box that was asked about; zero of the others, and where there is no facet.
  std::array<Vec3<T>, 3> across;
  SurfaceOwner owner;
};

/// Is told one facet after the other, in any order; answers whether to go on.
template <std::floating_point T>
using FacetVisitor = FunctionRef<bool(const SurfaceFacet<T>&)>;

namespace detail {

/// Shows the surface points nearest to a few points of a box, as far as they lie in it or almost.
template <std::floating_point T>
void sampleFacets(FunctionRef<SurfacePoint<T>(const Vec3<T>&)> closestPoint,
                  const OrientedBox<T>& box, FacetVisitor<T> visit);

extern template void sampleFacets(FunctionRef<SurfacePoint<float>(const Vec3<float>&)>,
                                  const OrientedBox<float>&, FacetVisitor<float>);
extern template void sampleFacets(FunctionRef<SurfacePoint<double>(const Vec3<double>&)>,
                                  const OrientedBox<double>&, FacetVisitor<double>);

}  // namespace detail

}  // namespace cutwater
