#include "MeshOptions.hpp"

#include <CLI/CLI.hpp>
#include <map>

#include "Arguments.hpp"

namespace cutwater::tool {

namespace {

const std::map<std::string, Balance> kBalances{{"none", Balance::None},
                                               {"face", Balance::Face},
                                               {"edge", Balance::Edge},
                                               {"corner", Balance::Corner}};

/// "DISTANCE:LEVEL"
Refinement<double>::Band bandOf(const std::string& text) {
  const auto colon = text.find(':');
  const auto level = text.substr(colon == std::string::npos ? text.size() : colon + 1);
  if (level.empty() || level.find_first_not_of("0123456789") != std::string::npos ||
      level.size() > 2) {
    refuse("--band", text, "a distance and a level: 0.5:4");
  }
  const double distance = numbers("--band", text.substr(0, colon), 1).front();
  if (distance < 0) refuse("--band", text, "a distance from 0");
  return {distance, std::stoi(level)};
}

void addRefinement(CLI::App& command, MeshOptions& options) {
  command
      .add_option("--level", options.refinement.cut,
                  "Refine what the surface meets to this level: so many halvings of the roots")
      ->required()
      ->check(CLI::Range(0, 20))
      ->type_name("N");
  command
      .add_option_function<std::vector<std::string>>(
          "--band",
          [&](const std::vector<std::string>& texts) {
            for (const auto& text : texts) options.refinement.bands.push_back(bandOf(text));
          },
          "Refine what is within this distance of the surface, in its units, to that level; may be "
          "repeated")
      ->allow_extra_args(false)
      ->type_name("DISTANCE:LEVEL");
}

}  // namespace

void addMeshOptions(CLI::App& command, MeshOptions& options) {
  options.roots.cells = {16};
  addRefinement(command, options);
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
      .add_option("--write", options.write,
                  "Values of each cell, at its centre: class is 0 inside, 1 outside, 2 cut, 3 "
                  "unknown; normal and patch are those of the closest surface point; without it: "
                  "distance,class,level")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"distance", "normal", "patch", "class", "level"}))
      ->type_name("distance,normal,patch,class,level");
}

OctreeDomain<double> domainAround(const Box<double>& surface, const GridRequest& request) {
  const auto roots = gridAround(surface, request);
  const auto& n = roots.indices.hi;
  return {roots.level.origin(), roots.level.spacing().x, {n.i + 1, n.j + 1, n.k + 1}};
}

}  // namespace cutwater::tool
