#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace cutwater {

namespace {

/// Two places in a loop.
using Places = std::pair<std::size_t, std::size_t>;

/// A loop in its plane.
class PlaneLoop {
 public:
  PlaneLoop(const CornerLoop& loop, std::span<const Vec3<double>> points, int axis)
      : loop_(loop), points_(points), axis_(axis) {}

  [[nodiscard]] std::size_t size() const { return loop_.size(); }
  [[nodiscard]] std::vector<Places> repeatedCorners() const {
    std::vector<std::pair<std::uint32_t, std::size_t>> sorted;
    for (std::size_t n = 0; n < size(); ++n) sorted.emplace_back(loop_[n], n);
    std::ranges::sort(sorted);
    std::vector<Places> repeated;
    for (std::size_t n = 1; n < size(); ++n) {
      if (sorted[n].first == sorted[n - 1].first) {
        repeated.emplace_back(sorted[n - 1].second, sorted[n].second);
      }
    }
    return repeated;
  }
  /// The corners from one place up to before another one.
  [[nodiscard]] CornerLoop from(std::size_t first, std::size_t last) const {
    CornerLoop part;
    for (auto n = first; n != last; n = after(n)) part.push_back(loop_[n]);
    return part;
  }
  /// Twice the area of a part of it.
  [[nodiscard]] double area(const CornerLoop& part) const {
    double sum = 0;
    for (std::size_t n = 2; n < part.size(); ++n) {
      const auto& origin = points_[part[0]];
      sum += cross(points_[part[n - 1]] - origin, points_[part[n]] - origin)[axis_];
    }
    return sum;
  }
  /// The shortest line within the loop between a place from `first` on, before `last`, and one of
  /// the others: it touches no other corner and crosses no edge.
  [[nodiscard]] std::optional<Places> shortestCut(const Places& between) const {
    std::optional<Places> best;
    double shortest = std::numeric_limits<double>::infinity();
    for (auto n = between.first + 1; n < between.second; ++n) {
      for (auto m = after(between.second); m != between.first; m = after(m)) {
        const double squared = lengthSquared(at(n) - at(m));
        if (!(squared < shortest) || !isCut(n, m)) continue;
        shortest = squared;
        best = Places(n, m);
      }
    }
    return best;
  }

 private:
  [[nodiscard]] std::size_t after(std::size_t n) const { return n + 1 < size() ? n + 1 : 0; }
  [[nodiscard]] std::size_t before(std::size_t n) const { return n > 0 ? n - 1 : size() - 1; }
  [[nodiscard]] const Vec3<double>& at(std::size_t n) const { return points_[loop_[n]]; }
  /// On which side of the line through the first two the third lies: 1 on the left.
  [[nodiscard]] int turn(std::size_t a, std::size_t b, std::size_t c) const {
    return crossSign(at(a), at(b), at(a), at(c), axis_);
  }
  /// Whether the line to another corner leaves one into the loop.
  [[nodiscard]] bool leavesInto(std::size_t from, std::size_t to) const {
    const auto next = after(from);
    const auto last = before(from);
    const bool isRightOfLast = turn(from, to, last) > 0;
    const bool isLeftOfNext = turn(from, next, to) > 0;
    if (turn(last, from, next) >= 0) return isRightOfLast && isLeftOfNext;
    return !(turn(from, to, last) <= 0 && turn(from, next, to) <= 0);
  }
  [[nodiscard]] bool isCut(std::size_t a, std::size_t b) const {
    if (loop_[a] == loop_[b] || !leavesInto(a, b) || !leavesInto(b, a)) return false;
    for (std::size_t n = 0; n < size(); ++n) {
      const auto next = after(n);
      const auto isEnd = [&](std::size_t m) {
        return loop_[m] == loop_[a] || loop_[m] == loop_[b];
      };
      if (isEnd(n) && isEnd(next)) return false;
      if (!isEnd(n) && turn(a, b, n) == 0 && isBetween(a, b, n)) return false;
      if (isEnd(n) || isEnd(next)) continue;
      if (turn(a, b, n) * turn(a, b, next) < 0 && turn(n, next, a) * turn(n, next, b) < 0) {
        return false;
      }
    }
    return true;
  }
  /// Of three on one line.
  [[nodiscard]] bool isBetween(std::size_t a, std::size_t b, std::size_t c) const {
    return dot(at(a) - at(c), at(b) - at(c)) < 0;
  }

