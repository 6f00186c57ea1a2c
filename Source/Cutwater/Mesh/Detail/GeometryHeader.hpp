// Private: the header of a geometry file; see GeometryFile.hpp.
#pragma once

#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Mesh/Detail/MeshLayout.hpp>
#include <Cutwater/Mesh/GeometryFile.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace cutwater::detail {

/// The first bytes of a geometry file; the same for both precisions.
struct GeometryHead {
  static constexpr std::uint32_t kByteOrder = 0x01020304;

  std::array<char, 8> magic{'\x89', 'C', 'u', 't', 'w', 'a', 't', '\x1a'};
  std::uint32_t version = kGeometryFileVersion;
  std::uint32_t byteOrder = kByteOrder;
  std::uint32_t bytesPerNumber = 0;
  std::uint32_t unused = 0;
  std::uint64_t headerBytes = 0;
  std::uint64_t fileBytes = 0;
  std::uint64_t source = 0;
  std::uint64_t blockChecksum = 0;
  std::uint64_t unusedToo = 0;
};
static_assert(sizeof(GeometryHead) == 64);

/// Whether the bytes begin like a geometry file, as far as they go; false if there are none.
[[nodiscard]] bool isGeometry(std::span<const std::byte> bytes);
/// Reads the head; fields beyond the end keep their initial values.
[[nodiscard]] GeometryHead geometryHead(std::span<const std::byte> bytes);

/// Everything in a MeshSDF and its index, except the block.
template <std::floating_point T>
struct MeshRecord {
  MeshLayout<T> layout;
  MeshSDFOptions options;
  SignReport signs;
  RigidTransform<T> placement;
  std::uint64_t patches = 0;  ///< patch ids of polygons are below this; there may be fewer names
  std::uint64_t source = 0;
};

/// Returns the header for this block; its size is a multiple of 64 bytes.
template <std::floating_point T>
[[nodiscard]] std::vector<std::byte> geometryHeader(const MeshRecord<T>& record,
                                                    std::span<const std::byte> block);

/// The contents of a geometry file. The block is a part of the file's bytes.
template <std::floating_point T>
struct Geometry {
  MeshRecord<T> record;
  Block block;
};

/// Reads the header and checks everything that follows from it and from the number of bytes; on
/// request, also the block's checksum and contents.
/// @throws Error(File) that states what is wrong, but not in which file.
template <std::floating_point T>
[[nodiscard]] Geometry<T> readGeometry(const Block& bytes, const MeshViewOptions& options);

}  // namespace cutwater::detail
