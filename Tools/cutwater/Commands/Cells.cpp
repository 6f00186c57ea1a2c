#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Io/PointData.hpp>

#include <cmath>
#include <iostream>
#include <memory>

#include "Commands/Commands.hpp"
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
  bool isInside = false;
  bool wholeCells = false;

  [[nodiscard]] FluidSide side() const { return isInside ? FluidSide::Inside : FluidSide::Outside; }
};

/// Memory in bytes, as measured for hulls, statues and machine parts; parts of triangles count
/// beside cells.
struct CellBytes {
  static constexpr double kCut = 5000;
  static constexpr double kTriangle = 1500;
  static constexpr double kWhole = 250;
  static constexpr double kLeaf = OctreeEstimate::kBytesPerCell + 30;
};

/// @throws Error(Limit) if there is no room.
void requireRoom(const CellsSettings& options, const PlacedSurface& placed,
                 const GridPatch<double>& grid) {
  const double cut = placed.expectedCells(grid.level.spacing());
  const auto all = static_cast<double>(grid.indices.count());
  const double whole = options.wholeCells ? all : 0;
  const Expected expected{.what = "cells",
                          .items = cut + whole,
                          .bytes = CellBytes::kCut * cut + CellBytes::kWhole * whole +
                                   CellBytes::kTriangle * static_cast<double>(placed.triangles)};
  requireWithin(options.limits, expected, !options.surface.quiet, [&] {
    const double tooMany = expected.items / options.limits.items.value_or(expected.items);
    const double tooLarge = expected.bytes / options.limits.mostBytes();
    return sizeThatFits(grid, std::sqrt(std::max({tooMany, tooLarge, 1.0})));
  });
}

/// Memory for each cell of an octree, those that are not cut among them.
double bytesPerLeaf(const CellsSettings& options, const PlacedSurface& placed,
                    const OctreeDomain<double>& domain, const OctreeEstimate& mesh) {
  const auto sizeOf = [&](int level) {
    return std::ldexp(domain.spacing(), -level) * Vec3<double>{1, 1, 1};
  };
  // A leaf that is divided further makes four of it, along a sheet.
  const int level = options.octree.refinement.rules.cut;
  double cut = placed.expectedCells(sizeOf(level));
  for (int finer = level; finer < mesh.deepest(); ++finer) cut += 3 * mesh.divided(finer);
  cut = std::min({cut, placed.expectedCells(sizeOf(mesh.deepest())), mesh.cells()});
  const auto triangles = static_cast<double>(placed.triangles);
  return CellBytes::kLeaf + (options.wholeCells ? CellBytes::kWhole : 0) +
         (CellBytes::kCut * cut + CellBytes::kTriangle * triangles) / mesh.cells();
}

/// The octree that the options describe.
/// @throws Error(Limit) if there is no room for it, or for its leaves once they are cut.
Octree<double> octreeAround(const CellsSettings& options, const Solid<double>& solid,
                            const PlacedSurface& placed) {
  auto wanted = options.octree;
  wanted.roots.box = options.grid.box;
  wanted.roots.margin = options.grid.margin;
  wanted.limits = options.limits;
  const auto domain = domainAround(boxAround(solid), wanted);
  const auto rules = rulesFor(wanted.refinement, solid.patchNames());
  OctreeOptions mesh{.balance = wanted.balance, .threads = options.surface.threads};
  const auto estimated = estimate(solid, domain, rules, mesh);
  const double bytes = bytesPerLeaf(options, placed, domain, estimated);
  requireRoom(wanted, estimated, bytes, 0, !options.surface.quiet);
  mesh.maxCells = static_cast<std::size_t>(mostCells(wanted, bytes));
  ProgressBar bar("meshing", !options.surface.quiet);
  mesh.progress = bar.callback();
  return Octree<double>(solid, domain, rules, mesh);
}

