#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/SurfaceSample.hpp>

#include <optional>

/// How render() works inside; for its parts only.
namespace cutwater::detail {

/// The part of a frame in which anything is seen, found by a few thousand rays, and a little more;
/// nothing if there is none.
[[nodiscard]] std::optional<Frame> partInSight(SampleTracer trace, const Frame& frame,
                                               const ParallelOptions& options);

}  // namespace cutwater::detail
