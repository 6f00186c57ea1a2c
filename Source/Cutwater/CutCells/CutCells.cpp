#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutRows.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace cutwater {

namespace {

std::array<std::int32_t, 3> components(const Index3& index) {
  return {index.i, index.j, index.k};
}

/// Which of the planes across an axis is below the cell.
std::size_t planeBelow(const CellPlanes& grid, const Index3& cell, std::size_t axis) {
  return static_cast<std::size_t>(1 + std::int64_t{components(cell)[axis]} -
                                  components(grid.first)[axis]);
}

/// Of a cell of the box, or around it.
double widthOf(const CellPlanes& grid, const Index3& cell, std::size_t axis) {
  const auto n = planeBelow(grid, cell, axis);
  return grid.planes[axis][n + 1] - grid.planes[axis][n];
}

}  // namespace

IndexBox CellPlanes::indices() const {
  std::array<std::int32_t, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    last[axis] = static_cast<std::int32_t>(components(first)[axis] +
                                           static_cast<std::int64_t>(planes[axis].size()) - 4);
  }
  return {first, {last[0], last[1], last[2]}};
}

CellPlanes cellsBetween(const std::array<std::vector<double>, 3>& planes, const Index3& first) {
  CellPlanes result{.planes = {}, .first = first};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& from = planes[axis];
    require(from.size() >= 2, "cellsBetween: need two planes across each axis",
            Named{"axis", axis});
    auto& all = result.planes[axis];
    all.push_back(from[0] - (from[1] - from[0]));
    all.insert(all.end(), from.begin(), from.end());
    all.push_back(from.back() + (from.back() - from[from.size() - 2]));
  }
  return result;
}

std::uint32_t CutCells::rowOf(const Index3& cell) const {
  const auto key = [](const Index3& index) { return std::tuple(index.k, index.j, index.i); };
  const auto own = std::span(cells.index).first(cellCount);
  const auto found = std::ranges::lower_bound(own, key(cell), {}, key);
  return found != own.end() && *found == cell ? static_cast<std::uint32_t>(found - own.begin())
                                              : kNoRow;
}

Index3 CutCells::Arcs::cellBelow(std::size_t arc) const {
  auto index = cell[arc];
  --(axis[arc] == 0 ? index.i : axis[arc] == 1 ? index.j : index.k);
  return index;
}

std::uint32_t CutCells::OpenArcs::patchOf(std::uint32_t row) const {
  const auto found = std::ranges::lower_bound(arc, row);
  return found != arc.end() && *found == row ? patch[static_cast<std::size_t>(found - arc.begin())]
                                             : kNoRow;
}

void CutCells::Polygons::add(std::span<const Vec3<double>> polygon) {
  points.insert(points.end(), polygon.begin(), polygon.end());
  first.push_back(points.size());
}

FluidClass CutCells::classOf(const Index3& cell) const {
  if (rowOf(cell) != kNoRow) return FluidClass::Cut;
  const auto box = grid.indices();
  const auto number =
      ((planeBelow(grid, cell, 2) - 1) * box.length(1) + planeBelow(grid, cell, 1) - 1) *
          box.length(0) +
      planeBelow(grid, cell, 0) - 1;
  const auto after =
      std::ranges::upper_bound(bodyRuns, number, {}, [](const auto& run) { return run[0]; });
  const bool isBody = after != bodyRuns.begin() && number < (*(after - 1))[1];
  return isBody ? FluidClass::Body : FluidClass::Fluid;
}

bool CutCells::isTouchedOnly(std::uint32_t row) const {
  return isOnlyTouched(*this, row);
}

Box<double> CutCells::boxOf(const Index3& cell) const {
  Box<double> box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto n = planeBelow(grid, cell, static_cast<std::size_t>(axis));
    box.lower[axis] = grid.planes[static_cast<std::size_t>(axis)][n];
    box.upper[axis] = grid.planes[static_cast<std::size_t>(axis)][n + 1];
  }
  return box;
}

double CutCells::cellVolume(const Index3& cell) const {
  double volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) volume *= widthOf(grid, cell, axis);
  return volume;
}

double CutCells::faceArea(const Index3& cell, int axis) const {
  const auto a = static_cast<std::size_t>(axis);
  return widthOf(grid, cell, (a + 1) % 3) * widthOf(grid, cell, (a + 2) % 3);
}

double CutCells::volumeFraction(std::uint32_t piece) const {
  const double share = pieces.volume[piece] / cellVolume(cells.index[pieces.cell[piece]]);
  return std::clamp(share, 0.0, 1.0);
}

double CutCells::aperture(std::uint32_t arc) const {
  return std::clamp(arcs.area[arc] / faceArea(arcs.cell[arc], arcs.axis[arc]), 0.0, 1.0);
}

}  // namespace cutwater
