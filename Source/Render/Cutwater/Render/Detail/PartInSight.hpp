#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/Detail/SurfaceSample.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <optional>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// The part of a frame in which anything is visible, with a small margin, found by a few thousand
/// rays; nothing if no ray sees anything.
[[nodiscard]] std::optional<Frame> partInSight(SampleTracer trace, const Frame& frame,
                                               const ParallelOptions& options);

/// The part of a frame in which the corners of the solid's surface are; nothing if that does not
/// consist of flat pieces. A solid by winding numbers lies within the convex hull of its sheets,
/// unless several of them are one behind the other.
template <std::floating_point T>
[[nodiscard]] std::optional<Frame> partOfFacets(const SignedDistanceFunction<T>& solid,
                                                const Camera& camera, const Frame& frame);

extern template std::optional<Frame> partOfFacets(const SignedDistanceFunction<float>&,
                                                  const Camera&, const Frame&);
extern template std::optional<Frame> partOfFacets(const SignedDistanceFunction<double>&,
                                                  const Camera&, const Frame&);

}  // namespace cutwater::detail
