#pragma once

#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// The faces of a FluidMesh, in any order at first.
class FaceRows {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// Adds one: its corners are counterclockwise as seen from outside of the cell. `other`: the cell
  /// there; kNone: it is in a patch.
  void add(std::span<const std::uint32_t> corners, std::uint32_t cell, std::uint32_t other,
           std::uint32_t patch);

  /// The number of faces that a cell has so far.
  [[nodiscard]] std::size_t countOf(std::uint32_t cell) const {
    return cell < counts_.size() ? counts_[cell] : 0;
  }

  /// The faces in order. Those between the same two cells that lie in one plane across an axis, as
  /// where a piece was joined to another one, are one face if they have one rim.
  [[nodiscard]] FluidMesh::Faces inOrder(std::size_t cells, std::span<const Vec3<double>> points,
                                         std::vector<FluidMesh::Patch>& patches) const;

 private:
  [[nodiscard]] std::span<const std::uint32_t> cornersOf(std::uint32_t face) const {
    return std::span(corners_).subspan(first_[face], first_[face + 1] - first_[face]);
  }
  [[nodiscard]] std::vector<CornerLoop> joined(std::span<const std::uint32_t> faces,
                                               std::span<const Vec3<double>> points) const;

  std::vector<std::uint64_t> first_{0};
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> owner_;
  std::vector<std::uint32_t> other_;  // cell, or patch
  std::vector<char> isInner_;
  std::vector<std::uint32_t> counts_;  // of cells, up to the last one that has any
};

}  // namespace cutwater
