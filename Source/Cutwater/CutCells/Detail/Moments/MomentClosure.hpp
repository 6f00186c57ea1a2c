#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>

namespace cutwater {

/// How far the moments of pieces are from the identities of the divergence theorem, and from the
/// volumes and areas of their rows: see CutCellsReport::worstMoments. 0 where there are none.
[[nodiscard]] double worstMoments(const CutCells& cells);
[[nodiscard]] double worstMoments(const CutLeaves& leaves);

}  // namespace cutwater
