#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <cmath>
#include <iostream>
#include <memory>

#include "Commands/Commands.hpp"
#include "Options/Limits.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/OutputFile.hpp"
#include "Options/SampleGrid.hpp"
#include "Report/Format.hpp"
#include "Report/Json.hpp"
#include "Report/OutOfMemory.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct CellsSettings {
  SurfaceOptions surface;
  std::string output;
  std::string json;
  GridRequest grid;
  Limits limits;
  bool isInside = false;
  bool wholeCells = false;
};

/// The surface where it is placed, which every grid that contains it must give again.
struct PlacedSurface {
  Box<double> box;
  SurfaceMeasure measure;
  Vec3<double> projected;  ///< the areas of its shadows along the axes, all sheets counted
  std::size_t triangles = 0;
};

PlacedSurface placedSurface(const MeshSDF<double>& mesh) {
  auto soup = mesh.soup();
  for (auto& p : soup.points) p = mesh.placement().toWorld(p);
  PlacedSurface placed{.box = {}, .measure = measure(soup), .projected = {}, .triangles = 0};
  for (const auto& p : soup.points) placed.box.extend(p);
  placed.triangles = soup.polygonCount();
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto c = soup.polygon(i);
    const auto& a = soup.points[c[0]];
    placed.projected += 0.5 * abs(cross(soup.points[c[1]] - a, soup.points[c[2]] - a));
  }
  return placed;
}

/// Cells that the surface cuts: about as many as its sheets have faces of cells in their shadows.
double expectedCells(const PlacedSurface& placed, const Vec3<double>& size) {
  const auto& shadow = placed.projected;
  return shadow.x / (size.y * size.z) + shadow.y / (size.z * size.x) + shadow.z / (size.x * size.y);
}

/// @throws Error(Limit) if there is no room.
void requireRoom(const CellsSettings& options, const PlacedSurface& placed,
                 const GridPatch<double>& grid) {
  // As measured for hulls, statues and machine parts; parts of triangles count beside cells.
  constexpr double kBytesPerCell = 5000;
  constexpr double kBytesPerTriangle = 1500;
  constexpr double kBytesPerWholeCell = 250;
  const double cut = expectedCells(placed, grid.level.spacing());
  const auto all = static_cast<double>(grid.indices.count());
  const double whole = options.wholeCells ? all : 0;
  const Expected expected{.what = "cells",
                          .items = cut + whole,
                          .bytes = kBytesPerCell * cut + kBytesPerWholeCell * whole +
                                   kBytesPerTriangle * static_cast<double>(placed.triangles)};
  requireWithin(options.limits, expected, !options.surface.quiet, [&] {
    const double tooMany = expected.items / options.limits.items.value_or(expected.items);
    const double tooLarge = expected.bytes / options.limits.mostBytes();
    return sizeThatFits(grid, std::sqrt(std::max({tooMany, tooLarge, 1.0})));
  });
}

/// What the cells together give, beside what the surface says itself.
struct Totals {
  CutCellsReport found;
  std::optional<double> volumeError;  ///< relative; nothing if part of the surface is elsewhere
  std::optional<double> areaError;
};

Totals totalsOf(const CellsSettings& options, const CutCells& cells, const PlacedSurface& placed) {
  Totals totals{.found = check(cells), .volumeError = {}, .areaError = {}};
  const auto& planes = cells.grid.planes;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& across = planes[static_cast<std::size_t>(axis)];
    if (placed.box.lower[axis] < across[1] || placed.box.upper[axis] > across[across.size() - 2]) {
      return totals;
    }
  }
  const auto& [area, volume] = placed.measure;
  const double within = options.isInside ? totals.found.fluidVolume : totals.found.bodyVolume;
  totals.volumeError = std::abs(within - volume) / volume;
  totals.areaError = std::abs(totals.found.wallArea - area) / area;
  return totals;
}

Json orNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string jsonOf(const CellsSettings& options, const CutCells& cells, const Totals& totals,
                   double seconds) {
  const auto& found = totals.found;
  return Json{{"input", options.surface.file},
              {"cells", cells.grid.indices().count()},
              {"cutCells", found.cutCells},
              {"pieces", cells.pieceCount},
              {"multiPieceCells", found.multiPieceCells},
              {"thinCells", found.thinCells},
              {"fluidVolume", found.fluidVolume},
              {"bodyVolume", found.bodyVolume},
              {"boundaryArea", found.wallArea},
              {"volumeError", orNull(totals.volumeError)},
              {"areaError", orNull(totals.areaError)},
              {"worstClosure", found.worstClosure},
              {"seconds", seconds}}
      .text();
}

