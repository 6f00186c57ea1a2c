#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <vector>

namespace cutwater {

/// Joins convex polygons that lie in one plane, where two have an edge in common and are convex
/// together: what planes through other triangles have divided. Corners at which a joined polygon
/// goes straight on are taken away.
void joinConvex(std::vector<std::vector<Vec3<double>>>& polygons);

}  // namespace cutwater
