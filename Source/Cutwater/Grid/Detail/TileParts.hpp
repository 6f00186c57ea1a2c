#pragma once

#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Grid/Detail/GridTiles.hpp>

#include <algorithm>
#include <span>

namespace cutwater::detail {

/// A part of a tile: 2^bits indices with consecutive numbers, as far as they are in the grid patch.
struct TilePart {
  /// Parts of this size are not divided: to settle even smaller ones would cost more than it saves.
  static constexpr int kLeafBits = 6;
  /// Larger parts are divided by this many halvings at a time.
  static constexpr int kDivisionBits = 3;
  static constexpr std::size_t kMost = std::size_t{1} << (TileOrder::kMostBits - kLeafBits);

  OffsetBox indices;
  std::uint32_t number = 0;  ///< of its first index, in the tile's order
  bool isSettled = false;    ///< whether nothing is left to do for it
};

/// The indices of a tile from `number` on, 2^bits of them, as far as they are within the grid
/// patch; of size 0 if none are.
[[nodiscard]] OffsetBox indicesOf(const TileOrder& order, const OffsetBox& tile,
                                  std::uint32_t number, int bits);

/// Divides a tile into ever smaller parts. Calls settle(parts, bits) for all parts of one size,
/// 2^bits, which sets `isSettled` of those that it could deal with as a whole, and rest(part, bits)
/// for what is left of the smallest size. `Part` is derived from TilePart; parts of a part begin as
/// copies of it.
template <typename Part, typename Settle, typename Rest>
void divideTile(const TileOrder& order, const OffsetBox& tile, Settle&& settle, Rest&& rest) {
  std::array<Scratch<Part, TilePart::kMost>, 2> parts;
  parts[0][0] = Part{};
  parts[0][0].indices = tile;
  std::size_t count = 1;
  int bits = order.bits();
  for (std::size_t from = 0; count > 0; from = 1 - from) {
    const auto all = parts[from].first(count);
    settle(all, bits);
    const int smaller = std::max(bits - TilePart::kDivisionBits, TilePart::kLeafBits);
    count = 0;
    for (const auto& part : all) {
      if (part.isSettled) continue;
      if (bits <= TilePart::kLeafBits) {
        rest(part, bits);
        continue;
      }
      const auto end = part.number + (1U << bits);
      for (auto number = part.number; number < end; number += 1U << smaller) {
        const auto indices = indicesOf(order, tile, number, smaller);
        if (indices.size == Offset{}) continue;
        auto& next = parts[1 - from][count++];
        next = part;
        next.indices = indices;
        next.number = number;
      }
    }
    bits = smaller;
  }
}

/// Calls visit(offset in the tile) for the indices of a part of 2^bits, in the tile's order.
template <typename Visit>
void forIndices(const TileOrder& order, const OffsetBox& tile, const TilePart& part, int bits,
                Visit&& visit) {
  const bool isWhole = part.indices.size == order.shape(bits);
  for (auto number = part.number; number < part.number + (1U << bits); ++number) {
    const auto offset = order.offset(number);
    const auto& size = tile.size;
    if (isWhole || (offset[0] < size[0] && offset[1] < size[1] && offset[2] < size[2])) {
      visit(offset);
    }
  }
}

}  // namespace cutwater::detail
