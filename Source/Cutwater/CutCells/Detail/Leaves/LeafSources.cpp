#include <Cutwater/CutCells/Detail/Leaves/LeafSources.hpp>

#include <algorithm>

namespace cutwater {

LeafSources::LeafSources(std::span<const LeafTile> tiles, std::size_t leafCount)
    : tiles_(tiles), ofLeaf_(leafCount, kNone) {
  for (std::uint32_t tile = 0; tile < tiles.size(); ++tile) {
    for (std::uint32_t row = 0; row < tiles[tile].leaves.size(); ++row) {
      sources_.push_back({tiles[tile].leaves[row], tile, row});
    }
  }
  std::ranges::sort(sources_, {}, &LeafSource::leaf);
  for (std::uint32_t i = 0; i < sources_.size(); ++i) ofLeaf_[sources_[i].leaf] = i;
}

}  // namespace cutwater
