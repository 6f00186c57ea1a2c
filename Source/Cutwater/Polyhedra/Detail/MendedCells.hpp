#pragma once

#include <Cutwater/Polyhedra/FluidMesh.hpp>

namespace cutwater {

/// What may be done to mend a mesh.
struct MendingRules {
  /// Whether cells are joined, and walls; else cells are divided only, for faces that are seen from
  /// behind.
  bool joins = true;
  /// Whether, where nothing else helps, what two walls of a cell have of a sheet in common is left
  /// out: of walls that are only near to the solid's, see CutOptions::polygons.
  bool joinsSides = false;
  int threads = 0;  ///< that look for faces to mend
};

/// Joins and divides cells beside faces that OpenFOAM's checkMesh objects to: seen from behind from
/// the center of a cell, too skew, or far from orthogonal; and cells that are flat. Two cells
/// become one, two walls of one patch in a cell one face, and a cell two by a plane, of which one
/// may be joined to a neighbour: whatever leaves the least of such faces. Area vectors stay exact.
/// @returns the mesh; faces that nothing of this mends are as they were.
[[nodiscard]] FluidMesh withMendedCells(FluidMesh mesh, const MendingRules& rules);

}  // namespace cutwater
