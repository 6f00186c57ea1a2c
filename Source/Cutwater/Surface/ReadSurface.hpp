#pragma once

#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cutwater {

/// The formats of files that readSurface() reads and writeSurface() writes, and Vtp, which only
/// readAnySurface() reads.
enum class SurfaceFormat : std::uint8_t { Stl, Obj, Ply, Off, Vtk, Vtp };

/// What people call a format, and its files.
struct SurfaceFormatNames {
  SurfaceFormat format;
  std::string_view name;
  std::string_view extension;  ///< in lower case
};

/// All formats, in the order of SurfaceFormat. Lists of them in messages are made from this.
inline constexpr std::array kSurfaceFormats{
    SurfaceFormatNames{SurfaceFormat::Stl, "STL", ".stl"},
    SurfaceFormatNames{SurfaceFormat::Obj, "OBJ", ".obj"},
    SurfaceFormatNames{SurfaceFormat::Ply, "PLY", ".ply"},
    SurfaceFormatNames{SurfaceFormat::Off, "OFF", ".off"},
    SurfaceFormatNames{SurfaceFormat::Vtk, "legacy VTK", ".vtk"},
    SurfaceFormatNames{SurfaceFormat::Vtp, "VTP", ".vtp"},
};

/// The names of one format.
[[nodiscard]] constexpr const SurfaceFormatNames& namesOf(SurfaceFormat format) {
  return kSurfaceFormats[static_cast<std::size_t>(format)];
}

/// Those of readSurface() and writeSurface().
inline constexpr std::span<const SurfaceFormatNames> kReadSurfaceFormats{
    kSurfaceFormats.data(), kSurfaceFormats.size() - 1};

/// "STL, OBJ, PLY, OFF, legacy VTK or VTP", if the conjunction is "or".
[[nodiscard]] std::string anySurfaceFormats(std::string_view conjunction);

/// "STL, OBJ, PLY, OFF or legacy VTK", if the conjunction is "or".
[[nodiscard]] std::string surfaceFormats(std::string_view conjunction);

/// ".stl, .obj, .ply, .off or .vtk", if the conjunction is "or".
[[nodiscard]] std::string surfaceExtensions(std::string_view conjunction);

/// Options of readSurface().
struct ReadOptions {
  /// Coordinates are multiplied by this first (0.001 for a file in millimetres and a model in
  /// metres).
  double scale = 1;
  /// They are then moved by this.
  RigidTransform<double> placement = {};
  /// Merge points with equal coordinates. Without it, STL has no shared points.
  bool weld = true;
  /// Refuse files that decompress to more bytes than this.
  std::uint64_t maxBytes = std::uint64_t{16} << 30U;
};

/// What the reader found and did; none of it is an error.
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

/// A surface and the report of its reader.
struct SurfaceFile {
  PolygonSoup soup;
  ReadReport report;
};

/// Reads STL, OBJ, PLY, OFF or legacy VTK, optionally gzip-compressed. The content decides the
/// format, not the name.
///
/// Polygons stay as they are in the file, in the same order; only triangle strips of VTK are split
/// into triangles. Normals, colours and texture coordinates are not kept. Numbers are always read
/// in the C locale; those outside a double's range are errors, not infinity or zero.
///
/// Patches are the named solids of STL. In OBJ, the current group (g), taken as its whole line,
/// names a face's patch; without a group the object (o) does, or else the material (usemtl); a new
/// object ends the group. Equal names are one patch; a patch has at least one face. Faces without a
/// name belong to a patch named after the file: "hull" for models/hull.stl.gz.
///
/// Time is linear in the size of the (decompressed) file; memory is at most 16 times that size.
///
/// @throws Error(File) "path: line 7: ..." or "path: byte 84: ..." (in the decompressed data) if
/// the content is malformed or has no face, before anything large is allocated; Error(Limit) beyond
/// maxBytes or 2^32 - 2 points or faces; Error(Argument) unless 0 < scale < infinity. When memory
/// runs out, std::bad_alloc, as everywhere in the library; nothing is left behind then.
[[nodiscard]] SurfaceFile readSurface(const std::filesystem::path& path,
                                      const ReadOptions& options = {});

/// The same from memory; `name` replaces the path in messages.
[[nodiscard]] SurfaceFile readSurface(std::span<const std::byte> bytes, const std::string& name,
                                      const ReadOptions& options = {});

}  // namespace cutwater
