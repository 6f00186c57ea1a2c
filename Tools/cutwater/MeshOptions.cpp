#include "MeshOptions.hpp"

#include <CLI/CLI.hpp>
#include <map>

#include "Arguments.hpp"
#include "MeshFields.hpp"

namespace cutwater::tool {

namespace {

const std::map<std::string, Balance> kBalances{{"none", Balance::None},
                                               {"face", Balance::Face},
                                               {"edge", Balance::Edge},
                                               {"corner", Balance::Corner}};

}  // namespace

void addMeshOptions(CLI::App& command, MeshOptions& options) {
  options.roots.cells = {16};
  addRefinementOptions(command, options.refinement);
  command
      .add_option_function<std::string>(
          "--roots",
          [&](const std::string& text) {
            options.roots.cells = sizes("--roots", text);
            if (options.roots.cells.size() != 1) refuse("--roots", text, "one number");
          },
          "Cubes of level 0, N along the longest side; without it: 16")
      ->type_name("N");
  addPlaceOptions(command, options.roots);
  command
      .add_option("--balance", options.balance,
                  "Neighbours that differ by one level at most: across what; without it: corner")
      ->transform(CLI::CheckedTransformer(kBalances))
      ->type_name("none|face|edge|corner")
      ->option_text("none|face|edge|corner");
  command
      .add_option(
          "--write", options.write,
          "Values of each cell, at its centre: class is 0 inside, 1 outside, 2 cut, 3 "
          "unknown; normal and patch are those of the closest surface point; patches are all "
          "that meet the cell, bit n of the number for patch n of the first 64; without it: "
          "distance,class,level")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(MeshFields::names()))
      ->type_name("distance,normal,patch,patches,class,level");
}

OctreeDomain<double> domainAround(const Box<double>& surface, const GridRequest& request) {
  const auto roots = gridAround(surface, request);
  const auto& n = roots.indices.hi;
  return {roots.level.origin(), roots.level.spacing().x, {n.i + 1, n.j + 1, n.k + 1}};
}

}  // namespace cutwater::tool
