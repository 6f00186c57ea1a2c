#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Surface/Detail/PairSearch.hpp>

#include <algorithm>
#include <bit>

namespace cutwater {

namespace {

/// A leaf with more leaves around it is crowded. On a smooth surface there are about 16.
constexpr std::size_t kMostAround = 48;
/// Crowds up to this size are not split.
constexpr std::size_t kSmallCrowd = 16;
/// Crowds are split beforehand into at most about this many tasks, of at least this many triangles.
constexpr std::size_t kMostCrowds = 96;
constexpr std::size_t kLeastInCrowd = 256;

/// The boxes of a leaf's triangles; those that do not count are empty.
std::array<Box<double>, LeafBoxes::kWidth> boxesOf(const PairTest& pairs,
                                                   std::span<const std::uint32_t> slots) {
  std::array<Box<double>, LeafBoxes::kWidth> boxes;
  for (std::size_t k = 0; k < slots.size() && slots[k] != kNone; ++k) {
    if (pairs.hasArea(slots[k])) boxes[k] = pairs.box(slots[k]);
  }
  return boxes;
}

/// Whether no pair of a crowd meets, because all share a vertex at which none does.
bool isFlatStar(const PairTest& pairs, const Crowd& crowd) {
  const auto isEverywhere = [&](std::uint32_t vertex) {
    const auto isAt = [&](std::uint32_t t) {
      return std::ranges::find(pairs.corners(t), vertex) != pairs.corners(t).end();
    };
    return pairs.isFlat(vertex) && std::ranges::all_of(crowd.members, isAt) &&
           std::ranges::all_of(crowd.guests, isAt);
  };
  return std::ranges::any_of(pairs.corners(crowd.members.front()), isEverywhere);
}

bool isDecided(const PairTest& pairs, const Crowd& crowd) {
  return crowd.isDecided() || isFlatStar(pairs, crowd);
}

std::uint32_t lowestOf(const Crowd& crowd) {
  const auto lowestGuest = crowd.guests.empty() ? kNone : crowd.guests.front();
  return std::min(crowd.members.front(), lowestGuest);
}

}  // namespace

PairSearch::PairSearch(const PairTest& pairs, const TriangleTree& tree, int threads)
    : pairs_(pairs), tree_(tree) {
  const std::size_t leaves = tree.slots().size() / TriangleTree::kLeafWidth;
  boxes_.assign(leaves, LeafBoxes({}));
  isChanged_.resize(leaves);
  isCrowded_.resize(leaves);
  surroundings_.resize((leaves + kLeavesPerRange - 1) / kLeavesPerRange);
  const auto forRanges = [&](void (PairSearch::*work)(std::size_t)) {
    parallelFor(ranges(), {.threads = threads, .progress = {}},
                [&](std::size_t range, std::size_t) { (this->*work)(range); });
  };
  forRanges(&PairSearch::fitLeaves);
  childBoxes_ = fittedNodes([](std::uint32_t) { return true; });
  if (!pairs.areAllChanged()) {
    changedBoxes_ = fittedNodes([&](std::uint32_t leaf) { return isChanged_[leaf] != 0; });
  }
  forRanges(&PairSearch::lookAround);
  gatherCrowds();
}

void PairSearch::fitLeaves(std::size_t range) {
  const std::size_t begin = kLeavesPerRange * range;
  const std::size_t end = std::min(begin + kLeavesPerRange, boxes_.size());
  for (auto leaf = static_cast<std::uint32_t>(begin); leaf < end; ++leaf) {
    boxes_[leaf] = LeafBoxes(boxesOf(pairs_, slots(leaf)));
    const bool hasChanged = std::ranges::any_of(
        slots(leaf), [&](std::uint32_t t) { return t != kNone && pairs_.isChanged(t); });
    isChanged_[leaf] = hasChanged ? 1 : 0;
  }
}

template <typename Counts>
std::vector<LeafBoxes> PairSearch::fittedNodes(Counts&& counts) const {
  const auto nodes = tree_.nodes();
  std::vector<LeafBoxes> fitted(nodes.size(), LeafBoxes({}));
  for (std::size_t n = nodes.size(); n-- > 0;) {  // children come after their parents
    SlotBoxes boxes;
    for (auto rest = nodes[n].childMask(); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      auto& box = boxes[static_cast<std::size_t>(lane)];
      if (!nodes[n].isLeaf(lane)) {
        box = fitted[nodes[n].nodeIndex(lane)].all();
      } else if (counts(nodes[n].leafIndex(lane))) {
        box = boxes_[nodes[n].leafIndex(lane)].all();
      }
    }
    fitted[n] = LeafBoxes(boxes);
  }
  return fitted;
}

void PairSearch::lookAround(std::size_t range) {
  auto& [leaves, ends] = surroundings_[range];
  const std::size_t begin = kLeavesPerRange * range;
  const std::size_t end = std::min(begin + kLeavesPerRange, boxes_.size());
  for (auto leaf = static_cast<std::uint32_t>(begin); leaf < end; ++leaf) {
    const std::size_t before = leaves.size();
    if (!addAround(leaf, leaves)) {
      leaves.resize(before);
      isCrowded_[leaf] = 1;
    }
    ends[leaf - begin] = static_cast<std::uint32_t>(leaves.size());
  }
}

bool PairSearch::addAround(std::uint32_t leaf, std::vector<std::uint32_t>& leaves) const {
  const auto& box = boxes_[leaf].all();
  const std::size_t most = leaves.size() + kMostAround;
  if (box.empty()) return true;
  const auto& boxes = isChanged_[leaf] != 0 ? childBoxes_ : changedBoxes_;
  // At every level, at most all children but one wait.
  std::array<std::uint32_t, std::size_t{TriangleTree::kMaxDepth} * TriangleTree::kArity> pending{};
  std::size_t count = 1;
  while (count > 0) {
    const auto n = pending[--count];
    const auto& node = tree_.nodes()[n];
    for (auto rest = boxes[n].meeting(box); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      if (!node.isLeaf(lane)) {
        pending[count++] = node.nodeIndex(lane);
      } else if (const auto other = node.leafIndex(lane); other != leaf) {
        if (leaves.size() == most) return false;
        leaves.push_back(other);
      }
    }
  }
  return true;
}

void PairSearch::gatherCrowds() {
  Crowd all;
  for (std::uint32_t leaf = 0; leaf < boxes_.size(); ++leaf) {
    if (isCrowded_[leaf] == 0) continue;
    for (const auto t : slots(leaf)) {
      if (t != kNone && pairs_.hasArea(t)) all.members.push_back(t);
    }
  }
  std::ranges::sort(all.members);
  crowds_.push_back(std::move(all));
  for (std::size_t i = 0; i < crowds_.size() && crowds_.size() < kMostCrowds;) {
    auto parts = crowds_[i].size() < kLeastInCrowd ? std::nullopt : split(pairs_, crowds_[i]);
    if (!parts) {
      ++i;
      continue;
    }
    crowds_.erase(crowds_.begin() + static_cast<std::ptrdiff_t>(i));
    std::ranges::move(*parts, std::back_inserter(crowds_));
  }
  std::erase_if(crowds_, [&](const Crowd& crowd) { return isDecided(pairs_, crowd); });
}

bool PairSearch::run(std::size_t task, const PairVisitor& visitor) const {
  if (task >= ranges()) return decideCrowd(crowds_[task - ranges()], visitor);
  const auto& [leaves, ends] = surroundings_[task];
  const std::size_t begin = kLeavesPerRange * task;
  const std::size_t end = std::min(begin + kLeavesPerRange, boxes_.size());
  std::size_t next = 0;
  for (auto leaf = static_cast<std::uint32_t>(begin); leaf < end; ++leaf) {
    if (isCrowded_[leaf] != 0) continue;  // nothing is listed around it
    const SlotBoxes boxes = boxesOf(pairs_, slots(leaf));
    if (!decideWithin(leaf, boxes, visitor)) return false;
    for (; next < ends[leaf - begin]; ++next) {
      // Of two leaves, the first looks at the other, unless only one is not crowded.
      const auto other = leaves[next];
      if (other < leaf && isCrowded_[other] == 0) continue;
      if (!decideBetween(leaf, boxes, other, visitor)) return false;
    }
  }
  return true;
}

bool PairSearch::decideWithin(std::uint32_t leaf, const SlotBoxes& boxes,
                              const PairVisitor& visitor) const {
  if (isChanged_[leaf] == 0) return true;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (boxes[k].empty()) continue;
    const std::uint32_t later = ~1U << k;
    const std::uint32_t lanes = boxes_[leaf].meeting(boxes[k]) & later;
    if (!decide(slots(leaf)[k], slots(leaf), lanes, visitor)) return false;
  }
  return true;
}

