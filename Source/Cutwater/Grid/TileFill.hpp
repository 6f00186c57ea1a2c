#pragma once

#include <Cutwater/Grid/PointBatch.hpp>
#include <Cutwater/Sdf/BoxQuery.hpp>

namespace cutwater::detail {

/// Fills tiles of a patch, one at a time; their points are evaluated in batches.
///
/// With a band, a tile is divided into ever smaller blocks as long as the value in a block's middle
/// does not prove that all of it is beyond the band. Blocks of one size are asked about together.
template <std::floating_point T>
class TileFill {
 public:
  explicit TileFill(const FillTask<T>& task) : task_(task), batch_(task) {}

  void fill(const GridBlock& tile);
  /// After the last tile.
  void finish() { batch_.flush(); }

 private:
  /// Smaller blocks are not divided: values in more places would cost more than they save.
  static constexpr int kLeafBits = 6;
  /// Others are, in so many halvings.
  static constexpr int kDivisionBits = 3;
  static constexpr std::size_t kMostBlocks = std::size_t{1} << (TileOrder::kMostBits - kLeafBits);

  /// Points that are neighbours in the tile's order, and what is known of them.
  struct Block {
    GridBlock indices;
    std::uint32_t number;   // of its first point in the tile's order
    Box<T> box = {};        // around its positions
    bool isBeyond = false;  // all of it
    T sign = 1;             // on which side
    Vec3<T> center = {};    // within the radius of it, all is beyond,
    T beyondSquared = -1;   // which is the root of this, if it is positive
  };
  using Blocks = Scratch<Block, kMostBlocks>;

  void placePositions();
  [[nodiscard]] Vec3<T> position(const Offset& inTile) const {
    return {positions_[inTile[0]].x, positions_[inTile[1]].y, positions_[inTile[2]].z};
  }
  /// What the tile has of 2^bits points from `number` on; of size 0 if nothing.
  [[nodiscard]] GridBlock indicesOf(std::uint32_t number, int bits) const;
  void fillBand();
  /// Writes blocks that are beyond, adds the points of those that are small, divides the others
  /// into `parts` of 2^bits points; returns how many.
  std::size_t settle(std::span<const Block> blocks, int bits, Blocks& parts);
  /// Which of the blocks are beyond the limit.
  void judge(std::span<Block> blocks) const;
  /// From the value in the middle.
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
