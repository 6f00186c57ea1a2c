#include "Options/SurfaceOptions.hpp"

#include <Cutwater/Surface/ReadSurface.hpp>

#include <algorithm>
#include <filesystem>

#include "Options/Arguments.hpp"
#include "Options/Choice.hpp"
#include "Options/UsageError.hpp"
#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

void rotate(RigidTransform<double>& placement, const std::string& text) {
  constexpr const char* kNeed = "degrees and an axis, x, y or z or three numbers: 90,x or 30,1,1,0";
  const auto comma = text.find(',');
  const auto axis = comma == std::string::npos ? std::string() : text.substr(comma + 1);
  if (axis == "x" || axis == "y" || axis == "z") {
    placement.rotate(numbers("--rotate", text.substr(0, comma), kNeed).front(),
                     axisOf("--rotate", axis));
    return;
  }
  const auto values = numbers("--rotate", text, kNeed);
  if (values.size() != 4 || (values[1] == 0 && values[2] == 0 && values[3] == 0)) {
    refuse("--rotate", text, kNeed);
  }
  placement.rotate(values[0], Vec3<double>{values[1], values[2], values[3]});
}

}  // namespace

std::string extensionOf(const std::string& file) {
  auto extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

void addQuiet(Command command, bool& quiet) {
  command.addFlag("-q,--quiet", "Say nothing but errors", quiet);
}

void addSurfaceOptions(Command command, SurfaceOptions& options, Reads reads) {
  const std::string scenes =
      reads == Reads::SurfacesAndScenes ? ", or a scene in TOML: see 'cutwater scene'" : "";
  const auto readFile = [&](const std::string& file) {
    if (file == "-") throw UsageError("FILE", "'-': standard input is called /dev/stdin");
    options.file = file;
  };
  command
      .add("FILE", "TEXT",
           anySurfaceFormats("or") + ", also gzip-compressed, or what 'cutwater prepare' wrote" +
               scenes,
           readFile)
      .required();
  command.add("--scale", "FACTOR",
              "Multiply the file's coordinates first; 0.001: millimetres to metres",
              [&](const std::string& text) {
                options.scale = positiveNumber("--scale", text);
                options.motions += " --scale " + text;
              });
  // The functions are called as options are read, so that motions act in the order given.
  command.addInOrder("--translate", "X,Y,Z", "Then move the surface; may be repeated",
                     [&](const std::string& text) {
                       options.placement.translate(vectorOf("--translate", text));
                       options.motions += " --translate " + text;
                     });
  command.addInOrder(
      "--rotate", "DEGREES,AXIS",
      "Turn the surface about an axis through the origin, in the order given with --translate; "
      "may be repeated",
      [&](const std::string& text) {
        rotate(options.placement, text);
        options.motions += " --rotate " + text;
      });
  command.addNumber("--threads", "N", "Number of threads; 0: all there are [default: 0]",
                    options.threads, {0, 4096});
  addQuiet(command, options.quiet);
}

void addSignOptions(Command command, SurfaceOptions& options) {
  addChoice<SignScheme>(
      command, "--signs", options.solid.signs,
      {{"auto", SignScheme::Automatic},
       {"nearest", SignScheme::NearestFeature},
       {"winding", SignScheme::WindingNumber}},
      "How inside is decided: by the nearest faces, or by the winding number, for "
      "open and overlapping surfaces; auto: a check of the surface chooses "
      "[default: auto]");
  command.addFlag("--require-watertight", "Refuse a surface that does not bound a solid",
                  options.solid.requireWatertight);
}

bool isScene(const SurfaceOptions& options) {
  return extensionOf(options.file) == ".toml";
}

std::string fileName(const SurfaceOptions& options) {
  return onOneLine(std::filesystem::path(options.file).filename().string());
}

}  // namespace cutwater::tool
