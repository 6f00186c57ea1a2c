#include <Cutwater/CutCells/Detail/Faces/MergedPoints.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

/// Places are wider than two points that are one may be apart.
constexpr double kWidth = 4 * MergedPoints::kSame;

}  // namespace

MergedPoints::Place MergedPoints::placeOf(const Vec3<double>& point) {
  Place place{};
  for (int axis = 0; axis < 3; ++axis) {
    place[static_cast<std::size_t>(axis)] =
        static_cast<std::int64_t>(std::floor(point[axis] / kWidth));
  }
  return place;
}

void MergedPoints::keep(std::span<const Vec3<double>> points) {
  for (const auto& p : points) {
    const auto& there = places_[placeOf(p)];
    const bool isKnown =
        std::ranges::any_of(there, [&](std::uint32_t number) { return points_[number] == p; });
    if (!isKnown) add(p);
  }
}

void MergedPoints::add(const Vec3<double>& point) {
  places_[placeOf(point)].push_back(static_cast<std::uint32_t>(points_.size()));
  points_.push_back(point);
  isSorted_ = false;
}

Vec3<double> MergedPoints::merged(const Vec3<double>& point) {
  const Vec3<double> reach{kSame, kSame, kSame};
  const auto low = placeOf(point - reach);
  const auto high = placeOf(point + reach);
  auto first = static_cast<std::uint32_t>(points_.size());
  for (auto i = low[0]; i <= high[0]; ++i) {
    for (auto j = low[1]; j <= high[1]; ++j) {
      for (auto k = low[2]; k <= high[2]; ++k) {
        const auto near = places_.find({i, j, k});
        if (near == places_.end()) continue;
        for (const auto number : near->second) {
          if (length(points_[number] - point) <= kSame) first = std::min(first, number);
        }
      }
    }
  }
  if (first < points_.size()) return points_[first];
  add(point);
  return point;
}

std::vector<Vec3<double>> MergedPoints::mergedPolygon(std::span<const Vec3<double>> polygon) {
  std::vector<Vec3<double>> result;
  for (const auto& p : polygon) {
    const auto q = merged(p);
    if (result.empty() || result.back() != q) result.push_back(q);
  }
  while (result.size() > 1 && result.back() == result.front()) result.pop_back();
  if (result.size() < 3) result.clear();
  return result;
}

void MergedPoints::sort() {
  if (std::exchange(isSorted_, true)) return;
  for (auto& list : sorted_) list = points_;
  for (int axis = 0; axis < 3; ++axis) {
    std::ranges::stable_sort(sorted_[static_cast<std::size_t>(axis)], {},
                             [axis](const Vec3<double>& p) { return p[axis]; });
  }
}

std::vector<Vec3<double>> MergedPoints::throughPoints(std::span<const Vec3<double>> polygon) {
  sort();
  std::vector<Vec3<double>> result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    result.push_back(polygon[k]);
    addBetween(polygon[k], polygon[(k + 1) % polygon.size()], result);
  }
  return result;
}

/// Appends the points between two, in order.
void MergedPoints::addBetween(const Vec3<double>& from, const Vec3<double>& to,
                              std::vector<Vec3<double>>& out) const {
  const auto way = to - from;
  const double size = length(way);
  if (!(size > 2 * kSame)) return;
  const int axis = nearestAxis(way);
  const auto& points = sorted_[static_cast<std::size_t>(axis)];
  const auto key = [axis](const Vec3<double>& p) { return p[axis]; };
  auto p = std::ranges::lower_bound(points, std::min(from[axis], to[axis]), {}, key);
  const double last = std::max(from[axis], to[axis]);
  std::vector<std::pair<double, Vec3<double>>> found;
  for (; p != points.end() && (*p)[axis] <= last; ++p) {
    const double along = dot(*p - from, way) / size;
    if (along <= kSame || along >= size - kSame || *p == from || *p == to) continue;
    if (length(cross(*p - from, way)) <= kSame * size) found.emplace_back(along, *p);
  }
  std::ranges::sort(found, {}, [](const auto& f) {
    return std::tuple(f.first, f.second.x, f.second.y, f.second.z);
  });
  for (const auto& [along, point] : found) out.push_back(point);
}

}  // namespace cutwater
