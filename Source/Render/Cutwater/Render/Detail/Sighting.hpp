#pragma once

#include <Cutwater/Render/CutPlane.hpp>
#include <Cutwater/Render/Detail/FacetRays.hpp>
#include <Cutwater/Render/Detail/SurfaceSample.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// Determines what rays see, from the results of queries about the surface near them.
template <std::floating_point T>
class Sighting {
 public:
  /// Solid, region and camera must outlive this object. `sheets`: see RenderOptions.
  Sighting(const SignedDistanceFunction<T>& solid, const KeptRegion& region, const Camera& camera,
           bool sheets)
      : solid_(solid), region_(region), camera_(camera), sheets_(sheets) {}

  /// The face of the cut through which a ray enters.
  [[nodiscard]] SurfaceSample atCut(const RayRange& range) const;
  /// The surface that a ray crosses at this distance along it.
  [[nodiscard]] SurfaceSample atCrossing(const Ray& ray, double along,
                                         const Crossing<T>& crossing) const;
  /// The facet that a ray meets.
  [[nodiscard]] static SurfaceSample atFacet(const Ray& ray, const FacetHit& hit);
  /// For a ray that is near enough to the surface at this distance along it; `nearest` is the
  /// surface point nearest to there.
  [[nodiscard]] SurfaceSample near(const Ray& ray, const RayRange& range, double along,
                                   const SurfacePoint<T>& nearest) const;
  /// For a ray that sees nothing. Empty if the surface is farther than `reach`, in pixels, or cut
  /// away.
  [[nodiscard]] SurfaceSample passing(const Ray& ray, const FacetPass& nearest, double reach) const;

  /// Distance, in pixels, within which two sheets coincide, or a point beyond a cut still counts as
  /// on it.
  static constexpr double kSamePlace = 1e-3;

 private:
  [[nodiscard]] std::uint32_t patchAt(const Vec3<T>& foot, const Vec3<double>& normal,
                                      std::uint32_t patch, const Ray& ray, double along) const;

  const SignedDistanceFunction<T>& solid_;
  const KeptRegion& region_;
  const Camera& camera_;
  bool sheets_;
};

extern template class Sighting<float>;
extern template class Sighting<double>;

}  // namespace cutwater::detail
