#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Tiles/CutBlocks.hpp>

#include <algorithm>

namespace cutwater {

CutBlocks::CutBlocks(Stretches stretches) : stretches_(std::move(stretches)) {
  const auto& [x, y, z] = stretches_;
  blocks_.emplace_back(GridPlanes{{x.front().positions, y.front().positions, z.front().positions}});
}

CutBlocks::CutBlocks(const CutSurface& surface, Stretches stretches)
    : stretches_(std::move(stretches)) {
  const auto& period = surface.period();
  const auto& frame = surface.frame();
  const auto& [alongX, alongY, alongZ] = stretches_;
  std::size_t tiles = 0;
  for (const auto& z : alongZ) {
    for (const auto& y : alongY) {
      for (const auto& x : alongX) {
        GridPlanes planes{{x.positions, y.positions, z.positions}};
        for (int axis = 0; axis < 3; ++axis) {
          if (!period.isOn(axis)) continue;
          planes.period[axis] = period.length[axis] * frame.scale;
          planes.seam[axis] = frame.toFrame(axis, period.start[axis] + period.length[axis]);
        }
        auto& block = blocks_.emplace_back(surface, planes);
        block.first = {x.first, y.first, z.first};
        block.shift = {x.shift, y.shift, z.shift};
        block.firstTile = tiles;
        tiles += block.tiles.count();
      }
    }
  }
}

const CutBlocks::Block& CutBlocks::of(std::size_t tile) const {
  if (tile < blocks_.front().tiles.count()) return blocks_.front();
  return *(std::ranges::upper_bound(blocks_, tile, {}, &Block::firstTile) - 1);
}

TilePlace CutBlocks::firstCell(std::size_t tile) const {
  const auto& block = of(tile);
  auto place = block.tiles.firstCell(tile - block.firstTile);
  for (std::size_t a = 0; a < 3; ++a) place[a] += block.first[a];
  return place;
}

CutBlocks::Row CutBlocks::rowFrom(const TilePlace& cell) const {
  std::size_t number = 0;
  for (std::size_t a = 3; a-- > 0;) {
    const auto& stretches = stretches_[a];
    const auto after = std::ranges::upper_bound(stretches, cell[a], {}, &Stretch::first);
    number = number * stretches.size() + static_cast<std::size_t>(after - stretches.begin()) - 1;
  }
  const auto& block = blocks_[number];
  Row row;
  TilePlace tile{};
  for (std::size_t a = 0; a < 3; ++a) {
    const int inBlock = cell[a] - block.first[a];
    tile[a] = inBlock / CutTiles::kWidth;
    row.within[a] = inBlock % CutTiles::kWidth;
  }
  row.tile = block.firstTile + block.tiles.tileAt(tile);
  row.end = block.first[0] + block.planes.cells(0);
  return row;
}

namespace {

/// Planes across an axis that has a period.
std::vector<CutBlocks::Stretch> stretchesAcross(const CutSurface& surface, int axis,
                                                std::span<const double> planes) {
  const auto& period = surface.period();
  // The lowest plane is a unit below start + length, or more.
  const double widest = (CutPeriod::kReach - 1) * period.length[axis] + period.unit;
  std::vector<CutBlocks::Stretch> result;
  for (std::size_t n = 0; n + 1 < planes.size(); ++n) {
    const double shift =
        static_cast<double>(period.periodsTo(axis, planes[n])) * period.length[axis];
    require(planes[n + 1] - planes[n] <= widest,
            "cut cells: need cells that are no wider than half a period", Named{"axis", axis},
            Named{"plane", planes[n]});
    const auto place = [&](double plane) { return surface.frame().toFrame(axis, plane - shift); };
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
          "CellCutter::cellsOfPeriod()",
          Named{"axis", axis}, Named{"cells", cells});
  if (cells == 0) return;
  const auto& planes = grid.planes[a];
  for (std::size_t n = 0; n < planes.size(); ++n) {
    const auto count = static_cast<std::size_t>(cells);
    const bool isLower = n < count || planes[n] - planes[n - count] == period.length[axis];
    require(period.has(planes[n]) && isLower,
            "cut cells: need planes as CellCutter::cellsOfPeriod() gives them", Named{"axis", axis},
            Named{"plane", planes[n]});
  }
}

}  // namespace

CutBlocks::Stretches stretchesOf(const CellPlanes& grid) {
  CutBlocks::Stretches result;
  for (std::size_t a = 0; a < 3; ++a) result[a].push_back({0, grid.planes[a], 0});
  return result;
}

CutBlocks::Stretches stretchesOf(const CutSurface& surface, const CellPlanes& grid) {
  CutBlocks::Stretches result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& planes = grid.planes[asIndex(axis)];
    checkPeriod(surface.period(), grid, axis);
    auto& along = result[asIndex(axis)];
    if (surface.period().isOn(axis)) {
      along = stretchesAcross(surface, axis, planes);
      continue;
    }
    along.emplace_back();
    for (const double plane : planes) {
      along.front().positions.push_back(surface.frame().toFrame(axis, plane));
    }
  }
  return result;
}

}  // namespace cutwater
