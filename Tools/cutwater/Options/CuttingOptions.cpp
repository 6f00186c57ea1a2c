#include "Options/CuttingOptions.hpp"

#include <Cutwater/Core/Error.hpp>

#include <algorithm>

#include "Options/Arguments.hpp"

namespace cutwater::tool {

bool CuttingOptions::areOfSurface() const {
  return cutter.capHoles || !cutter.openPatches.empty() || !cutter.baffles.empty();
}

void addCuttingOptions(Command command, CuttingOptions& options) {
  auto& cutter = options.cutter;
  command.addFlag("--inside", "The fluid is inside the surface that cuts the cells",
                  options.isInside);
  command.addRepeated("--open", "PATCH",
                      "This patch is no wall but open, as inlets and outlets are; it must lie in "
                      "planes of the grid; may be repeated",
                      [&cutter](const std::string& text) { cutter.openPatches.push_back(text); });
  command.addRepeated("--baffle", "PATCH",
                      "This patch is a sheet with fluid and a wall on both sides, and may end "
                      "anywhere; may be repeated",
                      [&cutter](const std::string& text) { cutter.baffles.push_back(text); });
  command.addFlag("--cap-holes", "Close the holes of the surface, by a patch named \"cap\"",
                  cutter.capHoles);
  command.add("--period", "LX,LY,LZ",
              "The solid repeats after these lengths, 0: not along that axis; the grid covers "
              "one period",
              [&cutter](const std::string& text) {
                const auto period = vectorOf("--period", text);
                if (std::min({period.x, period.y, period.z}) < 0 || maxComponent(period) == 0) {
                  refuse("--period", text, "three numbers from 0, one of them above it");
                }
                cutter.period = period;
              });
  command.add(
      "--tolerance", "SHARE",
      "Of a scene's solid: halve cells whose open faces and walls do not close to this share "
      "of a cell [default: 1e-5]",
      [&options](const std::string& text) {
        const std::string need = "a number above 0, and 1 at most";
        const double share = positiveNumber("--tolerance", text, need);
        if (share > 1) refuse("--tolerance", text, need);
        options.tolerance = share;
      });
}

Option addOctreeOptions(Command command, MeshOptions& options) {
  const auto level = addRefinementOptions(command, options.refinement);
  addRoots(command, options);
  addBalance(command, options);
  for (const char* of : {"--cells", "--spacing", "--total"}) command.option(of).excludes(level);
  for (const char* of : {"--band", "--patch", "--curvature", "--edges", "--gaps", "--walls",
                         "--roots", "--balance"}) {
    command.option(of).needs(level);
  }
  return level;
}

void refuseOnOctrees(const CuttingOptions& options) {
  if (!options.hasPeriod()) return;
  throw Error(ErrorKind::Argument, "--period is for grids: octrees, as of --level, do not repeat");
}

void passOn(const CuttingOptions& options, GridRequest& grid, SurfaceOptions& surface) {
  grid.period = options.cutter.period;
  surface.mayBeOpen = options.cutter.capHoles || !options.cutter.baffles.empty();
}

}  // namespace cutwater::tool
