#pragma once

#include <Cutwater/Render/Occlusion.hpp>
#include <Cutwater/Render/Sighting.hpp>

/// How render() works inside; for its parts only.
namespace cutwater::detail {

struct TraceOptions {
  bool sheets = false;         ///< see RenderOptions
  double occlusionRadius = 0;  ///< how far to look for what keeps light away; 0: not at all
};

/// Finds what rays see of a solid.
///
/// J. C. Hart, "Sphere tracing", The Visual Computer 12 (1996): a step as long as the surface is
/// certainly away never passes through it. By the guarantee this is the value itself where it is a
/// distance or a lower bound of one, and the value over the Lipschitz constant where there is one.
/// A ray that comes within 1/40 of a pixel (1/320 where values are mere bounds) has arrived; the
/// tangent plane at the nearest surface point tells where it meets the surface. Steps are shorter
/// by what rounding may do to a value, unless that is more than 1/4 of a pixel: of a solid so far
/// from the origin, parts thinner than rounding may be lost. A ray that needs more than kMostSteps
/// asks crossings() about its rest; so do all rays if the values tell nothing.
template <std::floating_point T>
class SphereTracer {
 public:
  static constexpr int kMostSteps = 256;

  /// Solid, region and camera must live as long as the tracer.
  SphereTracer(const SignedDistanceFunction<T>& solid, const KeptRegion& region,
               const Camera& camera, const TraceOptions& options);

  /// For at most kMostRays points of the picture, best close to each other. Samples that see
  /// nothing tell whether the solid comes within about half of `spacing`, the distance between the
  /// picture's points in pixels, so that it may hide between them.
  void trace(std::span<const PicturePoint> points, double spacing,
             std::span<SurfaceSample> samples) const;

  /// Whether rays know how far the surface is, and so what they pass.
  [[nodiscard]] bool knowsDistances() const { return distance_.isKnown(); }

 private:
  class Packet;

  const SignedDistanceFunction<T>& solid_;
  const KeptRegion& region_;
  const Camera& camera_;
  TraceOptions options_;
  CertainDistance<T> distance_;
  Occlusion<T> occlusion_;
  Sighting<T> sighting_;
  double nearEnough_;  // in pixels
};

extern template class SphereTracer<float>;
extern template class SphereTracer<double>;

}  // namespace cutwater::detail
