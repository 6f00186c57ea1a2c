#pragma once

#include <Cutwater/Core/IndexBox.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace cutwater::detail {

/// An index relative to the lowest one of a grid patch.
using Offset = std::array<std::uint32_t, 3>;

/// The indices from `first` on, `size` of them along each axis.
struct OffsetBox {
  Offset first{};
  Offset size{};
};

/// A grid patch divided into tiles. A tile is a box of neighbouring indices that one thread works
/// on at a time. All tiles of a grid patch have one shape, except that those at its upper ends are
/// cut off there; they are numbered, x fastest.
class GridTiles {
 public:
  GridTiles(const IndexBox& indices, const Offset& shape);

  [[nodiscard]] std::size_t count() const { return counts_[0] * counts_[1] * counts_[2]; }
  /// The number of tiles in a row along x.
  [[nodiscard]] std::size_t alongX() const { return counts_[0]; }
  [[nodiscard]] OffsetBox tile(std::size_t number) const;

 private:
  Offset shape_;
  std::array<std::size_t, 3> lengths_{};  // of the grid patch
  std::array<std::size_t, 3> counts_{};   // of tiles
};

/// Numbers the points of a tile so that neighbours have similar numbers: each run of 2^n points
/// that begins at a multiple of 2^n is a box, about as long in space on each axis, however the
/// spacings differ. (A Z-order of the axes' bits; Morton 1966.)
class TileOrder {
 public:
  static constexpr int kMostBits = 12;
  static constexpr std::uint32_t kLongest = 64;  ///< tile, on any axis

  /// For tiles of up to 2^bits points, no longer than `lengths` requires.
  TileOrder(const std::array<double, 3>& spacing, const std::array<std::size_t, 3>& lengths,
            int bits);

  /// log2 of the number of points in a tile.
  [[nodiscard]] int bits() const { return bits_; }
  /// Extents of a run of 2^bits points.
  [[nodiscard]] const Offset& shape(int bits) const {
    return shapes_[static_cast<std::size_t>(bits)];
  }
  /// Offset within the tile of the point with this number.
  [[nodiscard]] Offset offset(std::uint32_t number) const {
    const Offset& low = low_[number % kTable];
    const Offset& high = high_[number / kTable];
    return {low[0] + high[0], low[1] + high[1], low[2] + high[2]};
  }

 private:
  static constexpr std::uint32_t kTable = 64;

  int bits_ = 0;
  std::array<Offset, kMostBits + 1> shapes_{};
  std::array<Offset, kTable> low_{};  // offsets of numbers by their lower and their upper bits
  std::array<Offset, kTable> high_{};
};

}  // namespace cutwater::detail
