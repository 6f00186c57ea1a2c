#include <Cutwater/Bvh/Detail/SweepSplits.hpp>

#include <algorithm>
#include <cassert>

namespace cutwater::detail {

namespace {

/// Maps floats to integers of the same order.
std::uint32_t sortable(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x + 0.0F);  // so that -0 becomes +0
  return (bits >> 31U) != 0 ? ~bits : bits | 0x80000000U;
}

}  // namespace

SweepSplits::SweepSplits(std::span<const SplitItem> items, std::uint32_t leafWidth)
    : items_(items), leafWidth_(leafWidth) {
  assert(items.size() <= kMostItems);
  for (std::size_t axis = 0; axis < 3; ++axis) sortAlong(axis);
}

void SweepSplits::sortAlong(std::size_t axis) {
  std::array<std::uint64_t, kMostItems> keys;
  const auto own = std::span(keys).first(items_.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const float center = items_[i].lower[axis] + items_[i].upper[axis];
    own[i] = std::uint64_t{sortable(center)} << 32U | i;  // ties are ordered by place
  }
  std::ranges::sort(own);
  for (std::size_t i = 0; i < own.size(); ++i) sorted_[axis][i] = static_cast<Place>(own[i]);
}

void SweepSplits::run(std::size_t node, std::vector<BinaryNode>& nodes,
                      std::span<std::uint32_t> order) {
  const std::uint32_t first = nodes[node].begin;
  std::vector<std::size_t> pending{node};
  while (!pending.empty()) {
    const auto index = pending.back();
    pending.pop_back();
    const std::size_t begin = nodes[index].begin - first;
    const std::size_t end = nodes[index].end - first;
    if (end - begin <= leafWidth_) continue;
    const auto split = bestSplit(begin, end);
    part(split, begin, end);
    const auto left = splitNode(nodes, index, static_cast<std::uint32_t>(first + split.position));
    pending.push_back(left + 1);
    pending.push_back(left);
  }
  for (std::size_t i = 0; i < items_.size(); ++i) order[i] = items_[sorted_[0][i]].id;
}

auto SweepSplits::bestSplit(std::size_t begin, std::size_t end) -> Split {
  // Fallback if no cost is a number: split in the middle.
  const auto leaves = (end - begin + leafWidth_ - 1) / leafWidth_;
  Split best{std::numeric_limits<float>::infinity(), 0, begin + leaves / 2 * leafWidth_};
  for (std::size_t axis = 0; axis < 3; ++axis) tryAxis(axis, begin, end, best);
  return best;
}

void SweepSplits::tryAxis(std::size_t axis, std::size_t begin, std::size_t end, Split& best) {
  const auto box = [&](std::size_t i) { return boundsOf(items_[sorted_[axis][i]]); };
  const std::size_t last = (end - begin - 1) / leafWidth_;  // last split position, in leaves
  Bounds4 right;
  auto done = end;
  for (auto leaf = last; leaf > 0; --leaf) {
    while (done > begin + leaf * leafWidth_) right.extend(box(--done));
    rightCost_[leaf] = splitCost(right, end - done, leafWidth_);
  }
  Bounds4 left;
  done = begin;
  for (std::size_t leaf = 1; leaf <= last; ++leaf) {
    while (done < begin + leaf * leafWidth_) left.extend(box(done++));
    const float cost = splitCost(left, done - begin, leafWidth_) + rightCost_[leaf];
    if (cost < best.cost) best = {cost, axis, done};
  }
}

void SweepSplits::part(const Split& split, std::size_t begin, std::size_t end) {
  const auto& chosen = sorted_[split.axis];
  for (auto i = begin; i < end; ++i) isLeft_[chosen[i]] = i < split.position;
  std::array<Place, kMostItems> right;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis == split.axis) continue;
    auto& places = sorted_[axis];
    std::size_t lefts = begin;
    std::size_t rights = 0;
    for (auto i = begin; i < end; ++i) {
      const Place place = places[i];
      const std::size_t goesLeft = isLeft_[place] ? 1 : 0;
      places[lefts] = place;  // overwritten later unless it belongs there
      right[rights] = place;
      lefts += goesLeft;
      rights += 1 - goesLeft;
    }
    std::copy_n(right.begin(), rights, places.begin() + static_cast<std::ptrdiff_t>(lefts));
  }
}

}  // namespace cutwater::detail
