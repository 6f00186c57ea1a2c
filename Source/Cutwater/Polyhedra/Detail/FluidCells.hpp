#pragma once

#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>
#include <Cutwater/Polyhedra/Detail/KeptRegions.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <cstdint>
#include <vector>

namespace cutwater {

/// Which cell of a FluidMesh holds a piece or a leaf that is all fluid. Cells are numbered in the
/// order of leaves, so that neighbours in space mostly have close numbers.
class FluidCells {
 public:
  static constexpr std::uint32_t kNone = KeptRegions::kNone;

  /// `smallest`: see FluidMeshOptions.
  FluidCells(const CutLeaves& leaves, const LeafGrid& grid, const KeptRegions& regions,
             double smallest);

  [[nodiscard]] std::uint32_t ofPiece(std::uint32_t piece) const { return cells_[piece]; }
  [[nodiscard]] std::uint32_t ofLeaf(std::uint32_t leaf) const { return cells_[pieces_ + leaf]; }
  /// The cell beside an arc, kNone for CutLeaves::kBeyond.
  [[nodiscard]] std::uint32_t beside(std::uint32_t piece, std::uint32_t leaf) const {
    if (piece == CutLeaves::kBeyond) return kNone;
    return piece == CutLeaves::kWholeCell ? ofLeaf(leaf) : ofPiece(piece);
  }
  [[nodiscard]] const FluidMesh::Cells& rows() const { return rows_; }
  [[nodiscard]] std::size_t joinedPieces() const { return joinedPieces_; }

 private:
  class Joining;

  std::uint32_t pieces_;
  std::vector<std::uint32_t> cells_;  // of each piece; then of each leaf
  FluidMesh::Cells rows_;
  std::size_t joinedPieces_ = 0;
};

}  // namespace cutwater
