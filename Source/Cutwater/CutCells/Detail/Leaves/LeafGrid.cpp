#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>
#include <Cutwater/Grid/Detail/MortonCode.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

using detail::mortonCode;
using detail::MortonCode;

/// How many cells of the finest level are in one that is coarser by so many levels.
MortonCode cellsWithin(int levels) {
  return MortonCode{1} << 3 * levels;
}

/// Of the finest level.
template <std::floating_point T>
std::vector<double> planesAcross(const OctreeCells<T>& mesh, int axis) {
  const auto level = mesh.domain().level(mesh.deepest());
  const auto cells = mesh.domain().indices(mesh.deepest()).length(axis);
  std::vector<double> planes;
  planes.reserve(cells + 1);
  for (std::size_t i = 0; i <= cells; ++i) {
    Index3 index;
    along(index, axis) = static_cast<std::int32_t>(i);
    planes.push_back(double{level.cell(index).lower[axis]});
    require(std::isfinite(planes.back()) && (i == 0 || planes.back() > planes[i - 1]),
            "cut cells: need planes that ascend: the leaves are smaller than rounding",
            Named{"plane", planes.back()});
  }
  return planes;
}

}  // namespace

template <std::floating_point T>
LeafGrid::LeafGrid(const OctreeCells<T>& mesh, const CutFrame& frame)
    : deepest_(mesh.deepest()), leaves_(mesh.cells()) {
  if (leaves_.size() >= kNoLeaf) throw Error(ErrorKind::Limit, "cut cells: too many leaves");
  places_.reserve(leaves_.size());
  for (const auto& leaf : leaves_) places_.push_back(detail::placeOf(leaf, deepest_));
  for (int axis = 0; axis < 3; ++axis) {
    roots_[asIndex(axis)] = along(mesh.domain().roots(), axis);
    planes_[asIndex(axis)] = planesAcross(mesh, axis);
    for (const auto plane : planes_[asIndex(axis)]) {
      framed_[asIndex(axis)].push_back(frame.toFrame(axis, plane));
    }
  }
}

Box<double> LeafGrid::boxBetween(const std::array<std::vector<double>, 3>& planes,
                                 std::uint32_t leaf) const {
  const auto& [index, level, kind] = leaves_[leaf];
  Box<double> box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = planes[asIndex(axis)][numberOf(level, along(index, axis))];
    box.upper[axis] = planes[asIndex(axis)][numberOf(level, along(index, axis) + 1)];
  }
  return box;
}

double LeafGrid::faceArea(std::uint32_t leaf, int axis) const {
  const auto size = boxOf(leaf).size();
  return size[(axis + 1) % 3] * size[(axis + 2) % 3];
}

double LeafGrid::volume(std::uint32_t leaf) const {
  const auto size = boxOf(leaf).size();
  return size.x * size.y * size.z;
}

std::pair<std::uint32_t, std::uint32_t> LeafGrid::within(const Index3& first, int level,
                                                         int bits) const {
  const auto place = mortonCode(first) << 3 * (deepest_ - level);
  const auto numberFrom = [&](MortonCode from) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(places_, from) - places_.begin());
  };
  return {numberFrom(place), numberFrom(place + cellsWithin(deepest_ - level + bits))};
}

/// The first leaf behind a place, sought in steps from `near` that double (Bentley and Yao 1976):
/// of the leaves beside one, most are near it in the order of places.
std::size_t LeafGrid::firstAfter(std::uint64_t place, std::size_t near) const {
  const auto count = places_.size();
  std::size_t first = near;  // all before it are not behind the place
  std::size_t last = near;   // from it on all are
  if (places_[near] <= place) {
    for (std::size_t step = 1; last < count && places_[last] <= place; step *= 2) {
      first = last + 1;
      last = std::min(count, last + step);
    }
  } else {
    for (std::size_t step = 1; first > 0 && places_[first - 1] > place; step *= 2) {
      last = first - 1;
      first = last > step ? last - step : 0;
    }
  }
  const auto begin = places_.begin();
  return static_cast<std::size_t>(std::upper_bound(begin + static_cast<std::ptrdiff_t>(first),
                                                   begin + static_cast<std::ptrdiff_t>(last),
                                                   place) -
                                  begin);
}

std::uint32_t LeafGrid::at(const Index3& cell, int level, std::uint32_t near) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (along(cell, axis) < 0 || along(cell, axis) >= cells(level, axis)) return kNoLeaf;
  }
  const auto place = mortonCode(cell) << 3 * (deepest_ - level);
  const auto next = firstAfter(place, near);
  if (next > 0 && place - places_[next - 1] < cellsWithin(deepest_ - leaves_[next - 1].level)) {
    return static_cast<std::uint32_t>(next - 1);
  }
  const bool isWithin =
      next < places_.size() && places_[next] - place < cellsWithin(deepest_ - level);
  return isWithin ? static_cast<std::uint32_t>(next) : kNoLeaf;
}

std::pair<LeafGrid::Across, std::uint32_t> LeafGrid::across(std::uint32_t leaf, int axis,
                                                            bool isHigh) const {
  const int level = leaves_[leaf].level;
  auto cell = leaves_[leaf].index;
  along(cell, axis) += isHigh ? 1 : -1;
  const auto other = at(cell, level, leaf);
  if (other == kNoLeaf) return {Across::Nothing, other};
  const int there = leaves_[other].level;
  return {there == level ? Across::Same : there < level ? Across::Coarser : Across::Finer, other};
}

std::vector<std::uint32_t> LeafGrid::finerAcross(std::uint32_t leaf, int axis, bool isHigh) const {
  auto cell = leaves_[leaf].index;
  along(cell, axis) += isHigh ? 1 : -1;
  std::vector<std::uint32_t> found;
  addTouching(cell, leaves_[leaf].level, axis, !isHigh, found, leaf);
  return found;
}

/// The leaves in a cell that is divided and touch one of its faces.
void LeafGrid::addTouching(const Index3& cell, int level, int axis, bool isHigh,
                           std::vector<std::uint32_t>& found, std::uint32_t near) const {
  if (level >= deepest_) return;
  for (int child = 0; child < 8; ++child) {
    if ((child >> axis & 1) != (isHigh ? 1 : 0)) continue;
    const Index3 index{2 * cell.i + (child & 1), 2 * cell.j + (child >> 1 & 1),
                       2 * cell.k + (child >> 2)};
    const auto other = at(index, level + 1, near);
    if (other == kNoLeaf) continue;
    if (leaves_[other].level > level + 1) {
      addTouching(index, level + 1, axis, isHigh, found, other);
    } else {
      found.push_back(other);
    }
  }
}

template LeafGrid::LeafGrid(const OctreeCells<float>&, const CutFrame&);
template LeafGrid::LeafGrid(const OctreeCells<double>&, const CutFrame&);

}  // namespace cutwater
