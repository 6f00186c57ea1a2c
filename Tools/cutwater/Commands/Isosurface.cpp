#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Isosurface.hpp>

#include <iostream>
#include <memory>
#include <new>
#include <utility>

#include "Commands/Commands.hpp"
#include "Options/Arguments.hpp"
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

void run(IsosurfaceSettings options) {
  const auto solid = loadSolid(options.surface);
  options.grid.nodes = true;
  const auto grid = gridAround(boxAround(solid), options.grid);
  options.isosurface.threads = options.surface.threads;
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
