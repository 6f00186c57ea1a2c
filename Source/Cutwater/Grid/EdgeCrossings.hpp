#pragma once

#include <Cutwater/Core/GridView.hpp>
#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// Arrays for the edges along one axis; those without data are skipped. The edge at a node's index
/// leads from that node to the next one on the axis: there is one edge fewer than nodes along it.
template <std::floating_point T>
struct EdgeCrossingTargets {
  /// Number of crossings with the surface: odd exactly if the values at the nodes differ in sign.
  GridView<std::uint32_t> count = {};
  /// Coordinate, along the axis, of the first and the last crossing, between those of the nodes;
  /// NaN where there is none. The two are equal where there is only one crossing.
  GridView<T> first = {};
  GridView<T> last = {};
  /// Patches at these crossings, see patchNames(); kNone where there is no crossing.
  GridView<std::uint32_t> firstPatch = {};
  GridView<std::uint32_t> lastPatch = {};
};

/// Options of edgeCrossings().
struct EdgeCrossingOptions {
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// What edgeCrossings() found.
struct EdgeCrossingReport {
  std::size_t crossed = 0;  ///< edges with at least one crossing
  /// Edges that come so close to the surface that an even number of further crossings could not be
  /// excluded: see CrossingCount.
  std::size_t unresolved = 0;
};

/// Finds the crossings of the surface with all edges between neighbouring nodes of a grid patch, as
/// SignedDistanceFunction::crossings() reports them for each edge. `targets`: for the edges along
/// x, y and z. An edge's values depend on the edge alone, not on the grid patch or the number of
/// threads. Edges in boxes that classify() proves free of surface are not queried, so the cost is
/// that of the edges near the surface. Serial inside an active parallel region.
/// @throws Error if the level is not one of nodes, or `threads` is negative.
template <std::floating_point T>
EdgeCrossingReport edgeCrossings(const SignedDistanceFunction<T>& solid,
                                 const GridPatch<T>& gridPatch,
                                 const std::array<EdgeCrossingTargets<T>, 3>& targets,
                                 const EdgeCrossingOptions& options = {});

extern template EdgeCrossingReport edgeCrossings(const SignedDistanceFunction<float>&,
                                                 const GridPatch<float>&,
                                                 const std::array<EdgeCrossingTargets<float>, 3>&,
                                                 const EdgeCrossingOptions&);
extern template EdgeCrossingReport edgeCrossings(const SignedDistanceFunction<double>&,
                                                 const GridPatch<double>&,
                                                 const std::array<EdgeCrossingTargets<double>, 3>&,
                                                 const EdgeCrossingOptions&);

}  // namespace cutwater
