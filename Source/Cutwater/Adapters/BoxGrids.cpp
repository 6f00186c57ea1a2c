#include <Cutwater/Adapters/BoxGrids.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cutwater {

namespace {

constexpr double kSame = 1e-9;  // of a box: coordinates may be rounded differently

/// The planes of a level across an axis. There may be gaps, in which all boxes are of others.
struct Planes {
  std::vector<double> at;
  std::vector<std::int32_t> grid;  // of the cells above each: a few side by side without gaps
};

/// Those of the boxes of these numbers.
Planes planesAcross(int axis, std::span<const Box<double>> boxes,
                    std::span<const std::size_t> numbers) {
  constexpr std::int32_t kMostInGrid = 8;
  std::vector<std::array<double, 2>> stretches;
  stretches.reserve(numbers.size());
  for (const auto n : numbers) stretches.push_back({boxes[n].lower[axis], boxes[n].upper[axis]});
  std::ranges::sort(stretches);
  Planes planes{{stretches.front()[0]}, {}};
  std::int32_t grid = 0;
  std::int32_t inGrid = 0;
  for (const auto& [lower, upper] : stretches) {
    const double same = kSame * (upper - lower);
    if (upper <= planes.at.back() + same) continue;  // that one again
    const bool isGap = lower > planes.at.back() + same;
    if (isGap) {
      planes.grid.push_back(++grid);
      planes.at.push_back(lower);
    }
    if (isGap || inGrid == kMostInGrid) ++grid, inGrid = 0;
    ++inGrid;
    planes.grid.push_back(grid);
    planes.at.push_back(upper);
  }
  return planes;
}

/// The number of the cell above which plane along each axis.
std::array<std::size_t, 3> cellOf(const Box<double>& box, const std::array<Planes, 3>& planes) {
  std::array<std::size_t, 3> cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const auto& at = planes[a].at;
    const double lower = box.lower[axis];
    const double upper = box.upper[axis];
    const double same = 2 * kSame * (upper - lower);
    const auto above = std::ranges::upper_bound(at, lower + same);
    const bool isBetween = above != at.begin() && above != at.end() &&
                           std::abs(*(above - 1) - lower) <= same &&
                           std::abs(*above - upper) <= same;
    require(isBetween, "gridsOf: boxes of a level must lie between planes that all of them share",
            Named{"lower", lower}, Named{"upper", upper});
    cell[a] = static_cast<std::size_t>(above - at.begin()) - 1;
  }
  return cell;
}

Index3 asIndex3(const std::array<std::size_t, 3>& at) {
  const auto number = [&](std::size_t a) { return static_cast<std::int32_t>(at[a]); };
  return {number(0), number(1), number(2)};
}

/// Appends the grids of the boxes of these numbers, which are of one level.
void addGrids(std::span<const Box<double>> boxes, std::span<const std::size_t> numbers,
              BoxGrids& to) {
  const std::array planes{planesAcross(0, boxes, numbers), planesAcross(1, boxes, numbers),
                          planesAcross(2, boxes, numbers)};
  std::map<std::array<std::int32_t, 3>, std::size_t> known;
  for (const auto n : numbers) {
    const auto cell = cellOf(boxes[n], planes);
    std::array<std::int32_t, 3> grid{};
    for (std::size_t a = 0; a < 3; ++a) grid[a] = planes[a].grid[cell[a]];
    const auto [place, isNew] = known.try_emplace(grid, to.grids.size());
    to.places[n] = {place->second, asIndex3(cell)};
    if (!isNew) continue;
    std::array<std::vector<double>, 3> between;
    std::array<std::size_t, 3> first{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& gridOf = planes[a].grid;
      const auto [begin, end] = std::equal_range(gridOf.begin(), gridOf.end(), grid[a]);
      first[a] = static_cast<std::size_t>(begin - gridOf.begin());
      const auto at = planes[a].at.begin() + (begin - gridOf.begin());
      between[a] = {at, at + (end - begin) + 1};
    }
    to.grids.push_back(cellsBetween(between, asIndex3(first)));
  }
}

}  // namespace

BoxGrids gridsOf(std::span<const Box<double>> boxes, std::span<const int> levels) {
  require(boxes.size() == levels.size(), "gridsOf: need a level for each box",
          Named{"boxes", boxes.size()}, Named{"levels", levels.size()});
  std::map<int, std::vector<std::size_t>> byLevel;
  for (std::size_t n = 0; n < boxes.size(); ++n) {
    require(!boxes[n].empty(), "gridsOf: a box is empty", Named{"box", n});
    byLevel[levels[n]].push_back(n);
  }
  BoxGrids result;
  result.places.resize(boxes.size());
  for (const auto& [level, numbers] : byLevel) addGrids(boxes, numbers, result);
  return result;
}

std::array<std::vector<double>, 3> planesOf(const HostDomain& domain) {
  std::array<std::vector<double>, 3> planes;
  for (int axis = 0; axis < domain.dimensions(); ++axis) {
    for (auto n = along(domain.cells.lo, axis); n <= along(domain.cells.hi, axis) + 1; ++n) {
      planes[asIndex(axis)].push_back(domain.origin[axis] + n * domain.width[axis]);
    }
  }
  if (domain.isPlane) planes[2] = {0, 1};
  return planes;
}

}  // namespace cutwater
