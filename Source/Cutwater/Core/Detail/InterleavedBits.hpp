#pragma once

#include <cstdint>

namespace cutwater::detail {

/// The number of bits that three coordinates may have to be interleaved in one number.
inline constexpr int kMortonBits = 21;

/// The lowest bits of x, kMortonBits of them, each followed by two zeros. (Morton 1966.)
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

}  // namespace cutwater::detail
