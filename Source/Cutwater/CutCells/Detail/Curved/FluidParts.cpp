#include <Cutwater/CutCells/Detail/Curved/FluidParts.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

namespace cutwater {

FluidParts::FluidParts(const FluidField& field, const BoxView& view,
                       std::span<const FluidSpan> spans)
    : field_(&field), box_(view.box()) {
  constexpr int kMostCells = 8;
  for (int axis = 0; axis < 3; ++axis) isFlat_[static_cast<std::size_t>(axis)] = !view.isFree(axis);
  connectCorners(view);
  for (int cells = 2; cells <= kMostCells && count_ > 1; cells *= 2) connect(cells);
  // A wall that is a graph over a side has all of its fluid on one side.
  bool isGraph = false;
  for (int axis = 0; axis < 3; ++axis) {
    isGraph = isGraph || (view.isFree(axis) && view.isMonotone(axis));
  }
  if (count_ > 1 || !isGraph) addUnseen(spans);
}

/// A part that no point of the grid is connected with may be so through a gap that none of them
/// lies in: others are looked for from some of its spans, the first few, the eighth, the 16th and
/// so on.
void FluidParts::addUnseen(std::span<const FluidSpan> spans) {
  constexpr std::size_t kFew = 6;
  const auto seen = static_cast<std::uint32_t>(count_);
  std::vector<std::size_t> found(count_);  // spans of each part
  for (const auto& span : spans) {
    const auto middle = span.middle();
    const double value = field_->value(middle);
    const auto part = partSeenFrom(middle, value).value_or(static_cast<std::uint32_t>(count_));
    if (part < seen) continue;
    if (part == count_) {
      points_.push_back(middle);
      values_.push_back(value);
      partOf_.push_back(part);
      ++count_;
      found.push_back(0);
    }
    if (++found[part] > kFew && !std::has_single_bit(found[part])) continue;
    if (count_ == 1) continue;
    if (const auto other = partReachedFrom(middle, part, found[part] == 1)) {
      const auto [low, high] = std::minmax(part, *other);
      std::ranges::replace(partOf_, high, low);
      for (auto& of : partOf_) of -= of > high ? 1 : 0;
      found[low] += found[high];
      found.erase(found.begin() + high);
      --count_;
    }
  }
}

/// Another part, seen from somewhere on the lines through a point of one, as far as they are in the
/// fluid; if there is none, it may be from the lines through places on these.
std::optional<std::uint32_t> FluidParts::partReachedFrom(const Vec3<double>& point,
                                                         std::uint32_t part, bool mayTurn) const {
  constexpr int kPlaces = 16;
  constexpr int kTurns = 8;
  const auto known = [&](const Vec3<double>& place,
                         bool forCertain) -> std::optional<std::uint32_t> {
    const auto nearest = nearestTo(place, part);
    if (nearest == points_.size()) return {};
    const double value = field_->value(place);
    const bool isSeen =
        forCertain ? isCertain(place, value, nearest) : isClear(place, value, nearest);
    return isSeen ? std::optional(partOf_[nearest]) : std::nullopt;
  };
  const auto found =
      alongLines(point, kPlaces, [&](const Vec3<double>& place) { return known(place, false); });
  if (found || !mayTurn) return found;
  return alongLines(point, kTurns, [&](const Vec3<double>& turn) {
    return alongLines(turn, kTurns, [&](const Vec3<double>& place) { return known(place, true); });
  });
}

/// What is found first at places on the lines through a point, as far as they are in the fluid.
std::optional<std::uint32_t> FluidParts::alongLines(
    const Vec3<double>& point, int places,
    FunctionRef<std::optional<std::uint32_t>(const Vec3<double>& place)> find) const {
  std::optional<std::uint32_t> found;
  LineCrossings crossings(*field_);
  for (int axis = 0; axis < 3 && !found; ++axis) {
    if (isFlat_[static_cast<std::size_t>(axis)]) continue;
    AxisLine line{point, box_.upper[axis], axis};
    line.start[axis] = box_.lower[axis];
    crossings.find({&line, 1});
    const auto visit = [&](double from, double to, bool, bool) {
      if (!(from <= point[axis] && point[axis] <= to)) return;
      for (int i = 0; i < places && !found; ++i) {
        found = find(line.at(from + (i + 0.5) / places * (to - from)));
      }
    };
    forFluidStretches(line, crossings.startsInFluid(0), crossings.of(0), visit);
  }
  return found;
}

/// The nearest point that is not of a part; their number, if there is none.
std::size_t FluidParts::nearestTo(const Vec3<double>& point, std::uint32_t except) const {
  auto nearest = points_.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double distance = lengthSquared(points_[i] - point);
    if (distance < least && partOf_[i] != except) least = distance, nearest = i;
  }
  return nearest;
}

