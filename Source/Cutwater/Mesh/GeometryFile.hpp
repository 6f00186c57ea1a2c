#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace cutwater {

// A geometry file is a MeshSDF's block of arrays as it lies in memory, behind a header:
//
//   64 bytes   magic, version, byte order, bytes per number, sizes, the caller's mark of the
//   source,
//              checksum of the block
//   words      of 8 bytes each: offset, number and size of the elements of every array; then
//   frames,
//              options, sign report and placement; zeros up to a multiple of 64 bytes; the last
//              word is the checksum of the header before it
//   the block  arrays, each from a multiple of 64 bytes on, with zeros between them
//
// The bytes depend on the mesh, on the byte order and on the version of the library; not on threads
// or instruction sets.

/// Of the layout: to be raised whenever the bytes of an array or of the header mean something else.
inline constexpr std::uint32_t kGeometryFileVersion = 1;

/// How MeshSDF::view() and open() look at bytes before they trust them.
struct MeshViewOptions {
  /// Check the arrays: their checksum, and every index in them. It reads all bytes, at the speed of
  /// memory. Without it nothing but the header is read and checked: for those who know that another
  /// process on the node has verified the very same bytes. If these are damaged, anything may
  /// happen.
  bool verifyPayload = true;
  /// At most so many verify (see ParallelOptions).
  int threads = 0;
};

/// What a geometry file says of itself; nothing of it has been verified.
struct GeometryFileInfo {
  std::uint32_t version = 0;
  std::uint32_t bytesPerNumber = 0;  ///< 4: for MeshSDF<float>; 8: for MeshSDF<double>
  std::uint64_t source = 0;          ///< see MeshSDF::toBytes()
};

/// Nothing, if the bytes are of another format.
[[nodiscard]] std::optional<GeometryFileInfo> geometryFileInfo(std::span<const std::byte> bytes);
/// The same; nothing, if this is no regular file that can be read.
[[nodiscard]] std::optional<GeometryFileInfo> geometryFileInfo(const std::filesystem::path& path);

}  // namespace cutwater
