// Private: rows of boxes that span a whole period.
#pragma once

#include <Cutwater/CutCells/CutCells.hpp>

namespace cutwater {

/// Whether a box has all cells of a period along each axis, so that those beyond it are its own.
using SpannedAxes = std::array<bool, 3>;
[[nodiscard]] SpannedAxes spannedAxes(const CellPlanes& grid);

/// A cell of the box for one beyond it, along axes that the box spans.
[[nodiscard]] Index3 inPeriod(const CellPlanes& grid, const SpannedAxes& spanned, Index3 cell);

/// What is beside an arc in a cell, as the box has it: of a piece beyond the box that of the box;
/// kBeyond if the box knows nothing such.
[[nodiscard]] std::uint32_t sideInPeriod(const CutCells& cells, const SpannedAxes& spanned,
                                         const Index3& cell, std::uint32_t side);

/// The rows with each arc between both ends of a period once, at the low end, where it lies between
/// two pieces of the box; what is below it is at the high end. Without polygons.
[[nodiscard]] CutCells withJoinedEnds(const CutCells& cells, const SpannedAxes& spanned);

/// The inverse, for rows of the box alone: arcs at both ends lead to rows beyond the box, which are
/// copies of its own.
void separateEnds(CutCells& cells, const SpannedAxes& spanned);

}  // namespace cutwater
