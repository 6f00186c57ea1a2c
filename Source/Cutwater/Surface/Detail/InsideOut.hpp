#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/Detail/ConnectedShells.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

namespace cutwater {

/// Triangles whose orientations agree with those of their neighbours, as far as possible.
struct AgreeingTriangles {
  std::span<const Vec3<double>>
      positions;  ///< about 1 in size: volumes neither over- nor underflow
  std::span<const std::array<std::uint32_t, 3>> triangles;
  const ConnectedShells& shells;
  std::span<const OpenEdge> openEdges;
};

/// Returns the shells that are inside out and must be turned as a whole, ascending: see
/// orientShells().
[[nodiscard]] std::vector<std::uint32_t> insideOutShells(
    const AgreeingTriangles& surface, NestedShells nested = NestedShells::AsTheyAre);

}  // namespace cutwater
