#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/Detail/PictureStyle.hpp>
#include <Cutwater/Render/Detail/SurfaceSample.hpp>

#include <vector>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// How open samples are: computed at every `spacing`-th pixel along both axes, and between those
/// interpolated from the ones on the same surface; computed where there is none. With a spacing of
/// 1, always computed.
class SparseLight {
 public:
  /// `light` computes how open samples are. It and the camera must outlive this object.
  SparseLight(const Camera& camera, const PlotArea& area, int spacing, SampleLighter light)
      : camera_(camera), area_(area), spacing_(spacing), light_(light) {}

  /// Computes those from which others are interpolated. `middles`: samples in the middle of the
  /// area's pixels, row by row.
  void prepare(std::span<const SurfaceSample> middles, const ParallelOptions& options);

  /// Sets how open the samples at these points of the picture are; at most kMostRays.
  void light(std::span<const PicturePoint> points, std::span<SurfaceSample> samples) const;

 private:
  [[nodiscard]] PlotArea nodes() const;
  [[nodiscard]] PicturePoint place(int column, int row) const;
  [[nodiscard]] bool isInterpolated(const PicturePoint& at, SurfaceSample& sample) const;
  [[nodiscard]] bool areOneSheet(const SurfaceSample& a, const PicturePoint& atA,
                                 const SurfaceSample& b, const PicturePoint& atB) const;

  const Camera& camera_;
  PlotArea area_;
  int spacing_;
  SampleLighter light_;
  std::vector<SurfaceSample> nodes_;  // row by row
};

}  // namespace cutwater::detail
