#pragma once

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include "Options/SurfaceOptions.hpp"

// The surface or the solid that a command's options name.
namespace cutwater::tool {

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

/// Where to look at the solid: the box of a surface's faces, beyond which the inside of an open one
/// may reach, or the bounding box of a scene's solid. Infinite for an unbounded scene.
[[nodiscard]] Box<double> boxAround(const Solid<double>& solid);

/// XXH64 of the surface's file, or, for a prepared one, of the file that it was made from; 0 if it
/// cannot be read twice.
[[nodiscard]] std::uint64_t sourceHash(const SurfaceOptions& options);

}  // namespace cutwater::tool
