#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <limits>
#include <span>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// A point of a picture, in its continuous pixel coordinates.
struct PicturePoint {
  double x, y;
};

/// What a ray sees.
struct SurfaceSample {
  /// Surfaces with this bit set are faces of cut planes, others are patches.
  static constexpr std::uint32_t kCutFace = 0x80000000U;

  double along = std::numeric_limits<double>::infinity();  ///< distance along the ray
  Vec3<float> normal;                                      ///< unit, towards the viewer
  float open = 1;                 ///< fraction of ambient light that arrives, 0 to 1
  std::uint32_t surface = kNone;  ///< visible surface: kNone, a patch, or a face of a cut
  /// For a ray that sees nothing: the patch that it nearly meets; the normal then points from that
  /// patch to the ray.
  std::uint32_t passed = kNone;

  [[nodiscard]] bool isHit() const { return surface != kNone; }
  [[nodiscard]] bool isCut() const { return isHit() && (surface & kCutFace) != 0; }
};

/// How rays lie in the picture.
struct RaySpread {
  double spacing = 1;     ///< distance between neighbours, in pixels
  std::size_t group = 1;  ///< so many rays follow one another of which none need record what it
                          ///< passes if another one sees something
};

/// Samples at most kMostRays points of the picture, most efficiently if they are close to each
/// other.
inline constexpr std::size_t kMostRays = 256;
using SampleTracer = FunctionRef<void(std::span<const PicturePoint> points, const RaySpread& spread,
                                      std::span<SurfaceSample> samples)>;

/// Computes how open the surfaces are that at most kMostRays samples see or nearly meet.
using SampleLighter =
    FunctionRef<void(std::span<const PicturePoint> points, std::span<SurfaceSample> samples)>;

}  // namespace cutwater::detail
