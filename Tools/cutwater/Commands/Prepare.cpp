#include <Cutwater/Surface/ReadSurface.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "Commands/Commands.hpp"
#include "Options/Arguments.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/OutputFile.hpp"
#include "Report/Format.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct PrepareSettings {
  SurfaceOptions surface;
  std::string output;
  bool inFloat = false;
};

template <std::floating_point T>
void prepare(const PrepareSettings& options, const MeshSDF<T>& solid, double seconds) {
  Stopwatch watch;
  solid.save(options.output, sourceHash(options.surface));
  const double secondsToWrite = watch.lap();
  static_cast<void>(MeshSDF<T>::open(options.output));
  const double secondsToOpen = watch.lap();
  if (options.surface.quiet) return;
  std::cout << "wrote " << onOneLine(options.output) << ": "
            << grouped(solid.triangleCount(), "triangle") << " in "
            << (sizeof(T) == 4 ? "single" : "double") << " precision, "
            << bytes(std::filesystem::file_size(options.output)) << '\n'
            << "built in " << duration(seconds) << ", written in " << duration(secondsToWrite)
            << ", opened and verified in " << duration(secondsToOpen) << '\n';
}

/// Any name but those of other files, as it is the content that tells what a file is.
void requireOwnName(const std::string& path) {
  const auto extension = extensionOf(path);
  const bool isSurface =
      std::ranges::count(kSurfaceFormats, extension, &SurfaceFormatNames::extension) > 0;
  if (isSurface || path == "-" || extension == ".gz" || extension == ".toml") {
    refuse("--output", path, "a name for a prepared file, such as FILE.cutwater");
  }
}

void run(const PrepareSettings& options) {
  Stopwatch watch;
  if (options.inFloat) {
    const auto solid = loadMesh<float>(options.surface);
    prepare(options, solid, watch.lap());
  } else {
    const auto solid = loadMesh<double>(options.surface);
    prepare(options, solid, watch.lap());
  }
}

}  // namespace

void addPrepare(Program& program) {
  const auto options = std::make_shared<PrepareSettings>();
  auto command = program.addCommand(
      "prepare", "Build a surface's tree and signs once, as a file that is ready to be used");
  addSurfaceOptions(command, options->surface);
  addSignOptions(command, options->surface);
  command
      .add("-o,--output", "FILE.cutwater", "The geometry file to write",
           [=](const std::string& path) {
             requireOwnName(path);
             prepareOutput(path);
             options->output = path;
           })
      .required();
  command.addFlag("--float",
                  "In single precision, for codes that compute in it; other commands build anew "
                  "from its triangles",
                  options->inFloat);
  command.setFooter(
      "Examples:\n"
      "  cutwater prepare hull.stl -o hull.cutwater\n"
      "  cutwater prepare part.stl --scale 0.001 --signs winding -o part.cutwater\n"
      "\n"
      "Every command that reads a surface takes such a file, too; MeshSDF::open() maps it.\n"
      "Told to move it or to decide signs otherwise, they build it anew from its triangles.");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
