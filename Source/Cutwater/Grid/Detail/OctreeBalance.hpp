#pragma once

#include <Cutwater/Grid/Detail/MortonCode.hpp>
#include <Cutwater/Grid/Octree.hpp>

namespace cutwater::detail {

/// Codes of cells of one level, in order.
using OctreeCodes = std::vector<MortonCode>;

/// Adds to the divided cells of each level, `divided[level]`, the fewest that balance the mesh: a
/// cell's children exist if it is divided, and then all cells of the level above that hold one of
/// its neighbours must be divided, too. (Sundar, Sampath and Biros 2008, "Bottom-up construction
/// and 2:1 balance refinement of linear octrees in parallel"; here level by level from the finest
/// up.)
template <std::floating_point T>
void balanceOctree(const OctreeDomain<T>& domain, Balance balance,
                   std::vector<OctreeCodes>& divided);

}  // namespace cutwater::detail