void report(const CellsSettings& options, const CutCells& cells, const Totals& totals,
            const Vec3<double>& size, double seconds) {
  const auto& found = totals.found;
  const auto box = cells.grid.indices();
  std::cout << "cut " << grouped(found.cutCells) << " of " << box.length(0) << " x "
            << box.length(1) << " x " << box.length(2) << " = " << grouped(box.count())
            << " cells of " << extent(size) << " in " << duration(seconds) << '\n';
  std::cout << "pieces of fluid in them: " << grouped(cells.pieceCount) << "; "
            << grouped(found.multiPieceCells) << " cells have several, in "
            << grouped(found.thinCells) << " all corners are on one side\n";
  std::cout << "fluid " << number(found.fluidVolume, 6) << ", body " << number(found.bodyVolume, 6)
            << ", wall " << number(found.wallArea, 6);
  if (totals.volumeError && totals.areaError) {
    std::cout << "; off the surface's own by " << number(*totals.volumeError, 2)
              << " of the volume and " << number(*totals.areaError, 2) << " of the area";
  } else {
    std::cout << "; part of the surface is outside the grid";
  }
  std::cout << "\npieces close to " << number(found.worstClosure, 2) << " of a face\n";
  if (!options.output.empty()) std::cout << "wrote " << onOneLine(options.output) << '\n';
}

void writeJson(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

void cut(const CellsSettings& options, const Solid<double>& solid, const PlacedSurface& placed,
         const GridPatch<double>& grid) {
  const CellCutter cutter(solid, options.isInside ? FluidSide::Inside : FluidSide::Outside);
  Stopwatch watch;
  const auto cells = [&] {
    ProgressBar bar("cutting", !options.surface.quiet);
    return cutter.cut(grid, {.polygons = !options.output.empty(),
                             .threads = options.surface.threads,
                             .progress = bar.callback()});
  }();
  const double seconds = watch.lap();
  const auto totals = totalsOf(options, cells, placed);
  if (!options.output.empty()) {
    writePointData(options.output, cutCellMesh(cells, options.wholeCells));
  }
  if (!options.json.empty()) writeJson(options.json, jsonOf(options, cells, totals, seconds));
  if (!options.surface.quiet) report(options, cells, totals, grid.level.spacing(), seconds);
}

void run(const CellsSettings& options) {
  if (options.wholeCells && options.output.empty()) {
    throw Error(ErrorKind::Argument, "--whole-cells is for the file of -o");
  }
  const auto solid = loadSolid(options.surface);
  auto placedMesh = cuttingMesh(solid, options.surface);
  placedMesh.setPlacement(solid.placement());
  const auto placed = placedSurface(placedMesh);
  const auto grid = gridAround(boxAround(solid), options.grid);
  requireRoom(options, placed, grid);
  namingMemory("out of memory with " + grouped(grid.indices.count()) + " cells; use fewer --cells",
               [&] { cut(options, solid, placed, grid); });
}

}  // namespace

void addCells(Program& program) {
  const auto options = std::make_shared<CellsSettings>();
  auto command = program.addCommand(
      "cells", "Cut the cells of a grid by a closed surface, exactly: volumes, faces, walls");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->output, {".vtu"},
            "The pieces of fluid to write, as polyhedra");
  addOutput(command, "--json", options->json, {".json"}, "Write the totals in JSON, for programs");
  addSizeOptions(command, options->grid);
  addPlaceOptions(command, options->grid);
  addLimits(command, "--max-cells", options->limits);
  command.addFlag("--inside", "The fluid is inside the surface", options->isInside);
  command.addFlag("--whole-cells", "Write the cells that are all fluid as well",
                  options->wholeCells);
  command.setFooter(
      "Examples:\n"
      "  cutwater cells hull.stl --cells 128 -o cells.vtu\n"
      "  cutwater cells hull.stl --spacing 0.02 --box -1,-1,-1,7,1,0 --json totals.json\n"
      "  cutwater cells manifold.stl --inside --whole-cells --cells 200 -o fluid.vtu");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
