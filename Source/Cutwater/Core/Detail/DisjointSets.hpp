#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace cutwater::detail {

/// Union-find with path halving (Tarjan 1975); the least member represents its set.
class DisjointSets {
 public:
  DisjointSets() = default;
  explicit DisjointSets(std::size_t count) { reset(count); }

  /// Makes each of so many members a set of its own.
  void reset(std::size_t count) {
    parent_.resize(count);
    count_ = count;
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    count_ -= a != b ? 1 : 0;
    parent_[std::max(a, b)] = std::min(a, b);
  }
  /// The number of sets.
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Valid once everything has been united: every set has exactly one root.
  [[nodiscard]] bool isRoot(std::uint32_t a) const { return parent_[a] == a; }
  /// The member that represents the set of `a`.
  std::uint32_t find(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::size_t count_ = 0;
};

}  // namespace cutwater::detail
