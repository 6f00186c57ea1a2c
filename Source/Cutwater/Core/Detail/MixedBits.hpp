#pragma once

#include <cstdint>

namespace cutwater::detail {

/// 2^64 by the golden ratio, odd: the increment of SplitMix64.
inline constexpr std::uint64_t kGoldenIncrement = 0x9e3779b97f4a7c15;

/// Mixes 64 bits so that every bit of the result depends on each of them, one to one: for hashes,
/// and for random numbers that follow from a place. The finaliser of SplitMix64 (Steele, Lea and
/// Flood 2014, "Fast splittable pseudorandom number generators").
constexpr std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31U);
}

}  // namespace cutwater::detail
