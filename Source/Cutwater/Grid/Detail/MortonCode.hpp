#pragma once

#include <Cutwater/Grid/OctreeCells.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cutwater::detail {

/// A cell of an octree's level as one number that interleaves the bits of its coordinates, x
/// lowest. The codes of a cell's eight children are 8 code ... 8 code + 7. (Morton 1966.)
using MortonCode = std::uint64_t;

/// The number of bits that coordinates with a code may have.
inline constexpr int kMortonBits = 21;

/// The lowest bits of x, kMortonBits of them, each followed by two zeros.
constexpr std::uint64_t spread(std::uint64_t x) {
  x &= (std::uint64_t{1} << unsigned{kMortonBits}) - 1;
  x = (x | x << 32U) & 0x001f00000000ffffU;
  x = (x | x << 16U) & 0x001f0000ff0000ffU;
  x = (x | x << 8U) & 0x100f00f00f00f00fU;
  x = (x | x << 4U) & 0x10c30c30c30c30c3U;
  return (x | x << 2U) & 0x1249249249249249U;
}
/// The inverse; other bits are ignored.
constexpr std::uint64_t gathered(std::uint64_t x) {
  x &= 0x1249249249249249U;
  x = (x | x >> 2U) & 0x10c30c30c30c30c3U;
  x = (x | x >> 4U) & 0x100f00f00f00f00fU;
  x = (x | x >> 8U) & 0x001f0000ff0000ffU;
  x = (x | x >> 16U) & 0x001f00000000ffffU;
  return (x | x >> 32U) & 0x1fffffU;
}

/// Sorts the values and removes duplicates.
inline void sortUnique(std::vector<std::uint64_t>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The code of a cell. Coordinates are in [0, 2^kMortonBits).
constexpr MortonCode mortonCode(const Index3& index) {
  return spread(static_cast<std::uint64_t>(index.i)) |
         spread(static_cast<std::uint64_t>(index.j)) << 1U |
         spread(static_cast<std::uint64_t>(index.k)) << 2U;
}
/// The cell with this code.
constexpr Index3 indexOf(MortonCode code) {
  return {static_cast<std::int32_t>(gathered(code)),
          static_cast<std::int32_t>(gathered(code >> 1U)),
          static_cast<std::int32_t>(gathered(code >> 2U))};
}

/// Code of the first cell within this one on a level that is as fine or finer.
constexpr MortonCode placeOf(const OctreeCell& cell, int level) {
  return mortonCode(cell.index) << 3 * (level - cell.level);
}

}  // namespace cutwater::detail