void writeJson(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

/// Cuts, and takes the time.
template <typename Mesh>
auto cut(const CellsSettings& options, const CellCutter& cutter, const Mesh& mesh,
         double& seconds) {
  Stopwatch watch;
  ProgressBar bar("cutting", !options.surface.quiet);
  auto cells = cutter.cut(mesh, {.polygons = !options.output.empty(),
                                 .threads = options.surface.threads,
                                 .progress = bar.callback()});
  seconds = watch.lap();
  return cells;
}

/// `cells`: as in "5 of 2 x 2 x 2 = 8 cells of 1 x 1 x 1".
void report(const CellsSettings& options, const CellTotals& totals, const std::string& cells) {
  if (!options.json.empty()) writeJson(options.json, totals.json(options.surface.file));
  if (options.surface.quiet) return;
  std::cout << "cut " << cells << " in " << duration(totals.seconds) << '\n' << totals.text();
  if (!options.output.empty()) std::cout << "wrote " << onOneLine(options.output) << '\n';
}

void cutGrid(const CellsSettings& options, const Solid<double>& solid, const PlacedSurface& placed,
             const GridPatch<double>& grid) {
  double seconds = 0;
  const auto cells = cut(options, CellCutter(solid, options.side()), grid, seconds);
  const auto& box = grid.indices;
  const Box<double> filled{grid.level.cell(box.lo).lower, grid.level.cell(box.hi).upper};
  CellTotals totals(check(cells), box.count(), cells.pieceCount, filled, placed, options.side());
  totals.seconds = seconds;
  if (!options.output.empty()) {
    writePointData(options.output, cutCellMesh(cells, options.wholeCells));
  }
  report(options, totals,
         grouped(cells.cellCount) + " of " + std::to_string(box.length(0)) + " x " +
             std::to_string(box.length(1)) + " x " + std::to_string(box.length(2)) + " = " +
             grouped(box.count()) + " cells of " + extent(grid.level.spacing()));
}

void cutOctree(const CellsSettings& options, const Solid<double>& solid,
               const PlacedSurface& placed) {
  const auto mesh = octreeAround(options, solid, placed);
  double seconds = 0;
  const auto leaves = cut(options, CellCutter(solid, options.side()), mesh, seconds);
  CellTotals totals(check(leaves), mesh.cells().size(), leaves.pieces.cell.size(),
                    mesh.domain().box(), placed, options.side());
  totals.seconds = seconds;
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
  const auto solid = loadSolid(options.surface);
  auto placedMesh = cuttingMesh(solid, options.surface);
  placedMesh.setPlacement(solid.placement());
  const PlacedSurface placed(placedMesh);
  if (onOctree) {
    namingMemory("out of memory; use a lower --level", [&] { cutOctree(options, solid, placed); });
    return;
  }
  const auto grid = gridAround(boxAround(solid), options.grid);
  requireRoom(options, placed, grid);
  namingMemory("out of memory with " + grouped(grid.indices.count()) + " cells; use fewer --cells",
               [&] { cutGrid(options, solid, placed, grid); });
}

void addOctreeOptions(Command command, MeshOptions& options) {
  const auto level = addRefinementOptions(command, options.refinement);
  addRoots(command, options);
  addBalance(command, options);
  for (const char* of : {"--cells", "--spacing", "--total"}) command.option(of).excludes(level);
  for (const char* of : {"--band", "--patch", "--curvature", "--edges", "--gaps", "--walls",
                         "--roots", "--balance"}) {
    command.option(of).needs(level);
  }
}

}  // namespace

void addCells(Program& program) {
  const auto options = std::make_shared<CellsSettings>();
  auto command = program.addCommand(
      "cells",
      "Cut the cells of a grid or an octree by a closed surface, exactly: volumes, faces, walls");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->output, {".vtu"},
            "The pieces of fluid to write, as polyhedra");
  addOutput(command, "--json", options->json, {".json"}, "Write the totals in JSON, for programs");
  addSizeOptions(command, options->grid);
  addPlaceOptions(command, options->grid);
  addOctreeOptions(command, options->octree);
  addLimits(command, "--max-cells", options->limits);
  command.addFlag("--inside", "The fluid is inside the surface", options->isInside);
  command.addFlag("--whole-cells", "Write the cells that are all fluid as well",
                  options->wholeCells);
  command.setFooter(
      "Without --level, the cells are those of a grid; with it, of an octree as of 'cutwater "
      "amr'.\n"
      "\n"
      "Examples:\n"
      "  cutwater cells hull.stl --cells 128 -o cells.vtu\n"
      "  cutwater cells hull.stl --spacing 0.02 --box -1,-1,-1,7,1,0 --json totals.json\n"
      "  cutwater cells hull.stl --level 4 --edges 30:6 -o cells.vtu\n"
      "  cutwater cells manifold.stl --inside --whole-cells --cells 200 -o fluid.vtu");
  command.setAction([=] { run(*options, command.isGiven("--level")); });
}

}  // namespace cutwater::tool
