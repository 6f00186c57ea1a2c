#pragma once

#include <Cutwater/CutCells/Detail/Surface/MovedTriangles.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// A vertex at which walls across an axis face both ways.
struct Saddle {
  std::uint32_t vertex = 0;
  int axis = 0;
};

/// Gives walls at saddles copies of the vertex that are moved to the side to which they face, and
/// closes the gaps between copies by triangles without area. Returns the triangles at vertices in
/// which parts of the surface touch that have copies of their own: moved, these parts overlap.
[[nodiscard]] std::vector<std::uint32_t> splitSaddles(MovedTriangles& triangles,
                                                      std::span<const Saddle> saddles);

}  // namespace cutwater
