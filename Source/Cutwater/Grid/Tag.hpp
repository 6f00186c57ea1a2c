#pragma once

#include <Cutwater/Core/GridView.hpp>
#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/Refinement.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// Options of tag().
struct TagOptions {
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// Tags the cells of a grid patch that should be refined with 1, the others with 0; `level` is the
/// number of its level in the hierarchy. A cell's tag depends on that cell alone, not on the grid
/// patch, and agrees with what Octree decides. Serial inside an active parallel region.
/// @throws Error as Refinement::check(), or if `level` or `threads` is negative.
template <std::floating_point T>
void tag(const Refinement<T>& refinement, const SignedDistanceFunction<T>& solid,
         const GridPatch<T>& gridPatch, int level, const GridView<std::uint8_t>& tags,
         const TagOptions& options = {});

extern template void tag(const Refinement<float>&, const SignedDistanceFunction<float>&,
                         const GridPatch<float>&, int, const GridView<std::uint8_t>&,
                         const TagOptions&);
extern template void tag(const Refinement<double>&, const SignedDistanceFunction<double>&,
                         const GridPatch<double>&, int, const GridView<std::uint8_t>&,
                         const TagOptions&);

}  // namespace cutwater
