#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Curved/FluidParts.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace cutwater {

namespace {

/// The point of a span nearest to another point, a little inside of its ends.
Vec3<double> nearestPoint(const FluidSpan& span, const Vec3<double>& to) {
  constexpr double kInside = 0.02;  // of the span
  const int axis = span.line.axis;
  const double margin = kInside * span.line.length();
  return span.line.at(
      std::clamp(to[axis], span.line.start[axis] + margin, span.line.end - margin));
}

double squaredDistance(const FluidSpan& span, const Vec3<double>& to) {
  return lengthSquared(nearestPoint(span, to) - to);
}

}  // namespace

FluidParts::FluidParts(const FluidField& field, const BoxView& view, const RulePoints& points)
    : field_(&field), partOfBlock_(points.blockCount(), kNone) {
  for (const auto& span : points.spans) partOfBlock_[span.block] = 0;
  const auto used = std::ranges::count(partOfBlock_, 0U);
  // A wall that is a graph over a side has all of its fluid on one side.
  bool isGraph = points.isOneSided;
  for (int axis = 0; axis < 3; ++axis) {
    isGraph = isGraph || (view.isFree(axis) && view.isMonotone(axis));
  }
  if (used <= 1 || isGraph) return;
  spans_ = points.spans;
  connect(blocksIn(view.box()));
}

/// Blocks with some of their spans, and the sides of surfaces on which they are.
std::vector<FluidParts::Block> FluidParts::blocksIn(const Box<double>& box) const {
  constexpr std::size_t kMost = 9;
  constexpr std::size_t kMostSides = 64;
  std::vector<Block> blocks(partOfBlock_.size());
  for (std::uint32_t i = 0; i < blocks.size(); ++i) blocks[i].number = i;
  for (const auto& span : spans_) {
    auto& block = blocks[span.block];
    if (block.count++ == 0 || span.line.length() > block.longest.line.length()) {
      block.longest = span;
    }
  }
  std::vector<std::size_t> seen(blocks.size());
  for (const auto& span : spans_) {
    auto& block = blocks[span.block];
    const auto step = (block.count + kMost - 1) / kMost;
    if (seen[span.block]++ % step == 0) block.samples.push_back(span);
  }
  std::erase_if(blocks, [](const Block& block) { return block.count == 0; });
  if (!field_->knowsSurfaces()) return blocks;
  const auto surfaces = field_->surfacesNear(box);
  for (auto& block : blocks) {
    for (std::size_t i = 0; i < std::min(kMostSides, surfaces.size()); ++i) {
      const bool isAbove = surfaces[i]->value(block.longest.middle()) > 0;
      block.sides = block.sides << 1U | (isAbove ? 1U : 0U);
    }
  }
  return blocks;
}

/// First blocks on the same side of all surfaces, which mostly are connected, then those of what
/// are different parts by then.
void FluidParts::connect(std::span<const Block> blocks) {
  constexpr std::size_t kMostBeside = 2;
  constexpr std::size_t kMostBetween = 6;  // parts
  detail::DisjointSets sets(partOfBlock_.size());
  struct Pair {
    double distance = 0;
    const Block* a = nullptr;
    const Block* b = nullptr;
  };
  std::vector<Pair> pairs;
  const auto addPair = [&](const Block& a, const Block& b) {
    pairs.push_back({lengthSquared(a.longest.middle() - b.longest.middle()), &a, &b});
  };
  const auto tryNearest = [&](std::size_t most) {
    const auto count = std::min(most, pairs.size());
    std::ranges::partial_sort(pairs, pairs.begin() + static_cast<std::ptrdiff_t>(count), {},
                              &Pair::distance);
    for (const auto& [distance, a, b] : std::span(pairs).first(count)) {
      if (sets.find(a->number) == sets.find(b->number)) continue;
      if (areConnected(*a, *b)) sets.unite(a->number, b->number);
    }
    pairs.clear();
  };
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (blocks[i].sides == blocks[j].sides) addPair(blocks[j], blocks[i]);
    }
    tryNearest(kMostBeside);
  }
  std::map<std::array<std::uint32_t, 2>, std::vector<Pair>> between;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto a = sets.find(blocks[j].number);
      const auto b = sets.find(blocks[i].number);
      if (a == b) continue;
      addPair(blocks[j], blocks[i]);
      between[{std::min(a, b), std::max(a, b)}].push_back(pairs.back());
    }
  }
  for (auto& [parts, some] : between) {
    pairs = std::move(some);
    tryNearest(kMostBetween);
  }
  std::vector<std::uint32_t> partOfRoot(partOfBlock_.size(), kNone);
  count_ = 0;
  for (const auto& block : blocks) {
    auto& part = partOfRoot[sets.find(block.number)];
    if (part == kNone) part = static_cast<std::uint32_t>(count_++);
    partOfBlock_[block.number] = part;
  }
}

