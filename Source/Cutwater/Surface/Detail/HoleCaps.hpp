#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

namespace cutwater {

/// Triangles that close a surface: with them, as many triangles run along each edge one way as the
/// other.
struct HoleCaps {
  std::vector<Vec3<double>> positions;  ///< those of the open edges' vertices, exactly
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Caps the open edges, which always form closed loops: a hole is surrounded by one, and an
/// isolated triangle is one. Loops are halved until only triangles are left, so few of these are
/// large. Caps may pass through the surface and each other. Nearly linear time.
template <std::floating_point T>
[[nodiscard]] HoleCaps capHoles(std::span<const Vec3<T>> positions,
                                std::span<const OpenEdge> edges);

extern template HoleCaps capHoles(std::span<const Vec3<float>>, std::span<const OpenEdge>);
extern template HoleCaps capHoles(std::span<const Vec3<double>>, std::span<const OpenEdge>);

}  // namespace cutwater
