#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/PointData.hpp>

#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "Commands/Commands.hpp"
#include "Options/CutOctree.hpp"
#include "Options/Cutter.hpp"
#include "Options/CuttingCost.hpp"
#include "Options/CuttingOptions.hpp"
#include "Options/Limits.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/MeshOptions.hpp"
#include "Options/OutputFile.hpp"
#include "Options/SampleGrid.hpp"
#include "Report/CellTotals.hpp"
#include "Report/Format.hpp"
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
  MeshOptions octree;  ///< but for place and limits
  Limits limits;
  CuttingOptions cutting;
  bool wholeCells = false;

  [[nodiscard]] bool hasPolygons() const { return !output.empty(); }
};

/// Memory of a whole cell that is written, in bytes, as measured.
constexpr double kBytesOfWhole = 250;

/// Cuts, and takes the time.
template <typename Mesh>
auto cut(const CellsSettings& options, const Cutter& cutter, const Mesh& mesh, bool isShown,
         double& seconds) {
  ProgressBar bar("cutting", isShown && !options.surface.quiet);
  Stopwatch watch;
  auto cells = cutter.cut(mesh, {.polygons = options.hasPolygons(),
                                 .threads = options.surface.threads,
                                 .progress = bar.callback()});
  seconds = watch.lap();
  return cells;
}

/// The same box in cells 2^halvings times as large; the last ones may reach beyond it.
GridPatch<double> ofLargerCells(const GridPatch<double>& grid, int halvings) {
  const auto along = [&](int axis) {
    return static_cast<std::int32_t>((grid.indices.length(axis) - 1) >> halvings) + 1;
  };
  const auto lower = grid.level.cell(grid.indices.lo).lower;
  return {Level<double>(lower, std::ldexp(1.0, halvings) * grid.level.spacing()),
          IndexBox::ofSize(along(0), along(1), along(2))};
}

/// @throws Error(Limit) if there is no room.
void requireRoom(const CellsSettings& options, const Cutter& cutter, const PlacedSurface& placed,
                 const GridPatch<double>& grid) {
  const double expectedCut = placed.expectedCells(grid.level.spacing());
  const double whole = options.wholeCells ? static_cast<double>(grid.indices.count()) : 0;
  Expected expected{.what = "cells", .items = expectedCut + whole};
  expected.bytes =
      bytesToCut(expectedCut, placed.triangles, options.hasPolygons()) + kBytesOfWhole * whole;
  expected.seconds = secondsToCut(expectedCut, [&](int halvings) {
    CutCount count;
    const auto larger = ofLargerCells(grid, halvings);
    count.cells = static_cast<double>(cut(options, cutter, larger, false, count.seconds).cellCount);
    return count;
  });
  requireWithin(options.limits, expected, !options.surface.quiet, [&] {
    const double tooMany = expected.items / options.limits.items.value_or(expected.items);
    const double tooLarge = expected.bytes / options.limits.mostBytes();
    const double factor = std::sqrt(std::max({tooMany, tooLarge, 1.0}));
    return options.cutting.hasPeriod() ? numberThatFits(grid, 1.02 * factor)
                                       : sizeThatFits(grid, factor);
  });
}

/// `cells`: as in "5 of 2 x 2 x 2 = 8 cells of 1 x 1 x 1".
void report(const CellsSettings& options, const CellTotals& totals, const std::string& cells) {
  if (!options.json.empty()) writeText(options.json, totals.json(options.surface.file));
  if (options.surface.quiet) return;
  std::cout << "cut " << cells << " in " << duration(totals.seconds) << '\n' << totals.text();
  if (!options.output.empty()) std::cout << "wrote " << onOneLine(options.output) << '\n';
}

Box<double> spaceOf(const GridPatch<double>& grid) {
  return {grid.level.cell(grid.indices.lo).lower, grid.level.cell(grid.indices.hi).upper};
}

/// Of cells that state errors; `volumeOf`: of the cell of a row.
void stateErrors(std::span<const double> errors, std::size_t cells,
                 const std::function<double(std::size_t)>& volumeOf, CellTotals& totals) {
  if (errors.empty()) return;
  double volume = 0;
  double largest = 0;
  for (std::size_t row = 0; row < cells; ++row) {
    volume += errors[row] * volumeOf(row);
    largest = std::max(largest, errors[row]);
  }
  totals.state(volume, largest);
}

void cutGrid(const CellsSettings& options, const Cutter& cutter, const PlacedSurface& placed,
             const GridPatch<double>& grid) {
  double seconds = 0;
  const auto cells = cut(options, cutter, grid, true, seconds);
  const auto& box = grid.indices;
  CellTotals totals(check(cells), box.count(), cells.pieceCount, spaceOf(grid), placed,
                    options.cutting.side());
  totals.seconds = seconds;
  stateErrors(
      cells.cells.error, cells.cellCount,
      [&](std::size_t row) { return cells.cellVolume(cells.cells.index[row]); }, totals);
  if (!options.output.empty()) {
    writePointData(options.output, cutCellMesh(cells, options.wholeCells));
  }
  report(options, totals,
         grouped(cells.cellCount) + " of " + std::to_string(box.length(0)) + " x " +
             std::to_string(box.length(1)) + " x " + std::to_string(box.length(2)) + " = " +
             grouped(box.count()) + " cells of " + extent(grid.level.spacing()));
}