bool PairSearch::decideBetween(std::uint32_t leaf, const SlotBoxes& boxes, std::uint32_t other,
                               const PairVisitor& visitor) const {
  if (boxes_[other].all().empty()) return true;
  for (auto near = boxes_[leaf].meeting(boxes_[other].all()); near != 0; near &= near - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(near));
    const std::uint32_t lanes = boxes_[other].meeting(boxes[k]);
    if (!decide(slots(leaf)[k], slots(other), lanes, visitor)) return false;
  }
  return true;
}

bool PairSearch::hasChanged(const Crowd& crowd) const {
  const auto isChanged = [&](std::uint32_t t) { return pairs_.isChanged(t); };
  return std::ranges::any_of(crowd.members, isChanged) ||
         std::ranges::any_of(crowd.guests, isChanged);
}

bool PairSearch::decideCrowd(const Crowd& crowd, const PairVisitor& visitor) const {
  std::vector<Crowd> pending{crowd};
  while (!pending.empty()) {
    const Crowd next = std::move(pending.back());
    pending.pop_back();
    if (isDecided(pairs_, next) || !hasChanged(next)) continue;
    if (!visitor.wants(lowestOf(next))) continue;
    auto parts = next.size() <= kSmallCrowd ? std::nullopt : split(pairs_, next);
    if (parts) {
      std::ranges::move(*parts, std::back_inserter(pending));
    } else if (!decideEach(next, visitor)) {
      return false;
    }
  }
  return true;
}

