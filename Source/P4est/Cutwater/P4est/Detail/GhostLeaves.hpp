// Includes p8est.h.
#pragma once

#include <Cutwater/Grid/Octree.hpp>

#include <p8est.h>

namespace cutwater::detail {

/// The lower corner of a tree of a brick, in roots.
[[nodiscard]] Index3 rootOf(const p8est_t& forest, p4est_topidx_t tree);
/// The index on its level of a quadrant in a tree with this root.
[[nodiscard]] Index3 indexIn(const Index3& root, const p8est_quadrant_t& quadrant);

/// A rank's leaves with those of other ranks that touch them, in the order of all leaves.
struct LeavesWithGhosts {
  std::vector<OctreeCell> cells;
  std::vector<std::uint64_t> numbers;  ///< of each, among the leaves of all ranks
  std::uint32_t firstOwn = 0;          ///< the rank's own are one after the other
};

/// Finds them, in as many layers as cut leaves need. Collective. `own`: the rank's leaves.
[[nodiscard]] LeavesWithGhosts leavesWithGhosts(p8est_t& forest, Balance balance,
                                                std::span<const OctreeCell> own);

}  // namespace cutwater::detail
