#pragma once

#include <Cutwater/Core/Checksum.hpp>

#include "Mesh/GeometryFiles.hpp"

namespace cutwater::test {

inline constexpr std::size_t kHead = 64;
inline constexpr std::size_t kBlockChecksum = 48;

/// Bytes whose checksums are made good after a change: what only a forger would do.
class ForgedBytes : public EditableBytes {
 public:
  using EditableBytes::EditableBytes;

  [[nodiscard]] std::size_t headerBytes() const { return read<std::uint64_t>(24); }
  /// Of word i behind the first bytes.
  [[nodiscard]] static std::size_t word(std::size_t i) { return kHead + 8 * i; }
  [[nodiscard]] std::size_t wordCount() const { return (headerBytes() - kHead) / 8 - 1; }
  /// Of element i, `element` bytes long, of an array as the header lists them.
  [[nodiscard]] std::size_t place(std::size_t array, std::size_t i = 0) const {
    return headerBytes() + read<std::uint64_t>(word(3 * array)) + i * elementBytes(array);
  }
  [[nodiscard]] std::size_t count(std::size_t array) const {
    return read<std::uint64_t>(word(3 * array + 1));
  }
  [[nodiscard]] std::size_t elementBytes(std::size_t array) const {
    return read<std::uint64_t>(word(3 * array + 2));
  }
  void makeGood() {
    write(kBlockChecksum, checksum(bytes().subspan(headerBytes())));
    write(headerBytes() - 8, xxHash64(bytes().first(headerBytes() - 8)));
  }
};

/// In the order of the header.
enum ArrayOf : std::size_t {
  Positions,
  Triangles,
  Neighbours,
  Slivers,
  Pseudonormals,
  PolygonIds,
  Patches,
  Nodes,
  Slots,
  Packets,
  Hulls,
  HullsOfNode,
  CapPositions,
  CapTriangles,
  CapNodes,
  CapSlots,
  Moments,
  WindingEdges,
  OpenEdges,
  InsideOut,
  PatchNames,
  Fronts,
  SignCellBytes
};

inline constexpr std::size_t kArrays = SignCellBytes + 1;

/// What it says when `Number` stands there instead; the bytes are as before afterwards.
template <typename T, typename Number>
std::string refusalWith(ForgedBytes& bytes, std::size_t at, Number number) {
  const auto before = bytes.read<Number>(at);
  bytes.write(at, number);
  bytes.makeGood();
  const auto result = refusal<T>(bytes.bytes());
  bytes.write(at, before);
  bytes.makeGood();
  return result;
}

}  // namespace cutwater::test
