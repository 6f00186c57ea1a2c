#pragma once

#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>
#include <Cutwater/CutCells/Detail/Tiles/CutTiles.hpp>

namespace cutwater {

/// A box of up to kTileWidth^3 cells of a level, whose indices are multiples of kTileWidth: where
/// leaves of the level, and finer ones, are to be cut.
struct LeafBlock {
  Index3 first;                 ///< the cell of lowest indices
  std::uint32_t firstLeaf = 0;  ///< leaves within it; then the one behind the last
  std::uint32_t lastLeaf = 0;
  int winding = 0;                       ///< that of the node of lowest indices
  std::vector<std::uint32_t> triangles;  ///< those that meet it, ascending
};

/// The planes of a block, in the frame.
class BlockPlanes {
 public:
  BlockPlanes(const LeafGrid& grid, int level, const Index3& first);
  BlockPlanes(const BlockPlanes&) = delete;
  BlockPlanes& operator=(const BlockPlanes&) = delete;
  ~BlockPlanes() = default;

  [[nodiscard]] GridPlanes view() const;
  [[nodiscard]] Box<double> box() const;

 private:
  std::array<int, 3> counts_{};
  std::array<std::array<double, kTileWidth + 1>, 3> positions_{};
};

/// The blocks of the roots, those without triangles as well.
[[nodiscard]] std::vector<LeafBlock> rootBlocks(const CutSurface& surface, const LeafGrid& grid);

/// The blocks of the next level in a block that have leaves of that level or finer ones.
[[nodiscard]] std::vector<LeafBlock> blocksWithin(const CutSurface& surface, const LeafGrid& grid,
                                                  const LeafBlock& block, int level);

}  // namespace cutwater
