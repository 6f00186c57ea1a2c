#pragma once

#include <Cutwater/Bvh/Detail/BinaryBvh.hpp>
#include <Cutwater/Bvh/Detail/SplitItem.hpp>

namespace cutwater::detail {

/// Splits a few items all the way down to leaves, always by the best split into full leaves. The
/// items are sorted along each axis once; splits preserve the order.
class SweepSplits {
 public:
  static constexpr std::size_t kMostItems = 256;

  /// Takes at most kMostItems items.
  SweepSplits(std::span<const SplitItem> items, std::uint32_t leafWidth);

  /// Appends the nodes below `node`, which holds all items, and writes their ids to `order`.
  void run(std::size_t node, std::vector<BinaryNode>& nodes, std::span<std::uint32_t> order);

 private:
  using Place = std::uint16_t;
  struct Split {
    float cost;
    std::size_t axis;
    std::size_t position;
  };

  void sortAlong(std::size_t axis);
  [[nodiscard]] Split bestSplit(std::size_t begin, std::size_t end);
  void tryAxis(std::size_t axis, std::size_t begin, std::size_t end, Split& best);
  void part(const Split& split, std::size_t begin, std::size_t end);

  std::span<const SplitItem> items_;
  std::size_t leafWidth_;
  std::array<std::array<Place, kMostItems>, 3> sorted_;  // by centre along each axis
  std::array<float, kMostItems> rightCost_;              // of the items after this many leaves
  std::array<bool, kMostItems> isLeft_;                  // indexed by place
};

}  // namespace cutwater::detail
