#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/CellPieces.hpp>
#include <Cutwater/CutCells/Detail/CutSurface.hpp>

namespace cutwater {

/// The parts of a piece's wall, in the order of patches.
[[nodiscard]] std::span<const PieceWall> wallsOf(const CellPieces& content, std::uint32_t piece);

/// Appends a piece of a tile, in the coordinates of the world, to the rows of the cell `row`.
void addPieceRows(const CellPieces& content, std::uint32_t piece, const CutFrame& frame,
                  std::uint32_t row, CutCells::Pieces& pieces, CutCells::WallParts& wallParts);

}  // namespace cutwater
