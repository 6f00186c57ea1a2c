#pragma once

#include <Cutwater/Grid/Detail/FillTask.hpp>

namespace cutwater::detail {

/// The order in which fill() visits a patch: tile by tile, where a tile is a block of indices about
/// as long in space on each axis. Points in small blocks are evaluated together, because the value
/// at one tells much about the next.
template <std::floating_point T>
class BlockFill {
 public:
  /// Values beyond the limit become +-limit; it may be infinite. The references must outlive this.
  BlockFill(const SignedDistanceFunction<T>& solid, const GridPatch<T>& patch,
            const FillTargets<T>& targets, T limit);

  [[nodiscard]] std::size_t tileCount() const { return tiles_.count(); }
  /// The least number of tiles to fill in one go, so that batches are full.
  [[nodiscard]] std::size_t grain() const;
  /// Fills the tiles numbered [begin, end); threads may fill different tiles at the same time.
  void fillTiles(std::size_t begin, std::size_t end) const;

 private:
  FillTask<T> task_;
  PatchBlocks tiles_;
};

extern template class BlockFill<float>;
extern template class BlockFill<double>;

}  // namespace cutwater::detail
