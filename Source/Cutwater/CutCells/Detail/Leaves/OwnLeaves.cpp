#include <Cutwater/CutCells/Detail/Leaves/OwnLeaves.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

void noteArcs(bool withPolygons, LeafTile& tile) {
  for (std::uint32_t arc = 0; arc < tile.cut.content.arcs.size(); ++arc) {
    const auto& it = tile.cut.content.arcs[arc];
    if (it.isOpenPatch()) {
      tile.openArcs.emplace_back(it.face, arc);
      continue;
    }
    if (!it.isNothing) tile.arcs.emplace_back(it.face, arc);
    const bool isOutlined = withPolygons && !tile.cut.polygons.arcs.of(arc).empty();
    if (it.isNothing && isOutlined) tile.points.emplace_back(it.face, arc);
  }
  std::ranges::sort(tile.arcs);
  std::ranges::sort(tile.points);
  std::ranges::sort(tile.openArcs);
}

}  // namespace

OwnLeaves::OwnLeaves(const LeafGrid& grid, const LeafBlock& block, int level)
    : level_(level),
      first_(block.first),
      planes_(grid, level, block.first),
      numbers_(planes_.view().sizes()) {
  leafOf_.assign(numbers_.cellCount(), LeafGrid::kNoLeaf);
  for (auto leaf = block.firstLeaf; leaf < block.lastLeaf; ++leaf) {
    const auto& [index, itsLevel, kind] = grid.leaves()[leaf];
    if (itsLevel != level) continue;
    const auto cell =
        numbers_.cell({index.i - block.first.i, index.j - block.first.j, index.k - block.first.k});
    wanted_[cell] = true;
    leafOf_[cell] = leaf;
  }
}

void OwnLeaves::classify(FunctionRef<bool(std::uint32_t cell)> isBody,
                         std::span<FluidClass> classes) const {
  for (std::uint32_t cell = 0; cell < numbers_.cellCount(); ++cell) {
    if (!wanted_[cell]) continue;
    classes[leafOf_[cell]] = isBody(cell) ? FluidClass::Body : FluidClass::Fluid;
  }
}

LeafTile OwnLeaves::tileOf(TileCut cut, bool withPolygons, std::span<FluidClass> classes) const {
  classify([&](std::uint32_t cell) { return cut.isBody[cell]; }, classes);
  LeafTile tile{.level = level_,
                .first = first_,
                .cut = std::move(cut),
                .leaves = {},
                .arcs = {},
                .points = {},
                .openArcs = {},
                .rims = {}};
  for (std::uint32_t row = 0; row < tile.cut.cells.size(); ++row) {
    tile.leaves.push_back(leafOf(tile.cut.cells[row]));
    if (tile.cut.isTouched[row] == 0) classes[tile.leaves.back()] = FluidClass::Cut;
  }
  noteArcs(withPolygons, tile);
  return tile;
}

}  // namespace cutwater
