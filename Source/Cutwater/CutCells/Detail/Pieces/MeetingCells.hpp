#pragma once

#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>

namespace cutwater {

/// Finds the pieces of cells in which the surface meets itself, one after the other: the cell is
/// divided by the planes of its triangles, see SheetTree, and what lies at winding numbers of 0 and
/// less is joined. In floating point: pieces are right where walls and gaps are thicker than
/// rounding, and close in any case.
class MeetingCells {
 public:
  MeetingCells(const FacePieces& faces, std::span<const std::uint32_t> arcOfFullFace,
               CellPieces& out)
      : faces_(faces), arcOfFullFace_(arcOfFullFace), out_(out) {}

  /// Adds those of the cell with these fragments.
  void build(std::span<const TileFragment> fragments);

 private:
  const FacePieces& faces_;
  std::span<const std::uint32_t> arcOfFullFace_;
  CellPieces& out_;
};

}  // namespace cutwater
