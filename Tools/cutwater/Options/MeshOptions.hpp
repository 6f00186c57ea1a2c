#pragma once

#include <Cutwater/Grid/OctreeEstimate.hpp>

#include "Options/Command.hpp"
#include "Options/Limits.hpp"
#include "Options/RefinementOptions.hpp"
#include "Options/SampleGrid.hpp"

namespace cutwater::tool {

/// The options that describe an octree mesh around a surface.
struct MeshOptions {
  GridRequest roots;
  RefinementOptions refinement;
  Balance balance = Balance::Corner;
  Limits limits;
  std::vector<std::string> write{"distance", "class", "level"};
};

/// Adds the rules of refinement, --roots, --box, --margin, --balance, --write, and the limits.
/// `options` must outlive the command.
void addMeshOptions(Command command, MeshOptions& options);
/// Two of them alone.
void addRoots(Command command, MeshOptions& options);
void addBalance(Command command, MeshOptions& options);

/// @throws Error as gridAround().
/// @throws UsageError for an option with a level that is too fine for so many roots.
[[nodiscard]] OctreeDomain<double> domainAround(const Box<double>& surface,
                                                const MeshOptions& options);

/// Memory at its peak, in bytes, for each cell: of the mesh, its values and the file's nodes.
[[nodiscard]] double bytesPerCell(const MeshOptions& options);

/// The most cells that the limits allow on so many machines like this one.
[[nodiscard]] double mostCells(const MeshOptions& options, double bytesPerCell, int machines = 1);

/// Refuses a mesh beyond the limits before it is built, and says on a terminal, if `isShown`, how
/// large it is going to be. `secondsPerValue`: of computing the values of a cell.
/// @throws Error(Limit), which names a level that fits.
void requireRoom(const MeshOptions& options, const OctreeEstimate& mesh, double bytesPerCell,
                 double secondsPerValue, bool isShown, int machines = 1);

}  // namespace cutwater::tool
