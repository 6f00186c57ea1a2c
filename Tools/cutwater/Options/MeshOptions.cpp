#include "Options/MeshOptions.hpp"

#include <algorithm>

#include "Options/Arguments.hpp"
#include "Options/Choice.hpp"
#include "Report/MeshFields.hpp"

namespace cutwater::tool {

namespace {

constexpr const char* kRoots = "one whole number above 0";

void requireLevel(const char* option, int level, const OctreeDomain<double>& domain) {
  if (level <= domain.deepest()) return;
  const auto& n = domain.roots();
  refuse(option, std::to_string(level),
         "a level up to " + std::to_string(domain.deepest()) + ", the finest with " +
             std::to_string(std::max({n.i, n.j, n.k})) + " roots along a side; see --roots");
}

void requireLevels(const RefinementOptions& options, const OctreeDomain<double>& domain) {
  const auto& rules = options.rules;
  requireLevel("--level", rules.cut, domain);
  for (const auto& band : rules.bands) requireLevel("--band", band.level, domain);
  for (const auto& patch : options.patches) requireLevel("--patch", patch.level, domain);
  if (rules.curvature) requireLevel("--curvature", rules.curvature->level, domain);
  if (rules.edges) requireLevel("--edges", rules.edges->level, domain);
  if (rules.gaps) requireLevel("--gaps", rules.gaps->level, domain);
  if (rules.walls) requireLevel("--walls", rules.walls->level, domain);
}

}  // namespace

void addMeshOptions(Command command, MeshOptions& options) {
  options.roots.cells = {16};
  addRefinementOptions(command, options.refinement);
  command.add("--roots", "N", "Cubes of level 0, N along the longest side [default: 16]",
              [&](const std::string& text) {
                options.roots.cells = sizes("--roots", text, kRoots);
                if (options.roots.cells.size() != 1) refuse("--roots", text, kRoots);
              });
  addPlaceOptions(command, options.roots);
  addChoice<Balance>(
      command, "--balance", options.balance,
      {{"none", Balance::None},
       {"face", Balance::Face},
       {"edge", Balance::Edge},
       {"corner", Balance::Corner}},
      "Which neighbours differ by at most one level: those that share a face, an edge or a corner "
      "[default: corner]");
  command.addWords(
      "--write", "distance,normal,patch,patches,class,level",
      "Values of each cell, at its centre: class is 0 inside, 1 outside, 2 cut, 3 "
      "unknown; normal and patch are those of the closest surface point; patches are all "
      "that meet the cell, bit n of the number for patch n of the first 64 [default: "
      "distance,class,level]",
      options.write, MeshFields::names());
}

OctreeDomain<double> domainAround(const Box<double>& surface, const MeshOptions& options) {
  const auto roots = gridAround(surface, options.roots);
  const auto& n = roots.indices.hi;
  const OctreeDomain<double> domain(roots.level.origin(), roots.level.spacing().x,
                                    {n.i + 1, n.j + 1, n.k + 1});
  requireLevels(options.refinement, domain);
  return domain;
}

}  // namespace cutwater::tool
