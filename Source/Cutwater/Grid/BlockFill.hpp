#pragma once

#include <Cutwater/Grid/FillTask.hpp>

namespace cutwater::detail {

/// How fill() goes through a patch: in tiles, blocks of indices about as long in space on each
/// axis. Points in small blocks are evaluated together, because the answer of one tells much about
/// the next.
template <std::floating_point T>
class BlockFill {
 public:
  /// Values beyond the limit become +-limit; it may be infinite. The references must outlive this.
  BlockFill(const SignedDistanceFunction<T>& solid, const Patch<T>& patch,
            const FillTargets<T>& targets, T limit);

  [[nodiscard]] std::size_t tileCount() const { return tiles_.count(); }
  /// So many tiles at least should be filled in one go: enough for full batches.
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