void cutOctree(const CellsSettings& options, const Octree<double>& mesh, const Cutter& cutter,
               const PlacedSurface& placed) {
  double seconds = 0;
  const auto leaves = cut(options, cutter, mesh, true, seconds);
  CellTotals totals(check(leaves), mesh.cells().size(), leaves.pieces.cell.size(),
                    mesh.domain().box(), placed, options.cutting.side());
  totals.seconds = seconds;
  stateErrors(
      leaves.cut.error, leaves.cut.leaf.size(),
      [&](std::size_t row) { return leaves.leafVolume(static_cast<std::uint32_t>(row)); }, totals);
  if (!options.output.empty()) {
    writePointData(options.output, cutCellMesh(leaves, mesh, options.wholeCells));
  }
  report(options, totals,
         grouped(leaves.cut.leaf.size()) + " of " + grouped(mesh.cells().size()) +
             " cells of an octree, the finest of " +
             extent(mesh.domain().level(mesh.deepest()).spacing()));
}

void run(const CellsSettings& options, bool onOctree) {
  if (options.wholeCells && options.output.empty()) {
    throw Error(ErrorKind::Argument, "--whole-cells is for the file of -o");
  }
  if (onOctree) refuseOnOctrees(options.cutting);
  const auto solid = loadSolid(options.surface);
  const Cutter cutter(solid, options.cutting);
  const auto trial = cutter.trial(solid, options.cutting);
  if (onOctree) {
    const auto within = options.grid.box.value_or(boxAround(solid));
    const PlacedSurface placed(solid, within, options.cutting.cutter);
    auto mesh = options.octree;
    mesh.roots.box = options.grid.box;
    mesh.roots.margin = options.grid.margin;
    mesh.limits = options.limits;
    const CutOctree wanted{.mesh = mesh,
                           .polygons = options.hasPolygons(),
                           .bytesPerLeaf = options.wholeCells ? kBytesOfWhole : 0,
                           .threads = options.surface.threads,
                           .quiet = options.surface.quiet};
    namingMemory("out of memory; use a lower --level", [&] {
      cutOctree(options, octreeToCut(wanted, solid, trial, placed), cutter, placed);
    });
    return;
  }
  const auto grid = gridAround(boxAround(solid), options.grid);
  const PlacedSurface placed(solid, spaceOf(grid), options.cutting.cutter);
  requireRoom(options, trial, placed, grid);
  namingMemory("out of memory with " + grouped(grid.indices.count()) + " cells; use fewer --cells",
               [&] { cutGrid(options, cutter, placed, grid); });
}

}  // namespace

void addCells(Program& program) {
  const auto options = std::make_shared<CellsSettings>();
  auto command = program.addCommand(
      "cells",
      "Cut the cells of a grid or an octree by a closed surface, exactly, or by a scene's solid: "
      "volumes, faces, walls");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->output, {".vtu"},
            "The pieces of fluid to write, as polyhedra");
  addOutput(command, "--json", options->json, {".json"}, "Write the totals in JSON, for programs");
  addSizeOptions(command, options->grid);
  addPlaceOptions(command, options->grid);
  addOctreeOptions(command, options->octree);
  addLimits(command, "--max-cells", options->limits);
  addCuttingOptions(command, options->cutting);
  command.addFlag("--whole-cells", "Write the cells that are all fluid as well",
                  options->wholeCells);
  command.setFooter(
      "Without --level, the cells are those of a grid; with it, of an octree as of 'cutwater "
      "amr'.\n"
      "Surfaces cut cells exactly; a scene's solid cuts them within errors that are estimated and "
      "reported.\n"
      "\n"
      "Examples:\n"
      "  cutwater cells hull.stl --cells 128 -o cells.vtu\n"
      "  cutwater cells hull.stl --spacing 0.02 --box -1,-1,-1,7,1,0 --json totals.json\n"
      "  cutwater cells hull.stl --level 4 --edges 30:6 -o cells.vtu\n"
      "  cutwater cells manifold.stl --inside --whole-cells --cells 200 -o fluid.vtu\n"
      "  cutwater cells pipe.obj --inside --open inlet --open outlet --spacing 0.01 -o pipe.vtu\n"
      "  cutwater cells tank.obj --inside --baffle fin --cap-holes --cells 100 -o tank.vtu\n"
      "  cutwater cells bed.stl --period 1,1,0 --cells 100 --json totals.json\n"
      "  cutwater cells flange.toml --cells 100 -o cells.vtu");
  command.setAction([=] {
    passOn(options->cutting, options->grid, options->surface);
    run(*options, command.isGiven("--level"));
  });
}

}  // namespace cutwater::tool
