#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Tiles/PeriodicPlanes.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// The planes between cells [first, last] and around them, of a grid with these planes.
std::vector<double> planesFrom(const std::vector<double>& planes, std::int64_t first,
                               std::int64_t last, int axis) {
  const auto all = cellsBetween({planes, planes, planes}).planes[0];
  require(first >= 0 && last + 2 <= std::ssize(planes),
          "cut cells: need a box between the planes along axes without a period",
          Named{"axis", axis}, Named{"first", first}, Named{"last", last});
  return {all.begin() + first, all.begin() + last + 4};
}

/// The same, of planes that repeat.
std::vector<double> repeatedFrom(const CutPeriod& period, const std::vector<double>& planes,
                                 std::int64_t first, std::int64_t last, int axis) {
  const auto cells = std::ssize(planes) - 1;
  const double length = period.length[axis];
  const double rounding = 1e-9 * length;
  require(cells >= 2 && std::abs(planes.back() - planes.front() - length) <= rounding,
          "cut cells: need two cells or more that together are as long as the period",
          Named{"axis", axis}, Named{"cells", cells}, Named{"period", length});
  std::vector<double> result;
  for (auto n = first - 1; n <= last + 2; ++n) {
    const auto periods = n / cells - (n % cells < 0 ? 1 : 0);
    const auto within = static_cast<std::size_t>(n - periods * cells);
    result.push_back(period.rounded(planes[within]) + static_cast<double>(periods) * length);
    require(period.has(result.back()), "cut cells: need a box that is less far away",
            Named{"axis", axis}, Named{"plane", result.back()});
  }
  return result;
}

/// Planes across an axis that has a period.
std::vector<CutBlocks::Stretch> stretchesAcross(const CutPeriod& period, const CutFrame& frame,
                                                int axis, std::span<const double> planes) {
  // The lowest plane is a unit below start + length, or more.
  const double widest = (CutPeriod::kReach - 1) * period.length[axis] + period.unit;
  std::vector<CutBlocks::Stretch> result;
  for (std::size_t n = 0; n + 1 < planes.size(); ++n) {
    const double shift = period.shiftTo(axis, planes[n]);
    require(planes[n + 1] - planes[n] <= widest,
            "cut cells: need cells that are no wider than half a period", Named{"axis", axis},
            Named{"plane", planes[n]});
    const auto place = [&](double plane) { return frame.toFrame(axis, plane - shift); };
    if (result.empty() || result.back().shift != shift) {
      result.push_back({static_cast<int>(n), {place(planes[n])}, shift});
    }
    result.back().positions.push_back(place(planes[n + 1]));
  }
  return result;
}

void checkPeriod(const CutPeriod& period, const CellPlanes& grid, int axis) {
  const auto a = asIndex(axis);
  const auto cells = grid.period[a];
  require(cells >= 0 && (cells > 0) == period.isOn(axis),
          "cut cells: need cells of a period along the axes on which the cutter has one, see "
          "cellsOfPeriod()",
          Named{"axis", axis}, Named{"cells", cells});
  if (cells == 0) return;
  const auto& planes = grid.planes[a];
  for (std::size_t n = 0; n < planes.size(); ++n) {
    const auto count = static_cast<std::size_t>(cells);
    const bool isLower = n < count || planes[n] - planes[n - count] == period.length[axis];
    require(period.has(planes[n]) && isLower,
            "cut cells: need planes as cellsOfPeriod() gives them", Named{"axis", axis},
            Named{"plane", planes[n]});
  }
}

}  // namespace

CellPlanes planesOfPeriod(const CutPeriod& period, const std::array<std::vector<double>, 3>& planes,
                          const Index3& first, const IndexBox& box) {
  CellPlanes result{.planes = {}, .first = box.lo};
  const std::array from{std::int64_t{box.lo.i} - first.i, std::int64_t{box.lo.j} - first.j,
                        std::int64_t{box.lo.k} - first.k};
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    const auto last = from[a] + static_cast<std::int64_t>(box.length(axis)) - 1;
    require(planes[a].size() >= 2, "cut cells: need two planes across each axis",
            Named{"axis", axis});
    result.planes[a] = period.isOn(axis) ? repeatedFrom(period, planes[a], from[a], last, axis)
                                         : planesFrom(planes[a], from[a], last, axis);
    if (period.isOn(axis)) {
      result.period[a] = static_cast<std::int32_t>(planes[a].size() - 1);
    }
  }
  return result;
}

template <std::floating_point T>
CellPlanes planesOf(const CutPeriod& period, const GridPatch<T>& gridPatch) {
  auto result = planesOf(gridPatch);
  const std::array first{result.first.i, result.first.j, result.first.k};
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    if (!period.isOn(axis)) continue;
    const auto spacing = double{gridPatch.level.spacing()[axis]};
    constexpr double kMost = 0x1p26;
    const auto cells = std::llround(std::min(period.length[axis] / spacing, kMost));
    std::vector<double> planes;
    for (std::int32_t n = 0; n <= cells; ++n) {
      Index3 index;
      along(index, axis) = n;
      planes.push_back(double{gridPatch.level.cell(index).lower[axis]});
    }
    const auto last = first[a] + static_cast<std::int64_t>(gridPatch.indices.length(axis)) - 1;
    result.planes[a] = repeatedFrom(period, planes, first[a], last, axis);
    result.period[a] = static_cast<std::int32_t>(cells);
  }
  return result;
}

CutBlocks::Stretches stretchesOf(const CellPlanes& grid, const CutPeriod& period,
                                 const CutFrame& frame) {
  CutBlocks::Stretches result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& planes = grid.planes[asIndex(axis)];
    checkPeriod(period, grid, axis);
    auto& along = result[asIndex(axis)];
    if (period.isOn(axis)) {
      along = stretchesAcross(period, frame, axis, planes);
      continue;
    }
    along.emplace_back();
    for (const double plane : planes) along.front().positions.push_back(frame.toFrame(axis, plane));
  }
  return result;
}

template CellPlanes planesOf(const CutPeriod&, const GridPatch<float>&);
template CellPlanes planesOf(const CutPeriod&, const GridPatch<double>&);

}  // namespace cutwater
