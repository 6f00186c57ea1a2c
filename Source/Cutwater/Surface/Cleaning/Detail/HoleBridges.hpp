#pragma once

#include <Cutwater/Surface/Cleaning/Detail/PlanarRegions.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlanarView.hpp>

namespace cutwater::detail {

/// Joins the boundary of a region and its holes, which run the other way, into one loop: each hole
/// is joined to the rest at a corner that they share, or by an edge passed to and fro that meets no
/// other. Empty if that fails: loops meet, or share more than a corner.
[[nodiscard]] Loop joinHoles(const PlanarView& view, const Loop& boundary, std::vector<Loop> holes);

}  // namespace cutwater::detail
