// Private: the header of a geometry file; see GeometryFile.hpp.
#pragma once

#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Mesh/GeometryFile.hpp>
#include <Cutwater/Mesh/MeshLayout.hpp>

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

/// Whether they begin like a geometry file, as far as they go.
[[nodiscard]] bool isGeometry(std::span<const std::byte> bytes);
/// Zeros stand for what is beyond the end.
[[nodiscard]] GeometryHead geometryHead(std::span<const std::byte> bytes);

/// All of a MeshSDF but its block.
template <std::floating_point T>
struct MeshRecord {
  MeshLayout<T> layout;
  MeshSDFOptions options;
  SignReport signs;
  RigidTransform<T> placement;
  std::uint64_t patches = 0;  ///< ids of polygons' patches are below; there may be fewer names
  std::uint64_t source = 0;
};

/// The header for this block: a multiple of 64 bytes.
template <std::floating_point T>
[[nodiscard]] std::vector<std::byte> geometryHeader(const MeshRecord<T>& record,
                                                    std::span<const std::byte> block);

/// What a geometry file consists of. The block is a part of the bytes.
template <std::floating_point T>
struct Geometry {
  MeshRecord<T> record;
  Block block;
};

/// Reads the header, and checks all that can be told from it and the number of bytes; the block's
/// checksum and contents if that is wanted.
/// @throws Error(File) that says what is wrong, but not with which file.
template <std::floating_point T>
[[nodiscard]] Geometry<T> readGeometry(const Block& bytes, const MeshViewOptions& options);

}  // namespace cutwater::detail
