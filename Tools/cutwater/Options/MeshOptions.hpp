#pragma once

#include <Cutwater/Grid/Octree.hpp>

#include "Options/Command.hpp"
#include "Options/RefinementOptions.hpp"
#include "Options/SampleGrid.hpp"

namespace cutwater::tool {

/// The options that describe an octree mesh around a surface.
struct MeshOptions {
  GridRequest roots;
  RefinementOptions refinement;
  Balance balance = Balance::Corner;
  std::vector<std::string> write{"distance", "class", "level"};
};

/// Adds the rules of refinement, --roots, --box, --margin, --balance and --write. `options` must
/// outlive the command.
void addMeshOptions(Command command, MeshOptions& options);

/// @throws Error as gridAround().
/// @throws UsageError for an option with a level that is too fine for so many roots.
[[nodiscard]] OctreeDomain<double> domainAround(const Box<double>& surface,
                                                const MeshOptions& options);

}  // namespace cutwater::tool
