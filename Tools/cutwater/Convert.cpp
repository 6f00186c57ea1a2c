#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "Commands.hpp"
#include "Format.hpp"
#include "Surface.hpp"

namespace cutwater::tool {

namespace {

struct Options {
  SurfaceOptions surface;
  std::string output;
  WriteOptions write;
};

void run(const Options& options) {
  const auto surface = load(options.surface);
  const auto polygons = write(options.output, surface.soup, options.write);
  if (options.surface.quiet) return;
  std::cout << "wrote " << options.output << ": " << counted(polygons, "polygon") << ", "
            << counted(surface.soup.points.size(), "point") << ", "
            << counted(surface.soup.patchNames.size(), "patch") << '\n';
}

}  // namespace

void addConvert(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  auto& command = *program.add_subcommand(
      "convert", "Write a surface in another format, or moved, scaled and welded");
  addSurfaceOptions(command, options->surface);
  command
      .add_option("OUTPUT", options->output,
                  "The surface to write; its extension tells the format: stl, ply, obj, off, vtk")
      ->required();
  command.add_flag("--ascii", options->write.ascii,
                   "Text where the format has both (STL, PLY, VTK)");
  command.footer(
      "Examples:\n"
      "  cutwater convert hull.stl.gz hull.ply\n"
      "  cutwater convert part.obj part.stl --scale 0.001 --translate 0,0,1 --rotate 90,z");
  command.callback([=] { run(*options); });
}

}  // namespace cutwater::tool
