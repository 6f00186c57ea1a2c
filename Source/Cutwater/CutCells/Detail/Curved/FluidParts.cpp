#include <Cutwater/CutCells/Detail/Curved/FluidParts.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace cutwater {

namespace {

/// The point of a span nearest to another point, a little inside of its ends.
Vec3<double> nearestPoint(const FluidSpan& span, const Vec3<double>& to) {
  constexpr double kInside = 0.02;  // of the span
  const int axis = span.line.axis;
  const double margin = kInside * span.line.length();
  return span.line.at(std::clamp(to[axis], span.line.start[axis] + margin, span.line.end - margin));
}

double squaredDistance(const FluidSpan& span, const Vec3<double>& to) {
  return lengthSquared(nearestPoint(span, to) - to);
}

/// Between the nearest points of two boxes.
double squaredDistance(const Box<double>& a, const Box<double>& b) {
  Vec3<double> apart;
  for (int axis = 0; axis < 3; ++axis) {
    apart[axis] = std::max({0.0, a.lower[axis] - b.upper[axis], b.lower[axis] - a.upper[axis]});
  }
  return lengthSquared(apart);
}

/// Whether two places are next to each other in a sweep.
bool areNeighbours(const LinePlace& a, const LinePlace& b) {
  const auto areNext = [](std::uint32_t i, std::uint32_t j) { return i <= j + 1 && j <= i + 1; };
  if (a.sweep != b.sweep || !areNext(a.sliceStretch, b.sliceStretch)) return false;
  return a.sliceStretch != b.sliceStretch || areNext(a.rowStretch, b.rowStretch);
}

}  // namespace

FluidParts::FluidParts(const FluidField& field, const Box<double>& box, const RulePoints& points)
    : field_(&field), box_(box), partOfBlock_(points.blockCount(), kNone) {
  for (const auto& span : points.spans) partOfBlock_[span.block] = 0;
  if (std::ranges::count(partOfBlock_, 0U) <= 1) return;
  spans_ = points.spans;
  surfaces_ = field.surfacesNear(box);
  connect(blocksIn(points));
}

/// Blocks with some of their spans, and the sides of surfaces on which they are.
std::vector<FluidParts::Block> FluidParts::blocksIn(const RulePoints& points) const {
  constexpr std::size_t kMost = 9;
  constexpr std::size_t kMostSides = 64;
  std::vector<Block> blocks(partOfBlock_.size());
  for (std::uint32_t i = 0; i < blocks.size(); ++i) {
    blocks[i].number = i;
    blocks[i].place = points.placeOf(i);
  }
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
    if (seen[span.block]++ % step != 0) continue;
    block.samples.push_back(span);
    block.bounds.extend(span.line.start).extend(span.line.at(span.line.end));
  }
  std::erase_if(blocks, [](const Block& block) { return block.count == 0; });
  for (auto& block : blocks) {
    for (std::size_t i = 0; i < std::min(kMostSides, surfaces_.size()); ++i) {
      const bool isAbove = surfaces_[i]->value(block.longest.middle()) > 0;
      block.sides = block.sides << 1U | (isAbove ? 1U : 0U);
    }
  }
  return blocks;
}

/// First blocks on the same side of all surfaces, which mostly are connected; then those of what
/// are different parts by then, neighbours in a sweep first.
void FluidParts::connect(std::span<const Block> blocks) {
  detail::DisjointSets sets(partOfBlock_.size());
  connectAlike(blocks, sets);
  connectParts(blocks, sets);
  std::vector<std::uint32_t> partOfRoot(partOfBlock_.size(), kNone);
  count_ = 0;
  for (const auto& block : blocks) {
    auto& part = partOfRoot[sets.find(block.number)];
    if (part == kNone) part = static_cast<std::uint32_t>(count_++);
    partOfBlock_[block.number] = part;
  }
}

/// Each block with the nearest of those before it that are on the same sides.
void FluidParts::connectAlike(std::span<const Block> blocks, detail::DisjointSets& sets) const {
  constexpr std::size_t kMost = 2;
  std::unordered_map<std::uint64_t, std::vector<const Block*>> before;
  NearestPairs pairs(kMost);
  for (const auto& block : blocks) {
    auto& alike = before[block.sides];
    for (const auto* other : alike) {
      const auto apart = block.longest.middle() - other->longest.middle();
      pairs.add({false, lengthSquared(apart)}, {other, &block});
    }
    tryAll(pairs, sets);
    alike.push_back(&block);
  }
}

