#pragma once

#include <Cutwater/Core/Detail/MixedBits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cutwater::detail {

/// A cycle of distinct corners, starting at the least one and running towards the lesser of its two
/// neighbours: the same for every rotation and for both orientations. `Id`: indices, or handles of
/// a mesh.
template <typename Id>
class CanonicalCycle {
 public:
  explicit CanonicalCycle(std::span<const Id> corners)
      : corners_(corners),
        first_(static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin())) {
    forward_ = at(1) < at(size() - 1);
  }

  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  [[nodiscard]] bool isForward() const { return forward_; }
  /// Corner i of the cycle.
  [[nodiscard]] Id operator[](std::size_t i) const {
    return forward_ ? at(i) : at((size() - i) % size());
  }
  [[nodiscard]] std::uint64_t hash() const {
    std::uint64_t h = size();
    for (std::size_t i = 0; i < size(); ++i) {
      h = mixed(h + kGoldenIncrement + static_cast<std::uint32_t>((*this)[i]));
    }
    return h;
  }
  [[nodiscard]] bool operator==(const CanonicalCycle& other) const {
    if (size() != other.size()) return false;
    for (std::size_t i = 0; i < size(); ++i) {
      if ((*this)[i] != other[i]) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] Id at(std::size_t i) const { return corners_[(first_ + i) % size()]; }

  std::span<const Id> corners_;
  std::size_t first_;
  bool forward_ = true;
};

}  // namespace cutwater::detail
