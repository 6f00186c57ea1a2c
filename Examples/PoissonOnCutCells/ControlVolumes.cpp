#include "ControlVolumes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

using cutwater::CutCells;
using cutwater::FluidClass;
using cutwater::Index3;
using cutwater::Vec3;

namespace {

std::int32_t& along(Index3& index, int axis) {
  return axis == 0 ? index.i : axis == 1 ? index.j : index.k;
}

std::size_t numberOf(const cutwater::IndexBox& box, const Index3& cell) {
  const auto from = [](std::int32_t at, std::int32_t lowest) {
    return static_cast<std::size_t>(at - lowest);
  };
  return (from(cell.k, box.lo.k) * box.length(1) + from(cell.j, box.lo.j)) * box.length(0) +
         from(cell.i, box.lo.i);
}

}  // namespace

ControlVolumes::ControlVolumes(const CutCells& cells)
    : box_(cells.grid.indices()),
      origin_(cells.boxOf(box_.lo).lower),
      width_(cells.boxOf(box_.lo).size().x) {
  addCells(cells);
  addOpenParts(cells);
  renumber(joined(cells));
}

void ControlVolumes::addCells(const CutCells& cells) {
  ofCell_.resize(box_.count());
  for (std::uint32_t piece = 0; piece < cells.pieceCount; ++piece) {
    ofCell_[numberOf(box_, cells.cells.index[cells.pieces.cell[piece]])].push_back(count());
    centroids_.push_back(cells.pieces.centroid[piece]);
    volumes_.push_back(cells.pieces.volume[piece]);
    isCell_.push_back(false);
  }
  forEachIndex(box_, [&](const Index3& cell) {
    if (cells.classOf(cell) != FluidClass::Fluid) return;
    ofCell_[numberOf(box_, cell)].push_back(count());
    centroids_.push_back(cells.boxOf(cell).center());
    volumes_.push_back(cells.cellVolume(cell));
    isCell_.push_back(true);
  });
  walls_.resize(count());
  const auto& parts = cells.wallParts;
  for (std::size_t n = 0; n < parts.piece.size(); ++n) {
    const double area = length(parts.vector[n]);
    if (parts.piece[n] >= cells.pieceCount || area < 1e-14 * width_ * width_) continue;
    walls_[parts.piece[n]].push_back({.patch = parts.patch[n],
                                      .area = area,
                                      .normal = parts.vector[n] / area,
                                      .centroid = parts.centroid[n]});
  }
}

void ControlVolumes::addOpenParts(const CutCells& cells) {
  const auto sideOf = [&](std::uint32_t piece, const Index3& cell) {
    if (piece < cells.pieceCount) return piece;
    if (piece != CutCells::kWholeCell || !box_.contains(cell)) return kNone;
    return ofCell_[numberOf(box_, cell)][0];
  };
  for (std::size_t arc = 0; arc < cells.arcs.area.size(); ++arc) {
    const OpenPart part{.below = sideOf(cells.arcs.below[arc], cells.arcs.cellBelow(arc)),
                        .above = sideOf(cells.arcs.above[arc], cells.arcs.cell[arc]),
                        .area = cells.arcs.area[arc],
                        .centroid = cells.arcs.centroid[arc],
                        .axis = cells.arcs.axis[arc]};
    if (part.area > 0 && (part.below != kNone || part.above != kNone)) openParts_.push_back(part);
  }
  forEachIndex(box_, [&](const Index3& cell) {
    if (cells.classOf(cell) == FluidClass::Fluid) addWholeFaces(cells, cell);
  });
}

/// Between cells that are all fluid, and at the box's sides, there are no arcs.
void ControlVolumes::addWholeFaces(const CutCells& cells, const Index3& cell) {
  const auto own = ofCell_[numberOf(box_, cell)][0];
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool isHigh : {false, true}) {
      auto across = cell;
      along(across, axis) += isHigh ? 1 : -1;
      const bool isIn = box_.contains(across);
      // Faces within the box are added from below.
      if (isIn && (!isHigh || cells.classOf(across) != FluidClass::Fluid)) continue;
      const auto other = isIn ? ofCell_[numberOf(box_, across)][0] : kNone;
      auto centroid = cells.boxOf(cell).center();
      centroid[axis] += isHigh ? width_ / 2 : -width_ / 2;
      openParts_.push_back({.below = isHigh ? own : other,
                            .above = isHigh ? other : own,
                            .area = width_ * width_,
                            .centroid = centroid,
                            .axis = axis});
    }
  }
}

