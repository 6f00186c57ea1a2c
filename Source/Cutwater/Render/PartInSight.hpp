#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/SurfaceSample.hpp>

#include <optional>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// The part of a frame in which anything is visible, with a small margin, found by a few thousand
/// rays; nothing if no ray sees anything.
[[nodiscard]] std::optional<Frame> partInSight(SampleTracer trace, const Frame& frame,
                                               const ParallelOptions& options);

}  // namespace cutwater::detail
