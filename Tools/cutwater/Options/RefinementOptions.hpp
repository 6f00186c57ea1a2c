#pragma once

#include <Cutwater/Grid/Refinement.hpp>

#include <string>

#include "Options/Command.hpp"

namespace cutwater::tool {

/// The refinement rules given to `cutwater amr`.
struct RefinementOptions {
  struct Patch {
    std::string name;
    int level;
  };

  Refinement<double> rules;    ///< all but those of patches
  std::vector<Patch> patches;  ///< by name; repeated names refer to one patch
};

/// Adds --level, --band, --patch, --curvature, --edges, --gaps and --walls. `options` must outlive
/// the command.
void addRefinementOptions(Command command, RefinementOptions& options);

/// All rules, for a solid with these patches.
/// @throws Error if a patch has none of these names.
[[nodiscard]] Refinement<double> rulesFor(const RefinementOptions& options,
                                          const std::vector<std::string>& patchNames);

}  // namespace cutwater::tool
