#pragma once

#include <Cutwater/CutCells/Detail/Tiles/CutBlocks.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

#include <memory>
#include <vector>

namespace cutwater {

/// Numbers the cells of a box, the layer around it, and what is just above that. The box's first
/// cell is at {1, 1, 1}.
class GrownBox {
 public:
  explicit GrownBox(const TilePlace& cells) : cells_(cells) {}

  /// Those of the box, along each axis.
  [[nodiscard]] const TilePlace& cells() const { return cells_; }
  [[nodiscard]] std::uint64_t numberOf(const TilePlace& place) const {
    const auto n = [](int i) { return static_cast<std::uint64_t>(i); };
    return (n(place[2]) * (n(cells_[1]) + 3) + n(place[1])) * (n(cells_[0]) + 3) + n(place[0]);
  }
  [[nodiscard]] TilePlace placeOf(std::uint64_t number) const {
    const auto alongX = static_cast<std::uint64_t>(cells_[0]) + 3;
    const auto alongY = static_cast<std::uint64_t>(cells_[1]) + 3;
    return {static_cast<int>(number % alongX), static_cast<int>(number / alongX % alongY),
            static_cast<int>(number / alongX / alongY)};
  }
  /// Whether it is not in the box.
  [[nodiscard]] bool isBeyond(const TilePlace& place) const {
    for (std::size_t a = 0; a < 3; ++a) {
      if (place[a] < 1 || place[a] > cells_[a]) return true;
    }
    return false;
  }

 private:
  TilePlace cells_;
};

/// A place in a tile, counted from where the tile's first cell is counted.
[[nodiscard]] inline TilePlace placeIn(TilePlace first, const TilePlace& within) {
  for (std::size_t a = 0; a < 3; ++a) first[a] += within[a];
  return first;
}

/// One tile's view of an arc.
struct ArcSource {
  /// Added to numbers of arcs of open patches, which one tile sees: that of the cell below the
  /// face, or above it.
  static constexpr std::uint32_t kLeadsUp = 0x40000000;
  static constexpr std::uint32_t kLeadsDown = 0x80000000;

  std::uint64_t face = 0;    ///< three times the number of the cell above, plus the axis
  std::uint32_t number = 0;  ///< among the open parts of the face
  std::uint32_t tile = 0;
  std::uint32_t arc = 0;

  [[nodiscard]] bool isSame(const ArcSource& other) const {
    return face == other.face && number == other.number;
  }
  [[nodiscard]] bool operator<(const ArcSource& other) const {
    if (face != other.face) return face < other.face;
    return number != other.number ? number < other.number : tile < other.tile;
  }
};

/// What all tiles see but points, which count for nothing: in the order of faces, those of an arc
/// that two tiles see one after the other, that of the tile below it first.
[[nodiscard]] std::vector<ArcSource> arcSourcesOf(
    const CutBlocks& tiles, std::span<const std::unique_ptr<const TileCut>> tileCuts,
    const GrownBox& box, int threads);

}  // namespace cutwater
