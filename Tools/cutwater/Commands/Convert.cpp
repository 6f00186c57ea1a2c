#include <iostream>
#include <memory>

#include "Commands/Commands.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/SurfaceOutput.hpp"

namespace cutwater::tool {

namespace {

struct ConvertSettings {
  SurfaceOptions surface;
  std::string output;
  WriteOptions write;
};

void run(const ConvertSettings& options) {
  const auto surface = asWritten(options.output, load(options.surface).soup, options.write);
  writeSurface(options.output, surface.soup, options.write);
  if (options.surface.quiet) return;
  std::cout << "wrote " << onOneLine(options.output) << ": " << sizeOf(surface) << '\n'
            << lossesOf(surface);
}

}  // namespace

void addConvert(Program& program) {
  const auto options = std::make_shared<ConvertSettings>();
  auto command = program.addCommand(
      "convert", "Write a surface in another format, or moved, scaled and welded");
  addSurfaceOptions(command, options->surface);
  addSurfaceOutput(command, "OUTPUT", options->output, options->write);
  command.setFooter(
      "Examples:\n"
      "  cutwater convert hull.stl.gz hull.ply\n"
      "  cutwater convert part.obj part.stl --scale 0.001 --translate 0,0,1 --rotate 90,z");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
