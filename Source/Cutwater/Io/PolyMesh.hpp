#pragma once

#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <filesystem>

namespace cutwater {

/// Options of writePolyMesh().
struct PolyMeshOptions {
  /// Numbers as they lie in memory instead of text: for programs of OpenFOAM with labels of 32 bits
  /// and scalars of 64, as most are built.
  bool binary = false;
};

/// Writes the mesh of an OpenFOAM case: the files points, faces, owner, neighbour and boundary in
/// constant/polyMesh of its folder, and cellZones with a zone for each region, "region0",
/// "region1", ..., if there are several. Walls are patches of type wall, others of type patch;
/// names of patches have '_' where OpenFOAM allows no such character, and a number at their end if
/// another one has that name. Zones of an earlier mesh are removed, and each file appears once it
/// is complete.
/// @throws Error(File) naming the path if a file cannot be written.
void writePolyMesh(const std::filesystem::path& caseFolder, const FluidMesh& mesh,
                   const PolyMeshOptions& options = {});

}  // namespace cutwater
