#pragma once

#include <Cutwater/CutCells/Detail/Faces/EdgeLoops.hpp>

namespace cutwater {

/// Loops that together have the edges that are left of polygons, and others that cancel each other,
/// with as little area as can be found.
///
/// Where two planes are nearly parallel, the places of their common line are known less well than
/// other points, and polygons on both sides of it may end in edges that are far more than rounding
/// apart. Edges whose ends are close are paired, and each pair becomes a loop of its own: closer
/// than a distance that grows until nothing but thin loops is left.
[[nodiscard]] std::vector<EdgeLoops::Loop> thinLoops(EdgeLoops edges);

}  // namespace cutwater
