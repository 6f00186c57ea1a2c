#pragma once

#include <Cutwater/Grid/Refinement.hpp>

#include <string>

namespace CLI {
class App;
}

namespace cutwater::tool {

/// What `cutwater amr` refines, as it is told.
struct RefinementOptions {
  struct Patch {
    std::string name;
    int level;
  };

  Refinement<double> rules;    ///< all but those of patches
  std::vector<Patch> patches;  ///< by name; repeated names are one patch's
};

/// Adds --level, --band, --patch, --curvature, --edges, --gaps and --walls. `options` must live as
/// long as the command.
void addRefinementOptions(CLI::App& command, RefinementOptions& options);

/// All rules, for a solid with these patches.
/// @throws Error if a patch has none of these names.
[[nodiscard]] Refinement<double> rulesFor(const RefinementOptions& options,
                                          const std::vector<std::string>& patchNames);

}  // namespace cutwater::tool