void FluidParts::Paths::add(const Vec3<double>& from, const Vec3<double>& to,
                            std::span<const int> order) {
  auto at = from;
  for (const int axis : order) {
    if (at[axis] == to[axis]) continue;
    AxisLine line{at, std::max(at[axis], to[axis]), axis};
    line.start[axis] = std::min(at[axis], to[axis]);
    lines.push_back(line);
    at[axis] = to[axis];
  }
  ends.push_back(lines.size());
}

/// In all orders of the axes along which the points differ.
void FluidParts::Paths::addAll(const Vec3<double>& from, const Vec3<double>& to) {
  std::array<int, 3> order{};
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (from[axis] != to[axis]) order[count++] = axis;
  }
  const auto axes = std::span(order).first(count);
  do {
    add(from, to, axes);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

bool FluidParts::isAnyClear(const Paths& paths) const {
  LineCrossings crossings(*field_);
  crossings.find(paths.lines);
  std::size_t first = 0;
  for (const auto end : paths.ends) {
    bool isClear = true;
    for (auto i = first; i < end; ++i) {
      isClear = isClear && crossings.startsInFluid(i) && crossings.of(i).empty();
    }
    if (isClear) return true;
    first = end;
  }
  return false;
}

/// By paths between their nearest spans: where these are beside each other, if they are; else
/// between their nearest points.
bool FluidParts::areConnected(const Block& one, const Block& other) const {
  constexpr std::array kShares{0.5, 0.1, 0.9};
  double least = std::numeric_limits<double>::infinity();
  const FluidSpan* nearest = nullptr;
  const FluidSpan* nearestOther = nullptr;
  for (const auto& a : one.samples) {
    for (const auto& b : other.samples) {
      const double distance = squaredDistance(a, nearestPoint(b, a.middle()));
      if (distance < least) least = distance, nearest = &a, nearestOther = &b;
    }
  }
  const auto& a = *nearest;
  const auto& b = *nearestOther;
  Paths paths;
  const int axis = a.line.axis;
  const double low = std::max(a.line.start[axis], b.line.start[axis]);
  const double high = std::min(a.line.end, b.line.end);
  if (b.line.axis == axis && low < high) {
    for (const double share : kShares) {
      const double at = low + share * (high - low);
      paths.addAll(a.line.at(at), b.line.at(at));
    }
  } else {
    const auto from = nearestPoint(a, b.middle());
    paths.addAll(from, nearestPoint(b, from));
  }
  return isAnyClear(paths);
}

std::uint32_t FluidParts::of(std::uint32_t block, const Vec3<double>& point) const {
  if (count_ <= 1) return 0;
  return block != kNone && partOfBlock_[block] != kNone ? partOfBlock_[block] : at(point);
}

std::uint32_t FluidParts::at(const Vec3<double>& point) const {
  if (count_ <= 1) return 0;
  constexpr std::size_t kMostTries = 12;
  const auto distance = [&](const FluidSpan& span) { return squaredDistance(span, point); };
  std::vector<FluidSpan> nearest(std::min(kMostTries, spans_.size()));
  std::ranges::partial_sort_copy(spans_, nearest, {}, distance, distance);
  for (const auto& span : nearest) {
    Paths paths;
    paths.addAll(point, nearestPoint(span, point));
    if (isAnyClear(paths)) return partOfBlock_[span.block];
  }
  return partOfBlock_[nearest.front().block];
}

}  // namespace cutwater
