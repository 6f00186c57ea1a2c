#include <Cutwater/Sdf/Detail/FacetSamples.hpp>

#include <cmath>

namespace cutwater::detail {

namespace {

/// Whether the box contains the point, or misses it by no more than `margin`.
template <std::floating_point T>
bool contains(const OrientedBox<T>& box, const Vec3<T>& p, T margin) {
  const Vec3<T> d = p - box.center;
  for (const auto& half : box.halfAxis) {
    const T size = length(half);
    if (std::abs(dot(half, d)) > size * (size + margin)) return false;
  }
  return true;
}

}  // namespace

template <std::floating_point T>
void sampleFacets(FunctionRef<SurfacePoint<T>(const Vec3<T>&)> closestPoint,
                  const OrientedBox<T>& box, FacetVisitor<T> visit) {
  const T margin = box.slack + box.radius() / 64;
  for (int n = 0; n < 27; ++n) {
    // Midpoints of 27 parts.
    const auto along = [](int i) { return static_cast<T>(i - 1) * (T(2) / 3); };
    const auto p = box.center + along(n % 3) * box.halfAxis[0] +
                   along(n / 3 % 3) * box.halfAxis[1] + along(n / 9) * box.halfAxis[2];
    const auto hit = closestPoint(p);
    if (!isFinite(hit.point) || !std::isfinite(hit.distance)) continue;
    if (!contains(box, hit.point, margin + (hit.exact ? T(0) : hit.tolerance))) continue;
    const SurfaceFacet<T> facet{{hit.point, hit.point, hit.point}, hit.normal, {}, hit.owner};
    if (!visit(facet)) return;
  }
}

template void sampleFacets(FunctionRef<SurfacePoint<float>(const Vec3<float>&)>,
                           const OrientedBox<float>&, FacetVisitor<float>);
template void sampleFacets(FunctionRef<SurfacePoint<double>(const Vec3<double>&)>,
                           const OrientedBox<double>&, FacetVisitor<double>);

}  // namespace cutwater::detail
