#include <Cutwater/CutCells/Detail/Leaves/LeafTile.hpp>
#include <Cutwater/CutCells/Detail/Leaves/NodeWindings.hpp>
#include <Cutwater/CutCells/Detail/Leaves/OwnLeaves.hpp>
#include <Cutwater/CutCells/Detail/Leaves/RimNotes.hpp>

#include <algorithm>
#include <iterator>
#include <optional>

namespace cutwater {

std::uint32_t LeafTile::faceOf(std::uint32_t row, int axis, bool isHigh) const {
  auto place = cut.numbers.placeOfCell(cut.cells[row]);
  place[asIndex(axis)] += isHigh ? 1 : 0;
  return cut.numbers.face(axis, place);
}

namespace {

using FaceArcs = std::span<const std::pair<std::uint32_t, std::uint32_t>>;

FaceArcs ofFace(FaceArcs arcs, std::uint32_t face) {
  const auto key = [](const auto& arc) { return arc.first; };
  return {std::ranges::lower_bound(arcs, face, {}, key),
          std::ranges::upper_bound(arcs, face, {}, key)};
}

}  // namespace

std::span<const std::pair<std::uint32_t, std::uint32_t>> LeafTile::arcsOf(
    std::uint32_t face) const {
  return ofFace(arcs, face);
}

std::span<const std::pair<std::uint32_t, std::uint32_t>> LeafTile::pointsOf(
    std::uint32_t face) const {
  return ofFace(points, face);
}

std::span<const std::pair<std::uint32_t, std::uint32_t>> LeafTile::openArcsOf(
    std::uint32_t face) const {
  return ofFace(openArcs, face);
}

namespace {

/// Cuts the leaves of a block's own level, if the surface may meet any of them.
std::optional<LeafTile> cutLeaves(const CutSurface& surface, const LeafGrid& grid,
                                  const LeafBlock& block, int level, const CutOptions& options,
                                  std::span<FluidClass> classes) {
  const OwnLeaves own(grid, block, level);
  const auto& numbers = own.numbers();
  TileInput input{.planes = own.planes(),
                  .triangles = block.triangles,
                  .winding = block.winding,
                  .wanted = &own.wanted()};
  // Most triangles of a block meet finer leaves alone.
  const auto triangles = trianglesAtCells(surface, input.planes, block.triangles, own.wanted());
  std::vector<std::int32_t> windings;
  if (triangles.size() < block.triangles.size()) {
    windings = nodeWindings(surface, input.planes, block.triangles, block.winding);
    input.triangles = triangles;
    input.windings = windings;
  }
  if (triangles.empty()) {
    const auto isBody = [&](std::uint32_t cell) {
      return windings[numbers.node(numbers.placeOfCell(cell))] > 0;
    };
    own.classify(isBody, classes);
    return {};
  }
  const TileParts parts(surface, input);
  auto tile = own.tileOf(cutTile(parts, options), options.polygons, classes);
  noteRims(grid, parts, surface.meetsItself(), options.polygons, tile);
  tile.cut.content.ofFragments = {};
  tile.cut.content.openArcOf = {};
  return tile;
}

/// Cuts a block's leaves, if the surface may meet them.
std::optional<LeafTile> cutBlock(const CutSurface& surface, const LeafGrid& grid,
                                 const LeafBlock& block, int level, const CutOptions& options,
                                 std::span<FluidClass> classes) {
  const auto leaves = grid.leaves().subspan(block.firstLeaf, block.lastLeaf - block.firstLeaf);
  if (block.triangles.empty()) {
    for (auto leaf = block.firstLeaf; leaf < block.lastLeaf; ++leaf) {
      if (grid.leaves()[leaf].level < level) continue;
      classes[leaf] = block.winding > 0 ? FluidClass::Body : FluidClass::Fluid;
    }
    return {};
  }
  const bool hasOwn =
      std::ranges::any_of(leaves, [&](const OctreeCell& leaf) { return leaf.level == level; });
  if (!hasOwn) return {};
  auto tile = cutLeaves(surface, grid, block, level, options, classes);
  if (tile && tile->leaves.empty()) return {};
  return tile;
}

}  // namespace

std::vector<LeafTile> cutLeafTiles(const CutSurface& surface, const LeafGrid& grid,
                                   const CutOptions& options, std::span<FluidClass> classes) {
  std::vector<LeafTile> tiles;
  auto blocks = rootBlocks(surface, grid);
  for (int level = 0; !blocks.empty(); ++level) {
    const auto isDone = [&](double share) {
      options.progress((level + share) / (grid.deepest() + 1));
    };
    std::vector<std::optional<LeafTile>> found(blocks.size());
    std::vector<std::vector<LeafBlock>> within(blocks.size());
    parallelFor(
        blocks.size(),
        {.threads = options.threads, .progress = options.progress ? Progress(isDone) : Progress()},
        [&](std::size_t begin, std::size_t end) {
          for (auto i = begin; i < end; ++i) {
            found[i] = cutBlock(surface, grid, blocks[i], level, options, classes);
            if (blocks[i].triangles.empty() || level == grid.deepest()) continue;
            within[i] = blocksWithin(surface, grid, blocks[i], level);
          }
        });
    for (auto& tile : found) {
      if (tile) tiles.push_back(std::move(*tile));
    }
    blocks.clear();
    for (auto& some : within) std::ranges::move(some, std::back_inserter(blocks));
  }
  return tiles;
}

}  // namespace cutwater
