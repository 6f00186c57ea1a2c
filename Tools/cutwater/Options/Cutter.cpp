#include "Options/Cutter.hpp"

#include <Cutwater/Core/Error.hpp>

namespace cutwater::tool {

namespace {

bool isSurface(const Solid<double>& solid) {
  return solid.as<MeshSDF<double>>() != nullptr;
}

std::variant<CellCutter, SolidCutter> cutterOf(const Solid<double>& solid,
                                               const CuttingOptions& options) {
  if (isSurface(solid)) {
    if (options.tolerance) {
      throw Error(ErrorKind::Argument,
                  "--tolerance is for solids that scenes describe: surfaces cut cells exactly");
    }
    return CellCutter(solid, options.side(), options.cutter);
  }
  if (options.areOfSurface()) {
    throw Error(ErrorKind::Argument,
                "--open, --baffle and --cap-holes are for surfaces, and this solid is described by "
                "a scene");
  }
  SolidCutterOptions how;
  how.tolerance = options.tolerance.value_or(how.tolerance);
  how.period = options.cutter.period;
  return SolidCutter(solid, options.side(), how);
}

}  // namespace

Cutter::Cutter(const Solid<double>& solid, const CuttingOptions& options)
    : cutter_(cutterOf(solid, options)) {}

Cutter Cutter::trial(const Solid<double>& solid, const CuttingOptions& options) const {
  if (options.cutter.openPatches.empty() && !options.hasPeriod()) return *this;
  auto simple = options;
  simple.cutter.openPatches.clear();
  simple.cutter.period = {};
  return {solid, simple};
}

}  // namespace cutwater::tool