bool PairSearch::decideEach(const Crowd& crowd, const PairVisitor& visitor) const {
  constexpr std::size_t kWidth = LeafBoxes::kWidth;
  std::vector<std::uint32_t> list;
  if (crowd.within) list = crowd.members;
  list.insert(list.end(), crowd.guests.begin(), crowd.guests.end());
  const std::span<const std::uint32_t> others(list);
  std::vector<LeafBoxes> blocks;
  for (std::size_t k = 0; k < others.size(); k += kWidth) {
    blocks.emplace_back(boxesOf(pairs_, others.subspan(k, std::min(kWidth, others.size() - k))));
  }
  const auto lowestGuest = crowd.guests.empty() ? kNone : crowd.guests.front();
  for (std::size_t i = 0; i < crowd.members.size(); ++i) {
    const auto t = crowd.members[i];
    if (!visitor.wants(std::min(t, lowestGuest))) break;
    const auto box = pairs_.box(t);
    const std::size_t begin = crowd.within ? i + 1 : 0;
    for (std::size_t block = begin / kWidth; block < blocks.size(); ++block) {
      auto lanes = blocks[block].meeting(box);
      if (block == begin / kWidth) lanes &= ~0U << begin % kWidth;
      if (!decide(t, others.subspan(block * kWidth), lanes, visitor)) return false;
    }
  }
  return true;
}

bool PairSearch::decide(std::uint32_t t, std::span<const std::uint32_t> others, std::uint32_t lanes,
                        const PairVisitor& visitor) const {
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto other = others[static_cast<std::size_t>(std::countr_zero(lanes))];
    const auto first = std::min(t, other);
    const auto second = std::max(t, other);
    if (!visitor.wants(first) || !pairs_.meet(first, second)) continue;
    if (!visitor.take(first, second)) return false;
  }
  return true;
}

}  // namespace cutwater
