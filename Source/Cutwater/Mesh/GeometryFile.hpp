#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace cutwater {

// A geometry file consists of a header and of a MeshSDF's block of arrays as it lies in memory:
//
//   64 bytes   magic, version, byte order, bytes per number, sizes, the caller's mark of the
//              source, checksum of the block
//   words      of 8 bytes each: offset, number and size of the elements of every array; then
//              frames, options, sign report and placement; zeros up to a multiple of 64 bytes;
//              the last word is the checksum of the header before it
//   the block  arrays, each starting at a multiple of 64 bytes, with zeros between them
//
// The bytes depend on the mesh, the byte order and the version of the library, but not on threads
// or instruction sets.

/// Version of the layout: raised whenever the meaning of the bytes of an array or of the header
/// changes.
inline constexpr std::uint32_t kGeometryFileVersion = 6;

/// How MeshSDF::view() and open() check bytes before they trust them.
struct MeshViewOptions {
  /// Check the arrays: their checksum, and every index in them. This reads all bytes, at the speed
  /// of memory. If false, only the header is read and checked: for callers who know that another
  /// process on the node has verified the very same bytes. If these are damaged, the behaviour is
  /// undefined.
  bool verifyPayload = true;
  /// The checks use at most this many threads (see ParallelOptions).
  int threads = 0;
};

/// What a geometry file states about itself; none of it has been verified.
struct GeometryFileInfo {
  std::uint32_t version = 0;
  std::uint32_t bytesPerNumber = 0;  ///< 4: for MeshSDF<float>; 8: for MeshSDF<double>
  std::uint64_t source = 0;          ///< see MeshSDF::toBytes()
};

/// Returns nothing if the bytes are of another format.
[[nodiscard]] std::optional<GeometryFileInfo> geometryFileInfo(std::span<const std::byte> bytes);
/// The same for a file; returns nothing if it is not a regular file that can be read.
[[nodiscard]] std::optional<GeometryFileInfo> geometryFileInfo(const std::filesystem::path& path);

}  // namespace cutwater
