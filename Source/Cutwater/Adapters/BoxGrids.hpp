#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/IndexBox.hpp>
#include <Cutwater/CutCells/CutCells.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace cutwater {

/// Where a box is among grids.
struct BoxPlace {
  std::size_t grid = 0;
  Index3 cell;
};

/// Grids of which boxes are cells, some of them perhaps cells of no box.
struct BoxGrids {
  std::vector<CellPlanes> grids;
  std::vector<BoxPlace> places;  ///< of each box
};

/// The boxes that are cells of a host's mesh as cells of small grids, for a CellCutter or a
/// SolidCutter: of up to 8 cells along each axis, so that few cells are cut in vain where a level
/// has but some of those between its planes.
///
/// @param boxes  in any order.
/// @param levels  of each box. Boxes of one level must be those between planes that all of them
/// share; where they are rounded differently, by less than 1e-9 of their width, the lowest count.
/// @throws Error(Argument) for other boxes, and unless there are as many levels.
[[nodiscard]] BoxGrids gridsOf(std::span<const Box<double>> boxes, std::span<const int> levels);

}  // namespace cutwater
