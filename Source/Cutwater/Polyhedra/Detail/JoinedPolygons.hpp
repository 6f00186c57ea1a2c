#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>

#include <vector>

namespace cutwater {

/// Joins polygons that share edges to faces as large as can be whose rims are one loop without a
/// corner twice: one, if the polygons together have such a rim. One that has a corner twice itself
/// is joined to none. `mayJoin(polygon, other)`: whether two that share an edge may be in one face.
/// @returns the rims.
[[nodiscard]] std::vector<CornerLoop> joinedPolygons(
    const std::vector<CornerLoop>& polygons,
    FunctionRef<bool(std::size_t polygon, std::size_t other)> mayJoin);

/// The rims of two polygons that share one chain of edges, each without a corner twice: several, if
/// they share other corners as well.
/// @returns none, unless they share such a chain.
[[nodiscard]] std::vector<CornerLoop> joinedPair(const CornerLoop& polygon,
                                                 const CornerLoop& other);

}  // namespace cutwater
