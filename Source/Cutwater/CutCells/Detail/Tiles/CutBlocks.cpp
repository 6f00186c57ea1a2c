#include <Cutwater/CutCells/Detail/Tiles/CutBlocks.hpp>

#include <algorithm>

namespace cutwater {

CutBlocks::CutBlocks(Stretches stretches, const CutPeriod& period)
    : stretches_(std::move(stretches)) {
  addBlocks(period, {}, nullptr);
}

CutBlocks::CutBlocks(const CutSurface& surface, Stretches stretches)
    : stretches_(std::move(stretches)) {
  addBlocks(surface.period(), surface.frame(), &surface);
}

void CutBlocks::addBlocks(const CutPeriod& period, const CutFrame& frame,
                          const CutSurface* surface) {
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
        auto& block = blocks_.emplace_back(planes, surface);
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

}  // namespace cutwater
