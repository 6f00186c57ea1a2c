#pragma once

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <chrono>
#include <optional>
#include <string>
#include <utility>

namespace CLI {
class App;
}

namespace cutwater::tool {

/// Options of every subcommand that reads a surface.
struct SurfaceOptions {
  std::string file;
  double scale = 1;
  RigidTransform<double> placement;
  std::string motions;  ///< --scale, --translate and --rotate as they were given
  int threads = 0;
  bool quiet = false;
  MeshSDFOptions solid;
};

/// The kinds of file that a command accepts as FILE.
enum class Reads : std::uint8_t { Surfaces, SurfacesAndScenes };

/// Adds FILE, --scale, --translate, --rotate, --threads and --quiet. Motions act in the order
/// given. `options` must outlive the command.
void addSurfaceOptions(CLI::App& command, SurfaceOptions& options, Reads reads = Reads::Surfaces);
/// Adds --signs and --require-watertight, for commands that call loadMesh() or loadSolid().
void addSignOptions(CLI::App& command, SurfaceOptions& options);
void addQuiet(CLI::App& command, bool& quiet);

class Stopwatch {
 public:
  /// Seconds since the start or the last call.
  double lap() {
    const auto before = std::exchange(start_, std::chrono::steady_clock::now());
    return std::chrono::duration<double>(start_ - before).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Information on a file that `cutwater prepare` wrote.
struct Prepared {
  GeometryFileInfo info;
  std::string signs;
};

/// A surface as read, with the time that reading and welding took.
struct LoadedSurface {
  PolygonSoup soup;
  ReadReport report;  ///< of the file; nothing is welded yet
  std::size_t pointsMerged = 0;
  double secondsToRead = 0;
  double secondsToWeld = 0;
  std::optional<Prepared> prepared = {};  ///< if set, the soup holds its triangles
};

/// Whether the file is a scene: its name ends in .toml.
[[nodiscard]] bool isScene(const SurfaceOptions& options);

/// @throws Error if the file cannot be read, or is a scene.
[[nodiscard]] LoadedSurface load(const SurfaceOptions& options);

/// The surface of the file as a signed distance function. Reports what its signs are based on,
/// unless that is sound or --quiet is given.
/// @throws Error if the file cannot be read or has no faces.
template <std::floating_point T = double>
[[nodiscard]] MeshSDF<T> loadMesh(const SurfaceOptions& options);

/// The same, or the solid of a scene.
/// @throws Error also if the options request other signs for a scene.
[[nodiscard]] Solid<double> loadSolid(const SurfaceOptions& options);

/// Where to look at the solid: its bounding box or, where signs by the nearest faces leave a
/// surface unbounded, the box of its faces. Infinite for an unbounded scene.
[[nodiscard]] Box<double> boxAround(const Solid<double>& solid);

/// XXH64 of the surface's file, or, for a prepared one, of the file that it was made from; 0 if it
/// cannot be read twice.
[[nodiscard]] std::uint64_t sourceHash(const SurfaceOptions& options);

/// The extension in lower case: ".stl".
[[nodiscard]] std::string extensionOf(const std::string& file);

/// The file's name for people: "hull.stl.gz".
[[nodiscard]] std::string fileName(const SurfaceOptions& options);

}  // namespace cutwater::tool
