#pragma once

#include <Cutwater/Core/OrientedBox.hpp>
#include <Cutwater/Sdf/SurfacePoint.hpp>

namespace cutwater::detail {

/// Visits the surface points nearest to a few points of a box, if they lie in it or nearly so.
template <std::floating_point T>
void sampleFacets(FunctionRef<SurfacePoint<T>(const Vec3<T>&)> closestPoint,
                  const OrientedBox<T>& box, FacetVisitor<T> visit);

}  // namespace cutwater::detail
