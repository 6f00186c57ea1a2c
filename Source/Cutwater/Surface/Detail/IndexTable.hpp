#pragma once

#include <Cutwater/Core/Detail/MixedBits.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <bit>
#include <cstdint>
#include <vector>

namespace cutwater::detail {

/// An open-addressing hash table of indices: finds equal items in an array that the caller keeps.
/// At most 11 bytes per item, and 16 while it grows.
class IndexTable {
 public:
  /// Returns the index of the item that equals item `candidate`; if there is none, keeps
  /// `candidate` and returns it. `hashOf(i)` hashes item i, `equal(i)` compares it with the
  /// candidate.
  template <typename HashOf, typename Equal>
  std::uint32_t findOrInsert(std::uint32_t candidate, HashOf hashOf, Equal equal) {
    if (4 * (size_ + 1) > 3 * slots_.size()) grow(hashOf);
    std::uint32_t& slot = slots_[slotOf(hashOf(candidate), equal)];
    if (slot == kNone) {
      slot = candidate;
      ++size_;
    }
    return slot;
  }

  /// Returns the index of the item with this hash for which `equal` holds, or kNone.
  template <typename Equal>
  [[nodiscard]] std::uint32_t lookUp(std::uint64_t hash, Equal equal) const {
    return slots_.empty() ? kNone : slots_[slotOf(hash, equal)];
  }

 private:
  // A quarter of the slots is free, so the walk ends.
  template <typename Equal>
  [[nodiscard]] std::size_t slotOf(std::uint64_t hash, Equal equal) const {
    std::size_t i = hash & (slots_.size() - 1);
    while (slots_[i] != kNone && !equal(slots_[i])) i = (i + 1) & (slots_.size() - 1);
    return i;
  }

  template <typename HashOf>
  void grow(HashOf hashOf) {
    std::vector<std::uint32_t> old(slots_.empty() ? 64 : 2 * slots_.size(), kNone);
    old.swap(slots_);
    for (const std::uint32_t item : old) {
      if (item == kNone) continue;
      slots_[slotOf(hashOf(item), [](std::uint32_t) { return false; })] = item;
    }
  }

  std::vector<std::uint32_t> slots_;  // their number is a power of two
  std::size_t size_ = 0;
};

/// A hash of a point, the same for equal ones; -0 equals 0.
inline std::uint64_t hashOf(const Vec3<double>& p) {
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double positiveZero = p[axis] + 0.0;
    hash = mixed(hash * kGoldenIncrement + std::bit_cast<std::uint64_t>(positiveZero));
  }
  return hash;
}

}  // namespace cutwater::detail
