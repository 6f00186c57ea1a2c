#pragma once

#include <Cutwater/Core/Detail/DoubleDouble.hpp>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace cutwater {

/// A side of a triangle among those at one edge.
struct SideAtEdge {
  std::uint32_t side = 0;  ///< whatever tells it from others
  bool isForward = false;  ///< whether it runs along the edge's direction
  DoubleDouble3 way;       ///< from a point of the edge to the triangle's third corner
};

/// Pairs sides, as many forward as backward, such that the two triangles of a pair bound the same
/// wedge of fluid at the edge, or of body where they overlap: in the order of their angles around
/// the edge, decided exactly, each one behind which the fluid begins with the next at which it
/// ends. Where angles are equal, fluid and body take turns.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> pairedAround(
    const DoubleDouble3& direction, std::vector<SideAtEdge> sides);

}  // namespace cutwater