/// Each two parts between the blocks that are nearest to each other.
void FluidParts::connectParts(std::span<const Block> blocks, detail::DisjointSets& sets) const {
  constexpr std::size_t kMost = 12;
  std::map<std::uint32_t, std::vector<const Block*>> parts;
  for (const auto& block : blocks) parts[sets.find(block.number)].push_back(&block);
  NearestPairs pairs(kMost);
  for (auto one = parts.begin(); one != parts.end(); ++one) {
    for (auto other = std::next(one); other != parts.end(); ++other) {
      if (sets.find(one->first) == sets.find(other->first)) continue;
      for (const auto* a : one->second) {
        for (const auto* b : other->second) {
          const bool isFar = !areNeighbours(a->place, b->place);
          if (!pairs.mayTake({isFar, squaredDistance(a->bounds, b->bounds)})) continue;
          pairs.add({isFar, nearestSpans(*a, *b).distance}, {a, b});
        }
      }
      tryAll(pairs, sets);
    }
  }
}

/// The nearest first, until they are one part.
void FluidParts::tryAll(NearestPairs& pairs, detail::DisjointSets& sets) const {
  for (const auto& [order, pair] : pairs.sorted()) {
    const auto [a, b] = pair;
    if (sets.find(a->number) != sets.find(b->number) && areConnected(*a, *b)) {
      sets.unite(a->number, b->number);
    }
  }
  pairs.clear();
}

/// The spans of two blocks that are nearest to each other, of the samples.
FluidParts::NearestSpans FluidParts::nearestSpans(const Block& one, const Block& other) {
  NearestSpans nearest;
  for (const auto& a : one.samples) {
    for (const auto& b : other.samples) {
      const double distance = squaredDistance(a, nearestPoint(b, a.middle()));
      if (distance < nearest.distance) nearest = {distance, &a, &b};
    }
  }
  return nearest;
}

/// Whether the way along the axes in this order meets no wall.
bool FluidParts::isClear(const Vec3<double>& from, const Vec3<double>& to,
                         std::span<const int> order, LineCrossings& crossings) const {
  std::vector<AxisLine> lines;
  auto at = from;
  for (const int axis : order) {
    lines.push_back({at, std::max(at[axis], to[axis]), axis});
    lines.back().start[axis] = std::min(at[axis], to[axis]);
    at[axis] = to[axis];
  }
  if (field_->knowsSurfaces()) {
    crossings.find(lines, surfaces_);
  } else {
    crossings.find(lines);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!crossings.startsInFluid(i) || !crossings.of(i).empty()) return false;
  }
  return true;
}

/// In all orders of the axes along which the points differ, one after the other.
bool FluidParts::isAnyClear(const Vec3<double>& from, const Vec3<double>& to) const {
  std::array<int, 3> order{};
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (from[axis] != to[axis]) order[count++] = axis;
  }
  const auto axes = std::span(order).first(count);
  LineCrossings crossings(*field_);
  do {
    if (isClear(from, to, axes, crossings)) return true;
  } while (std::next_permutation(axes.begin(), axes.end()));
  return false;
}

/// By paths between their nearest spans: where these are beside each other, if they are; else
/// between their nearest points.
bool FluidParts::areConnected(const Block& one, const Block& other) const {
  constexpr std::array kShares{0.5, 0.1, 0.9};
  const auto nearest = nearestSpans(one, other);
  const auto& a = *nearest.a;
  const auto& b = *nearest.b;
  const int axis = a.line.axis;
  const double low = std::max(a.line.start[axis], b.line.start[axis]);
  const double high = std::min(a.line.end, b.line.end);
  if (b.line.axis == axis && low < high) {
    return std::ranges::any_of(kShares, [&](double share) {
      const double at = low + share * (high - low);
      return isAnyClear(a.line.at(at), b.line.at(at));
    });
  }
  const auto from = nearestPoint(a, b.middle());
  return isAnyClear(from, nearestPoint(b, from));
}

std::uint32_t FluidParts::of(std::uint32_t block, const Vec3<double>& point) {
  if (count_ <= 1) return 0;
  if (block == kNone) return at(point);
  auto& part = partOfBlock_[block];
  if (part == kNone) part = at(point);
  return part;
}

void FluidParts::moveTo(int axis, double plane, const FluidField& field) {
  field_ = &field;
  box_.lower[axis] = box_.upper[axis] = plane;
  surfaces_ = field.surfacesNear(box_);
  for (auto& span : spans_) span.line.start[axis] = plane;
}

std::uint32_t FluidParts::at(const Vec3<double>& point) const {
  if (count_ <= 1) return 0;
  constexpr std::size_t kMostTries = 12;
  NearestFew<double, const FluidSpan*> nearest(kMostTries);
  for (const auto& span : spans_) nearest.add(squaredDistance(span, point), &span);
  const auto found = nearest.sorted();
  const auto reached = std::ranges::find_if(
      found, [&](const auto& near) { return isAnyClear(point, nearestPoint(*near.item, point)); });
  return partOfBlock_[(reached == found.end() ? found.front() : *reached).item->block];
}

}  // namespace cutwater
