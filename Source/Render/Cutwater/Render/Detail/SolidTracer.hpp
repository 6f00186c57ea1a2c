#pragma once

#include <Cutwater/Render/Detail/SolidParts.hpp>
#include <Cutwater/Render/Detail/SphereTracer.hpp>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// Finds what rays see of a solid: each of its parts by a tracer of its own, and the nearest
/// counts.
template <std::floating_point T>
class SolidTracer {
 public:
  /// `parts`: those of the solid in the region's box. In the options, facets and patches are
  /// theirs. Solid, parts, region and camera must outlive the tracer.
  SolidTracer(const SignedDistanceFunction<T>& solid, std::span<const SolidPart<T>> parts,
              const KeptRegion& region, const Camera& camera, TraceOptions options);

  /// As SphereTracer::trace(); `samples` need not be set.
  void trace(std::span<const PicturePoint> points, const RaySpread& spread,
             std::span<SurfaceSample> samples) const;

  /// As SphereTracer::light(), by the values of the whole solid.
  void light(std::span<const PicturePoint> points, std::span<SurfaceSample> samples) const {
    whole_.light(points, samples);
  }

  /// Whether rays have bounds on the distance to the surface, and so detect what they pass.
  [[nodiscard]] bool knowsDistances() const { return whole_.knowsDistances(); }

 private:
  std::vector<SphereTracer<T>> tracers_;
  SphereTracer<T> whole_;
};

extern template class SolidTracer<float>;
extern template class SolidTracer<double>;

}  // namespace cutwater::detail
