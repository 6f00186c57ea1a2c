#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>
#include <Cutwater/CutCells/Detail/Curved/CurvedTile.hpp>
#include <Cutwater/CutCells/Detail/Leaves/CurvedLeaves.hpp>
#include <Cutwater/CutCells/Detail/Leaves/OwnLeaves.hpp>

#include <algorithm>
#include <optional>
#include <tuple>

namespace cutwater {

namespace {

/// The cells of a level in which leaves of that level are cut together.
struct LevelBlock {
  int level = 0;
  Index3 first;

  [[nodiscard]] auto key() const { return std::tuple(level, first.k, first.j, first.i); }
};

std::vector<LevelBlock> blocksOf(const LeafGrid& grid) {
  const auto aligned = [](std::int32_t index) { return index & ~(kTileWidth - 1); };
  std::vector<LevelBlock> blocks;
  for (const auto& [index, level, kind] : grid.leaves()) {
    const LevelBlock block{level, {aligned(index.i), aligned(index.j), aligned(index.k)}};
    if (blocks.empty() || blocks.back().key() != block.key()) blocks.push_back(block);
  }
  std::ranges::sort(blocks, {}, &LevelBlock::key);
  const auto isSame = [](const LevelBlock& a, const LevelBlock& b) { return a.key() == b.key(); };
  blocks.erase(std::unique(blocks.begin(), blocks.end(), isSame), blocks.end());
  return blocks;
}

/// Cuts the leaves of a block; nothing, if none of them may be cut.
std::optional<LeafTile> cutBlock(const FluidField& field, const LeafGrid& grid,
                                 const LevelBlock& at, const SolidCutterOptions& how,
                                 const CutOptions& options, std::span<FluidClass> classes) {
  const auto [firstLeaf, lastLeaf] = grid.within(at.first, at.level, kTileBits);
  const LeafBlock block{
      .first = at.first, .firstLeaf = firstLeaf, .lastLeaf = lastLeaf, .triangles = {}};
  const OwnLeaves own(grid, block, at.level);
  const auto whole = wholeBox(field, boxOf(own.planes()));
  if (whole.isWhole) {
    own.classify([&](std::uint32_t) { return !whole.isFluid; }, classes);
    return {};
  }
  const auto finerFaces = [&](std::uint32_t cell, int axis, int side) {
    std::vector<Box<double>> faces;
    const auto leaf = own.leafOf(cell);
    if (grid.across(leaf, axis, side == 1).first != LeafGrid::Across::Finer) return faces;
    for (const auto finer : grid.finerAcross(leaf, axis, side == 1)) {
      faces.push_back(faceOf(grid.boxInFrame(finer), axis, side == 0));
    }
    return faces;
  };
  std::vector<BehindFiner> behind;
  const int levels = grid.deepest() - at.level;
  const auto plane = [&](int axis, std::int32_t number) {
    return grid.planeInFrame(grid.deepest(), axis, (along(at.first, axis) << levels) + number);
  };
  const auto isDivided = [&](const TilePlace& place, int below) {
    const Index3 cell{(at.first.i << below) + place[0], (at.first.j << below) + place[1],
                      (at.first.k << below) + place[2]};
    const auto leaf = grid.at(cell, at.level + below, block.firstLeaf);
    return leaf != LeafGrid::kNoLeaf && grid.leaves()[leaf].level > at.level + below;
  };
  const LeavesAround around{levels, plane, isDivided};
  const TileLeaves leaves{own.wanted(), finerFaces, around};
  auto tile = own.tileOf(cutTile(field, own.planes(), how, options, leaves, behind),
                         options.polygons, classes);
  if (tile.leaves.empty()) return {};
  for (const auto& [cell, axis, side, finer, part, piece] : behind) {
    auto face = own.numbers().placeOfCell(cell);
    face[asIndex(axis)] += side;
    const auto across = grid.finerAcross(own.leafOf(cell), axis, side == 1);
    tile.rims.behind.push_back({own.numbers().face(axis, face), across[finer], part, piece});
  }
  std::ranges::sort(tile.rims.behind, {}, &LeafRims::PieceBehind::key);
  return tile;
}

}  // namespace

std::vector<LeafTile> cutLeafTiles(const FluidField& field, const LeafGrid& grid,
                                   const SolidCutterOptions& how, const CutOptions& options,
                                   std::span<FluidClass> classes) {
  const auto blocks = blocksOf(grid);
  std::vector<std::optional<LeafTile>> found(blocks.size());
  parallelFor(blocks.size(), {.threads = options.threads, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                for (auto i = begin; i < end; ++i) {
                  found[i] = cutBlock(field, grid, blocks[i], how, options, classes);
                }
              });
  std::vector<LeafTile> tiles;
  for (auto& tile : found) {
    if (tile) tiles.push_back(std::move(*tile));
  }
  return tiles;
}

}  // namespace cutwater
