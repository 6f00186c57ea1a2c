#pragma once

#include <Cutwater/CutCells/Detail/Faces/SheetTree.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// Sheets that only divide: across baffles that are nearly parallel, at edges that they share. The
/// planes of these may cross anywhere near the edge, and leave a thin leaf on both sides of it.
[[nodiscard]] std::vector<Sheet> dividersOf(std::span<const Sheet> sheets);

}  // namespace cutwater
