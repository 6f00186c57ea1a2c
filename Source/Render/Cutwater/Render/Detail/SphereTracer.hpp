#pragma once

#include <Cutwater/Render/Detail/Occlusion.hpp>
#include <Cutwater/Render/Detail/Sighting.hpp>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

struct TraceOptions {
  bool sheets = false;         ///< see RenderOptions
  double occlusionRadius = 0;  ///< how far light() looks for occluders
  bool isDraft = false;        ///< rays may also end at the tangent plane within half a pixel
  /// All of the surface in the region, if that consists of flat pieces; otherwise null. Where
  /// values are distances, the first that a ray meets is what it sees.
  const FacetRays* facets = nullptr;
  /// What the solid's patches are called in samples; empty: by their own numbers.
  std::span<const std::uint32_t> patches = {};
};

/// Finds what rays see of a solid.
///
/// J. C. Hart, "Sphere tracing", The Visual Computer 12 (1996): a step no longer than a certain
/// lower bound on the distance to the surface never passes through it. By the guarantee this bound
/// is the value itself where it is a distance or a lower bound of one, and the value over the
/// Lipschitz constant where there is one. A ray that comes within 1/40 of a pixel (1/320 where
/// values are only bounds) has arrived; the tangent plane at the nearest surface point then gives
/// where it meets the surface. Steps are shortened by the possible rounding error of a value,
/// unless that exceeds 1/4 of a pixel: for a solid so far from the origin, parts thinner than the
/// rounding error may be lost. For the rest of a ray that needs more than kMostSteps, crossings()
/// is queried; so it is for all rays if only signs are known. With facets, rays need no steps.
template <std::floating_point T>
class SphereTracer {
 public:
  static constexpr int kMostSteps = 256;

  /// Solid, region and camera must outlive the tracer.
  SphereTracer(const SignedDistanceFunction<T>& solid, const KeptRegion& region,
               const Camera& camera, const TraceOptions& options);

  /// Traces rays through at most kMostRays points of the picture; most efficient if they are close
  /// to each other. Samples that see nothing record whether the solid comes within about half of
  /// the points' spacing, so that it may hide between them.
  ///
  /// `samples` hold what the rays see of other solids. It is replaced by what they see of this one,
  /// if that is nearer; or, if the two are in the same place, of the first patch.
  void trace(std::span<const PicturePoint> points, const RaySpread& spread,
             std::span<SurfaceSample> samples) const;

  /// Computes how open the surfaces are that samples see or nearly meet; most efficient if they are
  /// close to each other.
  void light(std::span<const PicturePoint> points, std::span<SurfaceSample> samples) const;

  /// Whether rays have bounds on the distance to the surface, and so detect what they pass.
  [[nodiscard]] bool knowsDistances() const { return distance_.isKnown(); }

 private:
  class Packet;

  [[nodiscard]] std::uint32_t patchOf(std::uint32_t own) const {
    return own < options_.patches.size() ? options_.patches[own] : own;
  }

  const SignedDistanceFunction<T>& solid_;
  const KeptRegion& region_;
  const Camera& camera_;
  TraceOptions options_;
  CertainDistance<T> distance_;
  Occlusion<T> occlusion_;
  const FacetRays* facets_;
  Sighting<T> sighting_;
  double nearEnough_;  // in pixels
};

extern template class SphereTracer<float>;
extern template class SphereTracer<double>;

}  // namespace cutwater::detail
