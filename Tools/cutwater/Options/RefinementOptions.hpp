#pragma once

#include <Cutwater/Grid/Refinement.hpp>

#include <string>

#include "Options/Command.hpp"

namespace cutwater::tool {

/// The refinement rules of `cutwater amr` and `cutwater cells`.
struct RefinementOptions {
  struct Patch {
    std::string name;
    int level;
  };

  Refinement<double> rules;    ///< all but those of patches
  std::vector<Patch> patches;  ///< by name; repeated names refer to one patch
};

/// Adds --level, --band, --patch, --curvature, --edges, --gaps and --walls; returns --level.
/// `options` must outlive the command.
Option addRefinementOptions(Command command, RefinementOptions& options);

/// All rules, for a solid with these patches.
/// @throws Error if a patch has none of these names.
[[nodiscard]] Refinement<double> rulesFor(const RefinementOptions& options,
                                          const std::vector<std::string>& patchNames);

}  // namespace cutwater::tool
