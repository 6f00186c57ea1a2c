#pragma once

#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Mesh/SignScheme.hpp>

#include <string>
#include <vector>

#include "Options/Command.hpp"

namespace cutwater::tool {

/// Options of every subcommand that reads a surface.
struct SurfaceOptions {
  std::string file;
  double scale = 1;
  RigidTransform<double> placement;
  std::string motions;  ///< --scale, --translate and --rotate as they were given
  int threads = 0;
  bool quiet = false;
  bool mayBeOpen = false;  ///< nothing is said of its signs then: a command sees to openings
  MeshSDFOptions solid;
};

/// The kinds of file that a command accepts as FILE.
enum class Reads : std::uint8_t { Surfaces, SurfacesAndScenes };

/// Adds FILE, --scale, --translate, --rotate, --threads and --quiet. Motions act in the order
/// given. `options` must outlive the command.
void addSurfaceOptions(Command command, SurfaceOptions& options, Reads reads = Reads::Surfaces);
/// Adds --signs and --require-watertight, for commands that call loadMesh() or loadSolid().
void addSignOptions(Command command, SurfaceOptions& options);
void addQuiet(Command command, bool& quiet);

/// Whether the file is a scene: its name ends in .toml.
[[nodiscard]] bool isScene(const SurfaceOptions& options);

/// The extension in lower case: ".stl".
[[nodiscard]] std::string extensionOf(const std::string& file);

/// The file's name for people, on one line: "hull.stl.gz".
[[nodiscard]] std::string fileName(const SurfaceOptions& options);

}  // namespace cutwater::tool
