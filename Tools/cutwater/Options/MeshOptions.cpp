#include "Options/MeshOptions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "Options/Arguments.hpp"
#include "Options/Choice.hpp"
#include "Report/Format.hpp"
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

void addRoots(Command command, MeshOptions& options) {
  options.roots.cells = {16};
  command.add("--roots", "N", "Cubes of level 0, N along the longest side [default: 16]",
              [&](const std::string& text) {
                options.roots.cells = sizes("--roots", text, kRoots);
                if (options.roots.cells.size() != 1) refuse("--roots", text, kRoots);
              });
}

void addBalance(Command command, MeshOptions& options) {
  addChoice<Balance>(
      command, "--balance", options.balance,
      {{"none", Balance::None},
       {"face", Balance::Face},
       {"edge", Balance::Edge},
       {"corner", Balance::Corner}},
      "Which neighbours differ by at most one level: those that share a face, an edge or a corner "
      "[default: corner]");
}

void addMeshOptions(Command command, MeshOptions& options) {
  addRefinementOptions(command, options.refinement).required();
  addRoots(command, options);
  addPlaceOptions(command, options.roots);
  addBalance(command, options);
  command.addWords(
      "--write", "distance,normal,patch,patches,class,level",
      "Values of each cell, at its centre: class is 0 inside, 1 outside, 2 cut, 3 "
      "unknown; normal and patch are those of the closest surface point; patches are all "
      "that meet the cell, bit n of the number for patch n of the first 64 [default: "
      "distance,class,level]",
      options.write, MeshFields::names());
  addLimits(command, "--max-cells", options.limits);
}

double bytesPerCell(const MeshOptions& options) {
  constexpr std::pair<const char*, double> kBytes[] = {
      {"distance", 8}, {"normal", 24}, {"patch", 4}, {"patches", 8}, {"class", 1}, {"level", 1}};
  double bytes = OctreeEstimate::kBytesPerCell;
  for (const auto& [name, size] : kBytes) {
    bytes += std::ranges::count(options.write, name) > 0 ? size : 0;
  }
  return bytes;
}

double mostCells(const MeshOptions& options, double bytesPerCell, int machines) {
  const double most = machines * options.limits.mostBytes() / bytesPerCell;
  return std::floor(std::min(most, options.limits.items.value_or(most)));
}

void requireRoom(const MeshOptions& options, const OctreeEstimate& mesh, double bytesPerCell,
                 double secondsPerValue, bool isShown, int machines) {
  const double cells = mesh.cells();
  const Expected expected{.what = "cells",
                          .items = cells,
                          .bytes = cells * bytesPerCell / machines,
                          .seconds = mesh.seconds() + cells * secondsPerValue};
  requireWithin(options.limits, expected, isShown, [&] {
    const int level = mesh.finestWithin(mostCells(options, bytesPerCell, machines));
    if (level < 0) return std::string("use fewer --roots");
    const bool isAlone = options.refinement.rules.cut == mesh.deepest();
    const double fewer = rounded(mesh.cells(level), 3);
    return (isAlone ? "--level " : "no rule beyond level ") + std::to_string(level) +
           " fits, with about " + grouped(static_cast<std::size_t>(fewer), "cell");
  });
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
