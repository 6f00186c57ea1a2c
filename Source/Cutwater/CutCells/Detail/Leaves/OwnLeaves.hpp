#pragma once

#include <Cutwater/CutCells/Detail/Leaves/LeafTile.hpp>

namespace cutwater {

/// The leaves of a block's own level, as cells of a tile.
class OwnLeaves {
 public:
  OwnLeaves(const LeafGrid& grid, const LeafBlock& block, int level);

  [[nodiscard]] GridPlanes planes() const { return planes_.view(); }
  [[nodiscard]] const TileNumbers& numbers() const { return numbers_; }
  [[nodiscard]] const CellMask& wanted() const { return wanted_; }
  [[nodiscard]] std::uint32_t leafOf(std::uint32_t cell) const { return leafOf_[cell]; }

  /// Sets their classes, `isBody(cell)` where the surface does not meet the leaf.
  void classify(FunctionRef<bool(std::uint32_t cell)> isBody, std::span<FluidClass> classes) const;
  /// With their arcs, but without rims, once they are cut. Sets their classes.
  [[nodiscard]] LeafTile tileOf(TileCut cut, bool withPolygons,
                                std::span<FluidClass> classes) const;

 private:
  int level_;
  Index3 first_;
  BlockPlanes planes_;
  TileNumbers numbers_;
  CellMask wanted_;
  std::vector<std::uint32_t> leafOf_;  // by cell
};

}  // namespace cutwater