std::vector<std::uint32_t> ControlVolumes::joined(const CutCells& cells) const {
  constexpr double kSmall = 0.25;
  std::vector<std::uint32_t> largest(cells.pieceCount, kNone);
  for (std::uint32_t n = 0; n < openParts_.size(); ++n) {
    const auto& part = openParts_[n];
    if (part.below == kNone || part.above == kNone) continue;
    for (const auto side : {part.below, part.above}) {
      if (side >= cells.pieceCount) continue;
      auto& best = largest[side];
      if (best == kNone || openParts_[best].area < part.area) best = n;
    }
  }
  std::vector<std::uint32_t> parent(count());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto rootOf = [&](std::uint32_t n) {
    while (parent[n] != n) n = parent[n];
    return n;
  };
  for (std::uint32_t piece = 0; piece < cells.pieceCount; ++piece) {
    if (largest[piece] == kNone || cells.volumeFraction(piece) >= kSmall) continue;
    const auto& part = openParts_[largest[piece]];
    parent[rootOf(piece)] = rootOf(part.below == piece ? part.above : part.below);
  }
  for (std::uint32_t n = 0; n < count(); ++n) parent[n] = rootOf(n);
  return parent;
}

void ControlVolumes::renumber(const std::vector<std::uint32_t>& into) {
  std::vector<std::uint32_t> number(into.size(), kNone);
  std::uint32_t next = 0;
  for (std::uint32_t n = 0; n < into.size(); ++n) {
    if (into[n] == n) number[n] = next++;
  }
  const auto of = [&](std::uint32_t n) { return n == kNone ? kNone : number[into[n]]; };
  std::vector<double> volumes(next);
  std::vector<Vec3<double>> centroids(next);
  std::vector<bool> isCell(next, true);
  std::vector<std::vector<WallPart>> walls(next);
  for (std::uint32_t n = 0; n < into.size(); ++n) {
    const auto to = of(n);
    volumes[to] += volumes_[n];
    centroids[to] += centroids_[n] * volumes_[n];
    if (!isCell_[n] || into[n] != n) isCell[to] = false;
    walls[to].insert(walls[to].end(), walls_[n].begin(), walls_[n].end());
  }
  for (std::uint32_t n = 0; n < next; ++n) centroids[n] = centroids[n] / volumes[n];
  volumes_ = std::move(volumes);
  centroids_ = std::move(centroids);
  isCell_ = std::move(isCell);
  walls_ = std::move(walls);
  std::erase_if(openParts_, [&](OpenPart& part) {
    part.below = of(part.below);
    part.above = of(part.above);
    return part.below == part.above;
  });
  openPartsOf_.resize(next);
  for (std::uint32_t n = 0; n < openParts_.size(); ++n) {
    for (const auto side : {openParts_[n].below, openParts_[n].above}) {
      if (side != kNone) openPartsOf_[side].push_back(n);
    }
  }
  for (auto& cell : ofCell_) {
    for (auto& n : cell) n = of(n);
  }
}

std::uint32_t ControlVolumes::at(const Vec3<double>& point) const {
  Index3 cell = box_.lo;
  for (int axis = 0; axis < 3; ++axis) {
    along(cell, axis) +=
        static_cast<std::int32_t>(std::floor((point[axis] - origin_[axis]) / width_));
  }
  if (!box_.contains(cell)) return kNone;
  const auto& volumes = ofCell_[numberOf(box_, cell)];
  const auto nearest = std::ranges::min_element(
      volumes, {}, [&](std::uint32_t n) { return length(centroids_[n] - point); });
  return nearest == volumes.end() ? kNone : *nearest;
}
