#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Grid/OctreeEstimate.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <new>
#include <utility>

#include "Commands/Commands.hpp"
#include "Options/Arguments.hpp"
#include "Options/Limits.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/SampleGrid.hpp"
#include "Options/SurfaceOutput.hpp"
#include "Report/Format.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct IsosurfaceSettings {
  SurfaceOptions surface;
  std::string output;
  GridRequest grid;
  Limits limits;
  IsosurfaceOptions isosurface;
  WriteOptions write;
};

PolygonSoup triangles(const Solid<double>& solid, const GridPatch<double>& grid,
                      const IsosurfaceOptions& options) {
  try {
    return isosurface<double>(solid, grid, options);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::Limit, "out of memory with " + grouped(grid.indices.count()) +
                                      " nodes; use fewer --cells");
  }
}

/// The number of the grid's cells that the surface may meet, from that in an octree whose finest
/// cells are as large.
double cellsWithSurface(const Solid<double>& solid, const GridPatch<double>& grid, int threads) {
  constexpr double kRoots = 16;  // along the longest side
  const auto& spacing = grid.level.spacing();
  const double width = std::cbrt(spacing.x * spacing.y * spacing.z);
  const auto lower = grid.level.position(grid.indices.lo);
  const auto size = grid.level.position(grid.indices.hi) - lower;
  constexpr int kDeepest = 14;  // of the octree; finer cells are four times as many on each level
  const int halvings = std::max(0, std::ilogb(maxComponent(size) / width / kRoots) + 1);
  const int level = std::min(halvings, kDeepest);
  const double root = std::ldexp(width, halvings);
  const auto along = [&](double length) {
    return std::max(1, static_cast<std::int32_t>(std::ceil(length / root)));
  };
  const OctreeDomain<double> domain(lower, root, {along(size.x), along(size.y), along(size.z)});
  const auto found = estimate(solid, domain, {.cut = level + 1}, {.threads = threads});
  return std::ldexp(found.divided(level), 2 * (halvings - level));
}

/// Of all triangles, from those of a coarse grid.
double secondsFor(double triangleCount, const Solid<double>& solid, const GridPatch<double>& grid,
                  const IsosurfaceOptions& options) {
  constexpr double kNodes = 128;  // along the longest side
  const auto& n = grid.indices;
  const auto longest = static_cast<double>(std::max({n.length(0), n.length(1), n.length(2)}));
  const auto coarser = std::max(1.0, longest / kNodes);
  const auto along = [&](int axis) {
    return static_cast<std::int32_t>(static_cast<double>(n.length(axis) - 1) / coarser) + 2;
  };
  const GridPatch<double> coarse{
      Level<double>(grid.level.position(n.lo), coarser * grid.level.spacing(), Centering::Node),
      IndexBox::ofSize(along(0), along(1), along(2))};
  Stopwatch watch;
  const auto found = isosurface<double>(solid, coarse, options).polygonCount();
  return found > 0 ? watch.lap() * triangleCount / static_cast<double>(found) : -1;
}

/// @throws Error(Limit) if the triangles have no room within the limits.
void requireRoom(const Solid<double>& solid, const GridPatch<double>& grid,
                 const IsosurfaceSettings& options) {
  // As measured, with what writing takes: see Docs/isosurfaces.md.
  constexpr double kTrianglesPerCell = 2;
  constexpr double kBytesPerTriangle = 100;
  constexpr double kBytesPerNode = 0.01;
  Expected expected{.what = "triangles"};
  expected.items = kTrianglesPerCell * cellsWithSurface(solid, grid, options.surface.threads);
  expected.bytes = kBytesPerTriangle * expected.items +
                   kBytesPerNode * static_cast<double>(grid.indices.count());
  constexpr double kFew = 1e6;  // nodes, for which it is not worth while
  if (static_cast<double>(grid.indices.count()) > kFew) {
    expected.seconds = secondsFor(expected.items, solid, grid, options.isosurface);
  }
  requireWithin(options.limits, expected, !options.surface.quiet, [&] {
    const double byMemory = expected.bytes / options.limits.mostBytes();
    const double byCount = options.limits.items ? expected.items / *options.limits.items : 0;
    return sizeThatFits(grid, std::sqrt(std::max(byMemory, byCount)));
  });
}

void run(IsosurfaceSettings options) {
  const auto solid = loadSolid(options.surface);
  options.grid.nodes = true;
  const auto grid = gridAround(boxAround(solid), options.grid);
  options.isosurface.threads = options.surface.threads;
  requireRoom(solid, grid, options);
  Stopwatch watch;
  PolygonSoup soup;
  {
    ProgressBar bar("triangles", !options.surface.quiet);
    options.isosurface.progress = bar.callback();
    soup = triangles(solid, grid, options.isosurface);
  }
  const double seconds = watch.lap();
  if (soup.polygonCount() == 0) {
    throw Error(ErrorKind::Argument, fileName(options.surface) + ": no surface between the nodes");
  }
  const auto surface = asWritten(options.output, std::move(soup), options.write);
  writeSurface(options.output, surface.soup, options.write);
  if (options.surface.quiet) return;
  std::cout << "wrote " << onOneLine(options.output) << ": "
            << grouped(surface.soup.polygonCount(), "triangle") << ", "
            << grouped(surface.soup.points.size(), "point") << ", from "
            << grouped(grid.indices.count()) << " nodes of " << extent(grid.level.spacing())
            << " in " << duration(seconds) << '\n'
            << lossesOf(surface);
}

}  // namespace

void addIsosurface(Program& program) {
  const auto options = std::make_shared<IsosurfaceSettings>();
  auto command = program.addCommand(
      "isosurface", "Make a closed surface of triangles from what is inside, by a grid");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addSurfaceOutput(command, "-o,--output", options->output, options->write);
  addSizeOptions(command, options->grid);
  addPlaceOptions(command, options->grid);
  addLimits(command, "--max-triangles", options->limits);
  command.add("--tolerance", "CELLS",
              "Points are within this many cells of the surface [default: 0.001]",
              [=](const std::string& text) {
                const double cells = positiveNumber("--tolerance", text);
                if (cells < 1e-9 || cells > 0.5) refuse("--tolerance", text, "1e-9 to 0.5 cells");
                options->isosurface.tolerance = cells;
              });
  command.add("--edges", "DEGREES",
              "Follow edges where normals differ by more than this [default: edges are cut off]",
              [=](const std::string& text) {
                options->isosurface.featureAngle = angleOf("--edges", text);
              });
  command.setFooter(
      "Examples:\n"
      "  cutwater isosurface hull.stl --cells 300 --edges 30 -o new.stl\n"
      "  cutwater isosurface hull.stl --spacing 0.02 --box 0,0,0,3,1,1 -o part.ply");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
