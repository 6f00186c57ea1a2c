#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// Triangles connected across edges of any kind, and the shell that each is part of.
struct ConnectedShells {
  std::vector<std::uint32_t> shellOf;         ///< per triangle
  std::vector<std::uint32_t> firstTriangles;  ///< the lowest of each shell, ascending
};

/// `neighbours` as for findOpenEdges(), where they are optional, too. Almost linear time.
[[nodiscard]] ConnectedShells connectShells(
    std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertexCount,
    std::span<const std::array<std::uint32_t, 3>> neighbours = {});

}  // namespace cutwater
