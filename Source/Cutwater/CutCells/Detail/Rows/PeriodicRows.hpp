// Private: rows of boxes that span a whole period.
#pragma once

#include <Cutwater/CutCells/CutCells.hpp>

namespace cutwater {

/// Whether the box has all cells of a period along an axis, so that those beyond it are its own.
[[nodiscard]] inline bool spansPeriod(const CellPlanes& grid, int axis) {
  const auto period = grid.period[static_cast<std::size_t>(axis)];
  return period > 0 &&
         std::int64_t{period} == static_cast<std::int64_t>(grid.indices().length(axis));
}

/// The same cell in the box, along axes where the box spans a period.
[[nodiscard]] inline Index3 inPeriod(const CellPlanes& grid, Index3 cell) {
  const auto [lo, hi] = grid.indices();
  const auto wrap = [&](std::int32_t& at, std::int32_t lower, std::int32_t upper, int axis) {
    if (at >= lower && at <= upper) return;
    if (spansPeriod(grid, axis)) at = at < lower ? upper : lower;
  };
  wrap(cell.i, lo.i, hi.i, 0);
  wrap(cell.j, lo.j, hi.j, 1);
  wrap(cell.k, lo.k, hi.k, 2);
  return cell;
}

/// The piece of the box that one beyond it is, or what stands in its place: kBeyond if there is
/// none.
[[nodiscard]] inline std::uint32_t pieceInPeriod(const CutCells& cells, std::uint32_t piece) {
  if (piece < cells.pieceCount || piece >= cells.pieces.cell.size()) return piece;
  const auto row = cells.pieces.cell[piece];
  const auto own = cells.rowOf(inPeriod(cells.grid, cells.cells.index[row]));
  if (own == CutCells::kNoRow) return CutCells::kBeyond;
  const auto same = cells.cells.firstPiece[own] + (piece - cells.cells.firstPiece[row]);
  return same < cells.cells.firstPiece[own + 1] ? same : CutCells::kBeyond;
}

}  // namespace cutwater
