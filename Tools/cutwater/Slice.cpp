#include <Cutwater/Io/Png.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "Arguments.hpp"
#include "Commands.hpp"
#include "Format.hpp"
#include "ProgressBar.hpp"
#include "Surface.hpp"

namespace cutwater::tool {

namespace {

struct Options {
  SurfaceOptions surface;
  std::string output;
  int axis = 1;
  std::optional<double> at;
  SliceOptions<double> picture;
};

void run(Options& options) {
  const auto solid = loadSolid(options.surface);
  const double at = options.at.value_or(solid.boundingBox().center()[options.axis]);
  if (options.picture.title.empty()) {
    options.picture.title = fileName(options.surface) + ", " + "xyz"[options.axis] + " = " +
                            number(at, 4) +
                            (options.picture.unit.empty() ? "" : " " + options.picture.unit);
  }
  Stopwatch watch;
  {
    ProgressBar bar("slicing", !options.surface.quiet);
    options.picture.threads = options.surface.threads;
    options.picture.progress = bar.callback();
    writePng(options.output,
             renderSlice(solid, SlicePlane<double>::across(options.axis, at), options.picture));
  }
  if (options.surface.quiet) return;
  std::cout << "wrote " << options.output << ": " << options.picture.width << " x "
            << options.picture.height << " pixels of the plane "
            << "xyz"[options.axis] << " = " << number(at) << ", in " << duration(watch.lap())
            << '\n';
}

void addWindow(CLI::App& command, Options& options) {
  command
      .add_option_function<std::string>(
          "--window",
          [&](const std::string& text) {
            const auto v = numbers("--window", text, 4);
            if (!(v[0] < v[2] && v[1] < v[3])) {
              refuse("--window", text, "the lower corner and then the upper one");
            }
            options.picture.window = SliceWindow<double>{{v[0], v[1]}, {v[2], v[3]}};
          },
          "Show this rectangle of the plane, by its corners in the plane's two coordinates; "
          "without it: the whole surface")
      ->type_name("A0,B0,A1,B1");
}

}  // namespace

void addSlice(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  auto& command = *program.add_subcommand(
      "slice", "Draw the signed distance in a plane, with the surface's outline, as a PNG picture");
  addSurfaceOptions(command, options->surface);
  addSignOptions(command, options->surface);
  command.add_option("-o,--output", options->output, "The picture to write")
      ->required()
      ->type_name("FILE.png");
  command
      .add_option_function<std::string>(
          "--axis", [=](const std::string& text) { options->axis = axisOf("--axis", text); },
          "The plane's normal: x, y or z; without it: y")
      ->type_name("AXIS");
  command
      .add_option_function<std::string>(
          "--at", [=](const std::string& text) { options->at = numbers("--at", text, 1).front(); },
          "Where on that axis; without it: the middle of the surface")
      ->type_name("VALUE");
  addWindow(command, *options);
  command
      .add_option_function<std::string>(
          "--size",
          [=](const std::string& text) {
            const auto size = sizes("--size", text);
            if (size.size() != 2 || size[0] < 320 || size[1] < 240 || size[0] > Image::kMaxSize ||
                size[1] > Image::kMaxSize) {
              refuse("--size", text, "WIDTHxHEIGHT from 320x240 to 32768x32768");
            }
            options->picture.width = size[0];
            options->picture.height = size[1];
          },
          "Pixels; without it: 1600x1000")
      ->type_name("WxH");
  command.add_option("--title", options->picture.title, "What stands above");
  command.add_option("--unit", options->picture.unit, "Unit of lengths, for the labels: m");
  command.footer(
      "Examples:\n"
      "  cutwater slice hull.stl -o hull.png\n"
      "  cutwater slice hull.stl --axis z --at 0.2 --unit m --title \"Waterline\" -o water.png\n"
      "  cutwater slice part.stl --scale 0.001 --window -0.1,0,0.1,0.05 --size 2400x1200 -o "
      "detail.png");
  command.callback([=] { run(*options); });
}

}  // namespace cutwater::tool