void FluidParts::connectCorners(const BoxView& view) {
  const auto& samples = view.samples();
  detail::DisjointSets sets(samples.values.size());
  for (std::size_t i = 0; i < samples.edges.size(); ++i) {
    const auto from = static_cast<std::uint32_t>(samples.corners[i]);
    const auto to = from + (1U << static_cast<unsigned>(samples.edges[i]->line.axis));
    const bool isOpen = samples.edges[i]->startsInFluid && samples.edges[i]->crossings.empty();
    if (isOpen) sets.unite(from, to);
  }
  std::vector<Vec3<double>> points;
  std::vector<double> values;
  for (int i = 0; i < 8; ++i) {
    points.push_back(box_.corner(i));
    // Those of a rectangle are there twice.
    const bool isCopy = view.flatAxis() >= 0 && (i >> std::max(0, view.flatAxis()) & 1) != 0;
    values.push_back(isCopy ? 0 : samples.values[static_cast<std::size_t>(i)]);
  }
  number(points, values, sets);
}

/// Numbers the parts among points in the fluid, in the order of these.
void FluidParts::number(std::span<const Vec3<double>> points, std::span<const double> values,
                        detail::DisjointSets& sets) {
  points_.clear();
  values_.clear();
  partOf_.clear();
  std::vector<std::uint32_t> partOfRoot(points.size());
  count_ = 0;
  for (std::uint32_t n = 0; n < points.size(); ++n) {
    if (!(values[n] > 0)) continue;
    if (sets.isRoot(n)) partOfRoot[n] = static_cast<std::uint32_t>(count_++);
    points_.push_back(points[n]);
    values_.push_back(values[n]);
    partOf_.push_back(partOfRoot[sets.find(n)]);
  }
}

Vec3<double> FluidParts::pointOf(const std::array<int, 3>& place, int cells) const {
  Vec3<double> point;
  for (int axis = 0; axis < 3; ++axis) {
    const int i = place[static_cast<std::size_t>(axis)];
    const double share = static_cast<double>(i) / cells;
    point[axis] = i == cells ? box_.upper[axis]
                             : box_.lower[axis] + share * (box_.upper[axis] - box_.lower[axis]);
  }
  return point;
}

void FluidParts::connect(int cells) {
  std::array<int, 3> counts{};
  for (std::size_t a = 0; a < 3; ++a) counts[a] = isFlat_[a] ? 1 : cells + 1;
  const auto indexOf = [&](const std::array<int, 3>& p) {
    const int index = (p[2] * counts[1] + p[1]) * counts[0] + p[0];
    return static_cast<std::size_t>(index);
  };
  std::vector<Vec3<double>> points;
  std::vector<std::array<int, 3>> places;
  for (int k = 0; k < counts[2]; ++k) {
    for (int j = 0; j < counts[1]; ++j) {
      for (int i = 0; i < counts[0]; ++i) {
        places.push_back({i, j, k});
        points.push_back(pointOf(places.back(), cells));
      }
    }
  }
  std::vector<double> values(points.size());
  field_->values(points, values);
  // Where the values leave room for no wall, none is looked for.
  const double known = field_->steepness(box_);
  const double steepness = known > 0 ? known : std::numeric_limits<double>::infinity();
  detail::DisjointSets sets(points.size());
  std::vector<AxisLine> lines;
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (std::size_t n = 0; n < points.size(); ++n) {
    for (std::size_t a = 0; a < 3; ++a) {
      auto next = places[n];
      if (++next[a] >= counts[a]) continue;
      const auto other = indexOf(next);
      if (!(values[n] > 0 && values[other] > 0)) continue;
      const int axis = static_cast<int>(a);
      if (values[n] + values[other] > steepness * (points[other][axis] - points[n][axis])) {
        sets.unite(static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(other));
        continue;
      }
      lines.push_back({points[n], points[other][axis], axis});
      ends.push_back({static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(other)});
    }
  }
  LineCrossings crossings(*field_);
  crossings.find(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (crossings.of(i).empty()) sets.unite(ends[i][0], ends[i][1]);
  }
  number(points, values, sets);
}

bool FluidParts::isCertain(const Vec3<double>& from, double atFrom, std::size_t to) const {
  const double steepness = field_->steepness(box_);
  return steepness > 0 && atFrom + values_[to] > steepness * length(points_[to] - from);
}

bool FluidParts::isClear(const Vec3<double>& from, double atFrom, std::size_t to) const {
  if (isCertain(from, atFrom, to)) return true;
  const auto way = points_[to] - from;
  constexpr int kSamples = 16;
  for (int i = 1; i < kSamples; ++i) {
    if (!(field_->value(from + (static_cast<double>(i) / kSamples) * way) > 0)) return false;
  }
  return true;
}

std::optional<std::uint32_t> FluidParts::partSeenFrom(const Vec3<double>& point,
                                                      double value) const {
  if (points_.empty()) return {};
  const auto nearest = nearestTo(point, kNone);
  if (isClear(point, value, nearest)) return partOf_[nearest];
  const auto distance = [&](std::size_t i) { return lengthSquared(points_[i] - point); };
  std::vector<std::size_t> order(points_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, distance);
  for (const auto i : order) {
    if (isClear(point, value, i)) return partOf_[i];
  }
  return {};
}

std::uint32_t FluidParts::at(const Vec3<double>& point) const {
  if (count_ <= 1) return 0;
  return partSeenFrom(point, field_->value(point)).value_or(0);
}

}  // namespace cutwater
