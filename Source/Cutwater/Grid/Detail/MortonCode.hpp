#pragma once

#include <Cutwater/Core/Detail/InterleavedBits.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cutwater::detail {

/// A cell of an octree's level as one number that interleaves the bits of its coordinates, x
/// lowest. The codes of a cell's eight children are 8 code ... 8 code + 7. (Morton 1966.)
using MortonCode = std::uint64_t;

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
