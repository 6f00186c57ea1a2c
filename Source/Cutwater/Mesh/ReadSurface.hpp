#pragma once

#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Mesh/PolygonSoup.hpp>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// What files readSurface() reads.
enum class SurfaceFormat : std::uint8_t { Stl, Obj, Ply, Off, Vtk };

/// Options of readSurface().
struct ReadOptions {
  /// Coordinates are multiplied by this first (0.001: a file in millimetres, a model in metres),
  /// ...
  double scale = 1;
  /// ... and then moved.
  RigidTransform<double> placement = {};
  /// Merge points with equal coordinates. STL has no shared points without it.
  bool weld = true;
  /// Refuse files that decompress to more bytes than this.
  std::uint64_t maxBytes = std::uint64_t{16} << 30U;
};

/// What the reader saw and did; nothing in it is an error.
struct ReadReport {
  SurfaceFormat format{};
  bool binary = false;
  bool compressed = false;
  std::uint64_t bytes = 0;  ///< after decompression
  std::size_t pointsInFile = 0;
  std::size_t pointsMerged = 0;  ///< by welding
  std::size_t pointsUnused = 0;  ///< after welding; no polygon uses them, they are kept
  std::size_t polygonsInFile = 0;
  std::vector<std::string> notes;  ///< oddities accepted, one sentence each
};

/// A surface, and how it was read.
struct SurfaceFile {
  PolygonSoup soup;
  ReadReport report;
};

/// Reads STL, OBJ, PLY, OFF or legacy VTK, each also gzip-compressed. The content decides which,
/// not the name.
///
/// Polygons stay as they are in the file, in its order; only triangle strips of VTK become
/// triangles. Normals, colours and texture coordinates are not kept. Numbers are read in the C
/// locale always, and those out of a double's range are errors, not infinity or zero.
///
/// Patches are the named solids of STL. In OBJ the group (g) in force names a face's patch, as its
/// whole line; where there is none the object (o) does, or else the material (usemtl); a new object
/// ends the group. Equal names are one patch; a patch has at least one face. Faces without a name
/// belong to a patch named after the file: "hull" for models/hull.stl.gz.
///
/// Time is linear in the size of the (decompressed) file, memory at most 16 times that.
///
/// @throws Error(File) "path: line 7: ..." or "path: byte 84: ..." (in the decompressed data) for
/// what is malformed or has no face, before anything large is allocated; Error(Limit) beyond
/// maxBytes or 2^32 - 2 points or faces; Error(Argument) unless 0 < scale < infinity. Where memory
/// runs out, std::bad_alloc, as everywhere in the library; nothing is left behind then.
[[nodiscard]] SurfaceFile readSurface(const std::filesystem::path& path,
                                      const ReadOptions& options = {});

/// The same from memory; `name` stands in messages where the path would.
[[nodiscard]] SurfaceFile readSurface(std::span<const std::byte> bytes, const std::string& name,
                                      const ReadOptions& options = {});

}  // namespace cutwater
