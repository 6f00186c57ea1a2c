#pragma once

#include <Cutwater/CutCells/Detail/Leaves/LeafTile.hpp>

namespace cutwater {

/// A leaf that the surface meets or touches: its row in a tile.
struct LeafSource {
  std::uint32_t leaf = 0;
  std::uint32_t tile = 0;
  std::uint32_t row = 0;
};

/// Those of all tiles, in the order of leaves.
class LeafSources {
 public:
  /// Views the tiles.
  LeafSources(std::span<const LeafTile> tiles, std::size_t leafCount);

  [[nodiscard]] std::span<const LeafSource> all() const { return sources_; }
  /// The source of a leaf; kNone if the surface does not meet it.
  [[nodiscard]] std::uint32_t of(std::uint32_t leaf) const { return ofLeaf_[leaf]; }
  [[nodiscard]] const LeafSource& source(std::uint32_t number) const { return sources_[number]; }
  [[nodiscard]] const LeafTile& tileOf(std::uint32_t source) const {
    return tiles_[sources_[source].tile];
  }
  /// Whether the surface merely touches it.
  [[nodiscard]] bool isTouched(std::uint32_t source) const {
    return tileOf(source).cut.isTouched[sources_[source].row] != 0;
  }
  /// A face of the leaf, in its tile.
  [[nodiscard]] std::uint32_t faceOf(std::uint32_t source, int axis, bool isHigh) const {
    return tileOf(source).faceOf(sources_[source].row, axis, isHigh);
  }

 private:
  std::span<const LeafTile> tiles_;
  std::vector<LeafSource> sources_;
  std::vector<std::uint32_t> ofLeaf_;
};

}  // namespace cutwater