  const CornerLoop& loop_;
  std::span<const Vec3<double>> points_;
  int axis_;
};

/// Two loops, each nearer to one without a corner twice.
std::optional<std::pair<CornerLoop, CornerLoop>> halves(const PlaneLoop& loop) {
  const auto repeated = loop.repeatedCorners();
  for (const auto& [first, second] : repeated) {
    auto one = loop.from(first, second);
    auto other = loop.from(second, first);
    clean(one);
    clean(other);
    if (loop.area(one) >= 0 && loop.area(other) >= 0) return std::pair(one, other);
  }
  for (const auto& places : repeated) {
    const auto cut = loop.shortestCut(places);
    if (!cut) continue;
    auto one = loop.from(cut->first, cut->second);
    auto other = loop.from(cut->second, cut->first);
    one.push_back(other.front());
    other.push_back(one.front());
    return std::pair(one, other);
  }
  return std::nullopt;
}

}  // namespace

bool hasRepeatedCorner(std::span<const std::uint32_t> loop) {
  CornerLoop sorted(loop.begin(), loop.end());
  std::ranges::sort(sorted);
  return std::ranges::adjacent_find(sorted) != sorted.end();
}

void clean(CornerLoop& loop) {
  CornerLoop kept;
  const auto isBack = [&](std::uint32_t corner) {
    return kept.size() > 1 && kept[kept.size() - 2] == corner;
  };
  for (const auto corner : loop) {
    if (!kept.empty() && kept.back() == corner) continue;
    if (isBack(corner)) {
      kept.pop_back();
    } else {
      kept.push_back(corner);
    }
  }
  // The same across the loop's end.
  std::size_t first = 0;
  while (kept.size() - first > 1) {
    if (kept[first] == kept.back()) {
      kept.pop_back();
    } else if (kept.size() - first > 2 && kept[first + 1] == kept.back()) {
      ++first;
      kept.pop_back();
    } else if (kept.size() - first > 2 && kept[kept.size() - 2] == kept[first]) {
      kept.pop_back();
      kept.pop_back();
    } else {
      break;
    }
  }
  if (kept.size() - first < 3) first = kept.size();
  loop.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

bool areInOnePlane(const CornerLoop& a, const CornerLoop& b, std::span<const Vec3<double>> points) {
  for (int axis = 0; axis < 3; ++axis) {
    const double plane = points[a.front()][axis];
    const auto isThere = [&](std::uint32_t corner) { return points[corner][axis] == plane; };
    if (std::ranges::all_of(a, isThere) && std::ranges::all_of(b, isThere)) return true;
  }
  return false;
}

void addSimpleLoops(const CornerLoop& path, std::vector<CornerLoop>& loops) {
  const auto add = [&](CornerLoop loop) {
    clean(loop);
    if (!loop.empty()) loops.push_back(std::move(loop));
  };
  CornerLoop open;
  for (const auto corner : path) {
    const auto before = std::ranges::find(open, corner);
    if (before != open.end()) {
      add({before, open.end()});
      open.erase(before, open.end());
    }
    open.push_back(corner);
  }
  add(std::move(open));
}

void divideIntoLoops(CornerLoop outline, std::span<const Vec3<double>> points, int axis,
                     std::vector<CornerLoop>& loops) {
  std::vector<CornerLoop> pending;
  pending.push_back(std::move(outline));
  while (!pending.empty()) {
    auto loop = std::move(pending.back());
    pending.pop_back();
    clean(loop);
    if (loop.empty()) continue;
    if (auto two = halves(PlaneLoop(loop, points, axis))) {
      pending.push_back(std::move(two->second));
      pending.push_back(std::move(two->first));
    } else {
      loops.push_back(std::move(loop));
    }
  }
}

}  // namespace cutwater
