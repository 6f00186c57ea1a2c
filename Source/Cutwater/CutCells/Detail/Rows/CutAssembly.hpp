#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

#include <memory>

namespace cutwater {

/// The cells of a box, from the tiles of that box and the cells around it.
///
/// `grid` is in the coordinates of the world. `tileCuts` has one for each tile with triangles, else
/// null, and polygons and moments as the options want them.
[[nodiscard]] CutCells assembledCells(CellPlanes grid, const CutSurface& surface,
                                      const CutBlocks& tiles,
                                      std::span<const std::unique_ptr<const TileCut>> tileCuts,
                                      const CutOptions& options);

}  // namespace cutwater
