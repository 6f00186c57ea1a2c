#pragma once

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Mesh/ReadSurface.hpp>
#include <Cutwater/Mesh/WriteSurface.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <chrono>
#include <optional>
#include <string>
#include <utility>

namespace CLI {
class App;
}

namespace cutwater::tool {

/// What every subcommand that reads a surface is told.
struct SurfaceOptions {
  std::string file;
  double scale = 1;
  RigidTransform<double> placement;
  std::string motions;  ///< --scale, --translate and --rotate as they were given
  int threads = 0;
  bool quiet = false;
  MeshSDFOptions solid;
};

/// What a command's FILE may be.
enum class Reads : std::uint8_t { Surfaces, SurfacesAndScenes };

/// Adds FILE, --scale, --translate, --rotate, --threads and --quiet. Motions act in the order they
/// are given. `options` must live as long as the command.
void addSurfaceOptions(CLI::App& command, SurfaceOptions& options, Reads reads = Reads::Surfaces);
/// Adds --signs and --require-watertight, for commands that call loadMesh() or loadSolid().
void addSignOptions(CLI::App& command, SurfaceOptions& options);
void addQuiet(CLI::App& command, bool& quiet);

class Stopwatch {
 public:
  /// Seconds since the start, or since it was asked last.
  double lap() {
    const auto before = std::exchange(start_, std::chrono::steady_clock::now());
    return std::chrono::duration<double>(start_ - before).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What is known of a file that `cutwater prepare` wrote.
struct Prepared {
  GeometryFileInfo info;
  std::string signs;
};

/// A surface as read, with what reading and welding took.
struct LoadedSurface {
  PolygonSoup soup;
  ReadReport report;  ///< of the file; nothing is welded yet
  std::size_t pointsMerged = 0;
  double secondsToRead = 0;
  double secondsToWeld = 0;
  std::optional<Prepared> prepared = {};  ///< the soup holds its triangles then
};

/// Whether the file is a scene: its name ends in .toml.
[[nodiscard]] bool isScene(const SurfaceOptions& options);

/// @throws Error if the file cannot be read, or is a scene.
[[nodiscard]] LoadedSurface load(const SurfaceOptions& options);

/// The surface of the file as a signed distance function. Says what its signs rest on, unless that
/// is sound or nothing is to be said.
/// @throws Error if the file cannot be read or has no faces.
template <std::floating_point T = double>
[[nodiscard]] MeshSDF<T> loadMesh(const SurfaceOptions& options);

/// The same, or the solid of a scene.
/// @throws Error also if a scene is to have other signs than it says.
[[nodiscard]] Solid<double> loadSolid(const SurfaceOptions& options);

/// XXH64 of the surface's file, or of the file that a prepared one was made from; 0 if it cannot be
/// read twice.
[[nodiscard]] std::uint64_t sourceHash(const SurfaceOptions& options);

/// The surface as the file will hold it: binary STL has single precision. What is equal then is
/// one.
[[nodiscard]] PolygonSoup asWritten(const std::string& file, PolygonSoup soup,
                                    const WriteOptions& options);

/// Writes the surface in the format that the file's extension tells. STL holds triangles only: for
/// it, polygons are cut. Returns how many polygons were written.
std::size_t write(const std::string& file, const PolygonSoup& soup, const WriteOptions& options);

/// For people: "hull.stl.gz".
[[nodiscard]] std::string fileName(const SurfaceOptions& options);

}  // namespace cutwater::tool
