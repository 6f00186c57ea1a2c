#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Mesh/ConnectedShells.hpp>
#include <Cutwater/Mesh/OpenEdges.hpp>

namespace cutwater {

/// How shells within other closed shells are to be oriented.
enum class NestedShells : std::uint8_t {
  /// A shell that stands against the one around it is a cavity and stays one.
  AsTheyAre,
  /// By turns: the outermost are solids, what is within one shell is a cavity, within two a solid.
  Cavities,
  /// All face outward: parts of an assembly, whose union is meant.
  Solids,
};

/// Triangles each of which agrees with those around which way to look, as far as they can.
struct AgreeingTriangles {
  std::span<const Vec3<double>>
      positions;  ///< about 1 in size: volumes neither over- nor underflow
  std::span<const std::array<std::uint32_t, 3>> triangles;
  const ConnectedShells& shells;
  std::span<const OpenEdge> openEdges;
};

/// The shells that stand inside out and are to be turned as a whole, ascending: see orientShells().
[[nodiscard]] std::vector<std::uint32_t> insideOutShells(
    const AgreeingTriangles& surface, NestedShells nested = NestedShells::AsTheyAre);

}  // namespace cutwater
