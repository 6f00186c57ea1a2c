#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// The tiles of a box and of the cells around it, and what they are cut by.
struct CutParts {
  const CutBlocks& tiles;
  /// One for each tile that may be cut, with polygons and moments as the options want them; null
  /// for the others.
  std::span<const std::unique_ptr<const TileCut>> cuts;
  /// Whether a tile is body that is not cut.
  FunctionRef<bool(std::size_t tile)> isBody;
  const std::vector<std::string>& patchNames;
  const CutSurface* surface = nullptr;  ///< of a mesh
};

/// The cells of a box; `grid` is in the coordinates of the world.
[[nodiscard]] CutCells assembledCells(CellPlanes grid, const CutParts& parts,
                                      const CutOptions& options);

}  // namespace cutwater
