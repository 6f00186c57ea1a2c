#pragma once

#include <Cutwater/Grid/Detail/PointBatch.hpp>
#include <Cutwater/Sdf/BoxQuery.hpp>

namespace cutwater::detail {

/// Fills tiles of a patch, one at a time; their points are evaluated in batches.
///
/// With a band, a tile is divided into ever smaller blocks as long as the value in a block's middle
/// does not prove that the whole block is beyond the band. Blocks of one size are evaluated
/// together.
template <std::floating_point T>
class TileFill {
 public:
  explicit TileFill(const FillTask<T>& task) : task_(task), batch_(task) {}

  void fill(const GridBlock& tile);
  /// After the last tile.
  void finish() { batch_.flush(); }

 private:
  /// Blocks of this size are not divided: further evaluations would cost more than they save.
  static constexpr int kLeafBits = 6;
  /// Larger blocks are divided by this many halvings at a time.
  static constexpr int kDivisionBits = 3;
  static constexpr std::size_t kMostBlocks = std::size_t{1} << (TileOrder::kMostBits - kLeafBits);

  /// A block of points that are neighbours in the tile's order, and what is known about it.
  struct Block {
    GridBlock indices;
    std::uint32_t number;   // of its first point, in the tile's order
    Box<T> box = {};        // around its positions
    bool isBeyond = false;  // as a whole
    T sign = 1;             // on which side
    Vec3<T> center = {};    // all is beyond within a radius of it;
    T beyondSquared = -1;   // that radius squared, if positive
  };
  using Blocks = Scratch<Block, kMostBlocks>;

  void placePositions();
  [[nodiscard]] Vec3<T> position(const Offset& inTile) const {
    return {positions_[inTile[0]].x, positions_[inTile[1]].y, positions_[inTile[2]].z};
  }
  /// The part of the tile that the 2^bits points from `number` on cover; of size 0 if none.
  [[nodiscard]] GridBlock indicesOf(std::uint32_t number, int bits) const;
  void fillBand();
  /// Writes the blocks of 2^bits points that are beyond the band, adds the points of small ones,
  /// and divides the others into `parts`; returns the number of parts.
  std::size_t settle(std::span<const Block> blocks, int bits, Blocks& parts);
  /// Determines which of the blocks are beyond the limit.
  void judge(std::span<Block> blocks) const;
  /// Draws the conclusion from the value in the middle.
  void conclude(Block& block, const OrientedBox<T>& box, T atCenter) const;
  void addPoints(const Block& block, int bits);

  const FillTask<T>& task_;
  GridBlock tile_;
  std::array<Vec3<T>, TileOrder::kLongest> positions_;  // coordinates of each offset in the tile
  PointBatch<T> batch_;
};

extern template class TileFill<float>;
extern template class TileFill<double>;

}  // namespace cutwater::detail
