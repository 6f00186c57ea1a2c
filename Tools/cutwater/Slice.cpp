#include <CLI/CLI.hpp>
#include <memory>

#include "Commands.hpp"
#include "OutputFile.hpp"
#include "Picture.hpp"

namespace cutwater::tool {

namespace {

struct Options {
  SurfaceOptions surface;
  PictureOptions picture;
};

}  // namespace

void addSlice(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  auto& command = *program.add_subcommand(
      "slice", "Draw the signed distance in a plane, with the surface's outline, as a PNG picture");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->picture.output, {".png"}, "The picture to write")
      .required();
  addPictureOptions(command, options->picture);
  command.footer(
      "Examples:\n"
      "  cutwater slice hull.stl -o hull.png\n"
      "  cutwater slice hull.stl --axis z --at 0.2 --unit m --title \"Waterline\" -o water.png\n"
      "  cutwater slice part.stl --scale 0.001 --window -0.1,0,0.1,0.05 --size 2400x1200 -o "
      "detail.png");
  command.callback(
      [=] { writePicture(loadSolid(options->surface), options->surface, options->picture); });
}

}  // namespace cutwater::tool
