#pragma once

#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <string>

namespace cutwater::tool {

/// What a mesh for finite volumes is, and what OpenFOAM's checkMesh would say of it.
struct FluidMeshTotals {
  explicit FluidMeshTotals(const FluidMesh& of, int threads = 0)
      : mesh(of), found(check(of, threads)) {}

  [[nodiscard]] std::string json(const std::string& input, double seconds) const;
  /// Lines for people.
  [[nodiscard]] std::string text() const;

  const FluidMesh& mesh;
  FluidMeshReport found;
};

}  // namespace cutwater::tool
