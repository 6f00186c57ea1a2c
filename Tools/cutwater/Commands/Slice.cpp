#include <memory>

#include "Commands/Commands.hpp"
#include "Commands/Picture.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/OutputFile.hpp"

namespace cutwater::tool {

namespace {

struct SliceSettings {
  SurfaceOptions surface;
  PictureOptions picture;
};

}  // namespace

void addSlice(Program& program) {
  const auto options = std::make_shared<SliceSettings>();
  auto command = program.addCommand(
      "slice", "Draw the signed distance in a plane, with the surface's outline, as a PNG picture");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->picture.output, {".png"}, "The picture to write")
      .required();
  addPictureOptions(command, options->picture);
  command.setFooter(
      "Examples:\n"
      "  cutwater slice hull.stl -o hull.png\n"
      "  cutwater slice hull.stl --axis z --at 0.2 --unit m --title \"Waterline\" -o water.png\n"
      "  cutwater slice part.stl --scale 0.001 --window -0.1,0,0.1,0.05 --size 2400x1200 -o "
      "detail.png");
  command.setAction(
      [=] { writePicture(loadSolid(options->surface), options->surface, options->picture); });
}

}  // namespace cutwater::tool
