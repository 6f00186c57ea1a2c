#include <Cutwater/CutCells/Detail/Leaves/LeafBlocks.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

namespace {

bool overlap(const Box<double>& a, const Box<double>& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.lower[axis] > b.upper[axis] || b.lower[axis] > a.upper[axis]) return false;
  }
  return true;
}

void setLeaves(const LeafGrid& grid, int level, LeafBlock& block) {
  std::tie(block.firstLeaf, block.lastLeaf) = grid.within(block.first, level, kTileBits);
}

/// Going up an axis from one point to another, by how much the triangles let the winding number
/// rise.
int riseAlong(const CutSurface& surface, std::span<const std::uint32_t> triangles,
              const Vec3<double>& from, int axis, double to) {
  auto end = from;
  end[axis] = to;
  int rise = 0;
  for (const auto id : triangles) {
    if (surface.moved().isBaffle(id) || !overlap(surface.box(id), {from, end})) continue;
    const auto triangle = surface.moved().triangle(id);
    rise += riseBelowNode(triangle, end, axis) - riseBelowNode(triangle, from, axis);
  }
  return rise;
}

}  // namespace

BlockPlanes::BlockPlanes(const LeafGrid& grid, int level, const Index3& first) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto start = along(first, axis);
    auto& count = counts_[asIndex(axis)];
    count = std::min(kTileWidth, grid.cells(level, axis) - start) + 1;
    for (int n = 0; n < count; ++n) {
      positions_[asIndex(axis)][static_cast<std::size_t>(n)] =
          grid.planeInFrame(level, axis, start + n);
    }
  }
}

GridPlanes BlockPlanes::view() const {
  GridPlanes planes;
  for (std::size_t a = 0; a < 3; ++a) {
    planes.positions[a] = std::span(positions_[a]).first(static_cast<std::size_t>(counts_[a]));
  }
  return planes;
}

Box<double> BlockPlanes::box() const {
  const auto planes = view();
  const auto& [x, y, z] = planes.positions;
  return {{x.front(), y.front(), z.front()}, {x.back(), y.back(), z.back()}};
}

std::vector<LeafBlock> rootBlocks(const CutSurface& surface, const LeafGrid& grid) {
  std::array<std::vector<double>, 3> positions;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i <= grid.cells(0, axis); ++i) {
      positions[asIndex(axis)].push_back(grid.planeInFrame(0, axis, i));
    }
  }
  const GridPlanes planes{{positions[0], positions[1], positions[2]}};
  const CutTiles tiles(surface, planes);
  std::vector<LeafBlock> blocks;
  for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
    const auto first = tiles.firstCell(tile);
    const auto triangles = tiles.triangles(tile);
    blocks.push_back({.first = {first[0], first[1], first[2]},
                      .winding = tiles.winding(tile),
                      .triangles = {triangles.begin(), triangles.end()}});
    setLeaves(grid, 0, blocks.back());
  }
  return blocks;
}

std::vector<LeafBlock> blocksWithin(const CutSurface& surface, const LeafGrid& grid,
                                    const LeafBlock& block, int level) {
  const auto rise = [&](const Vec3<double>& from, int axis, double to) {
    return riseAlong(surface, block.triangles, from, axis, to);
  };
  const auto low = BlockPlanes(grid, level, block.first).box().lower;
  std::vector<LeafBlock> blocks;
  std::array<int, 8> windings{};
  for (int child = 0; child < 8; ++child) {
    LeafBlock within{.first = {}, .triangles = {}};
    bool isInDomain = true;
    for (int axis = 0; axis < 3; ++axis) {
      const int shift = (child >> axis & 1) != 0 ? kTileWidth : 0;
      along(within.first, axis) = 2 * along(block.first, axis) + shift;
      isInDomain = isInDomain && along(within.first, axis) < grid.cells(level + 1, axis);
    }
    if (!isInDomain) continue;
    const BlockPlanes planes(grid, level + 1, within.first);
    const auto box = planes.box();
    // From the corner of a child that is lower along one axis.
    const int axis = child == 0 ? -1 : child >= 4 ? 2 : child >= 2 ? 1 : 0;
    auto& winding = windings[static_cast<std::size_t>(child)];
    winding = block.winding;
    if (axis >= 0) {
      auto from = box.lower;
      from[axis] = low[axis];
      winding = windings[static_cast<std::size_t>(child & ~(1 << axis))] +
                rise(from, axis, box.lower[axis]);
    }
    setLeaves(grid, level + 1, within);
    const auto leaves = grid.leaves().subspan(within.firstLeaf, within.lastLeaf - within.firstLeaf);
    const bool hasFiner =
        std::ranges::any_of(leaves, [&](const OctreeCell& leaf) { return leaf.level > level; });
    if (!hasFiner) continue;
    within.winding = winding;
    std::ranges::copy_if(block.triangles, std::back_inserter(within.triangles),
                         [&](std::uint32_t id) { return overlap(surface.box(id), box); });
    blocks.push_back(std::move(within));
  }
  return blocks;
}

}  // namespace cutwater
