#include <Cutwater/CutCells/Detail/Leaves/LeafTile.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellRims.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>

namespace cutwater {

namespace {

/// Notes what a tile knows about faces to leaves of other levels.
class RimNotes {
 public:
  RimNotes(const LeafGrid& grid, const TileParts& parts, LeafTile& tile)
      : grid_(grid), parts_(parts), tile_(tile) {}

  void run(bool meetsItself, bool withPolygons) {
    meetsItself_ = meetsItself;
    withPolygons_ = withPolygons;
    for (std::uint32_t row = 0; row < tile_.leaves.size(); ++row) {
      bool hasFiner = false;
      for (int axis = 0; axis < 3; ++axis) {
        for (const bool isHigh : {false, true}) {
          const auto what = grid_.across(tile_.leaves[row], axis, isHigh).first;
          hasFiner = hasFiner || what == LeafGrid::Across::Finer;
          if (what == LeafGrid::Across::Finer) {
            facesToFiner_.emplace_back(tile_.faceOf(row, axis, isHigh), isHigh);
            if (tile_.cut.meets[row] != 0) addOpenRegions(row, axis, isHigh);
          }
          if (what == LeafGrid::Across::Coarser) addFace(tile_.faceOf(row, axis, isHigh));
        }
      }
      if (hasFiner) addWalls(row);
    }
    if (withPolygons_ && !facesToFiner_.empty()) addWallEdges();
    std::ranges::sort(tile_.rims.innerPoints, {}, &LeafRims::InnerPoint::arc);
    std::ranges::stable_sort(tile_.rims.openRegions, {}, &LeafRims::OpenRegion::face);
    std::ranges::sort(tile_.rims.cutFaces);
    std::ranges::sort(tile_.rims.traces, {}, &LeafRims::Trace::key);
    std::ranges::sort(tile_.rims.wallEdges, {}, &LeafRims::WallEdge::key);
    std::ranges::sort(tile_.rims.triangles, {}, &LeafRims::RimTriangle::key);
    std::ranges::sort(tile_.rims.stretches, {}, [](const LeafRims::RimStretch& s) {
      return std::tuple(s.face, s.side, s.arc, s.ends.lower);
    });
  }

 private:
  void addFace(std::uint32_t face) {
    if (!parts_.faces.isCut(face)) return;
    if (meetsItself_) addInnerPoints(face);
    if (parts_.faces.meetsOn(face)) return;
    auto& rims = tile_.rims;
    rims.cutFaces.push_back(face);
    const auto [first, last] = parts_.faces.tracesOf(face);
    for (auto trace = first; trace < last; ++trace) {
      // Open parts are the first arcs.
      rims.triangles.push_back(
          {parts_.faces.ofTrace(trace), parts_.surface.traces()[trace].triangle});
      if (!withPolygons_) continue;
      const auto& it = parts_.surface.traces()[trace];
      rims.traces.push_back({face, it.triangle, it.from, it.to});
    }
    const auto& numbers = parts_.surface.numbers();
    for (int side = 0; side < 4; ++side) {
      const auto edge = edgeOfFace(numbers.axisOfFace(face), numbers.placeOfFace(face), side);
      const auto stretches = parts_.stretches.of(edge.axis, edge.place);
      for (std::size_t s = 0; s < stretches.size(); ++s) {
        rims.stretches.push_back(
            {.face = face,
             .side = side,
             .isWhole = stretches[s].start == kNone && stretches[s].end == kNone,
             .arc = parts_.faces.ofStretch(face, side, s),
             .ends = {stretches[s].from, stretches[s].to}});
      }
    }
  }

  /// Of each open part, in the largest of its regions.
  void addInnerPoints(std::uint32_t face) {
    const int axis = parts_.surface.numbers().axisOfFace(face);
    std::map<std::uint32_t, std::pair<double, Vec3<double>>> largest;
    for (const auto& region : parts_.faces.regionsOn(face)) {
      if (region.part == kNone) continue;
      const double area = twiceArea(region.polygon)[axis];
      const auto found = largest.try_emplace(region.part, -1.0, Vec3<double>{}).first;
      if (area > found->second.first) found->second = {area, region.point};
    }
    for (const auto& [arc, best] : largest) tile_.rims.innerPoints.push_back({arc, best.second});
  }
  void addOpenRegions(std::uint32_t row, int axis, bool isHigh) {
    const auto face = tile_.faceOf(row, axis, isHigh);
    const auto& arcs = tile_.cut.content.arcs;
    const auto whole = tile_.arcsOf(face);  // if it is not cut
    for (auto& region : parts_.faces.regionsOn(face)) {
      if (!region.isFluid) continue;
      if (region.part == kNone && whole.empty()) continue;
      const auto& arc = arcs[region.part == kNone ? whole.front().second : region.part];
      tile_.rims.openRegions.push_back(
          {face, isHigh ? arc.below : arc.above, std::move(region.polygon)});
    }
  }

  void addWalls(std::uint32_t row) {
    const auto fragments = parts_.surface.fragments();
    const auto cell = tile_.cut.cells[row];
    auto fragment = std::ranges::lower_bound(fragments, cell, {}, &TileFragment::cell);
    for (; fragment != fragments.end() && fragment->cell == cell; ++fragment) {
      const auto number = static_cast<std::size_t>(fragment - fragments.begin());
      tile_.rims.walls.push_back({row, fragment->triangle, tile_.cut.content.ofFragments[number]});
    }
  }

  void addWallEdges() {
    std::ranges::sort(facesToFiner_);
    const TracesOfFragments traces(parts_.surface);
    const auto& fragmentOf = tile_.cut.polygons.fragmentOf;
    for (std::uint32_t wall = 0; wall < fragmentOf.size(); ++wall) {
      if (fragmentOf[wall] == kNone) continue;  // the whole piece is closed at last
      for (const auto number : traces.of(fragmentOf[wall])) {
        const auto& trace = parts_.surface.traces()[number];
        const bool isHigh = trace.below == fragmentOf[wall];
        if (!std::ranges::binary_search(facesToFiner_, std::pair(trace.face, isHigh))) continue;
        tile_.rims.wallEdges.push_back({.wall = wall,
                                        .edge = edgeOn(trace, fragmentOf[wall]),
                                        .triangle = trace.triangle,
                                        .axis = parts_.surface.numbers().axisOfFace(trace.face),
                                        .isHigh = isHigh});
      }
    }
  }
  /// Which of a fragment's edges a trace is. Of several that are one point, any will do.
  [[nodiscard]] std::uint32_t edgeOn(const FaceTrace& trace, std::uint32_t fragment) const {
    const auto& it = parts_.surface.fragments()[fragment];
    const auto points = parts_.surface.points(it);
    const auto meshEdges = parts_.surface.meshEdges(it);
    const bool isBelow = trace.below == fragment;
    std::uint32_t edge = 0;
    while (edge + 1 < it.size) {
      const auto& from = points[edge];
      const auto& to = points[edge + 1];
      const bool isIt =
          isBelow ? from == trace.from && to == trace.to : from == trace.to && to == trace.from;
      if (isIt && meshEdges[edge] == kNone) break;
      ++edge;
    }
    return edge;
  }

  const LeafGrid& grid_;
  const TileParts& parts_;
  LeafTile& tile_;
  bool meetsItself_ = false;
  bool withPolygons_ = false;
  std::vector<std::pair<std::uint32_t, bool>> facesToFiner_;  // and whether they are high ones
};

}  // namespace

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

/// Cuts the leaves of a block's own level.
LeafTile cutLeaves(const CutSurface& surface, const LeafGrid& grid, const LeafBlock& block,
                   int level, const CutOptions& options, std::span<FluidClass> classes) {
  const BlockPlanes planes(grid, level, block.first);
  CellMask wanted;
  const TileInput input{.planes = planes.view(),
                        .triangles = block.triangles,
                        .winding = block.winding,
                        .wanted = &wanted};
  const TileNumbers numbers({input.planes.cells(0), input.planes.cells(1), input.planes.cells(2)});
  std::vector<std::uint32_t> leafOf(numbers.cellCount(), LeafGrid::kNoLeaf);
  for (auto leaf = block.firstLeaf; leaf < block.lastLeaf; ++leaf) {
    const auto& [index, itsLevel, kind] = grid.leaves()[leaf];
    if (itsLevel != level) continue;
    const auto cell =
        numbers.cell({index.i - block.first.i, index.j - block.first.j, index.k - block.first.k});
    wanted[cell] = true;
    leafOf[cell] = leaf;
  }
  const TileParts parts(surface, input);
  LeafTile tile{.level = level,
                .first = block.first,
                .cut = cutTile(parts, options),
                .leaves = {},
                .arcs = {},
                .points = {},
                .openArcs = {},
                .rims = {}};
  for (std::uint32_t cell = 0; cell < numbers.cellCount(); ++cell) {
    if (leafOf[cell] == LeafGrid::kNoLeaf) continue;
    classes[leafOf[cell]] = tile.cut.isBody[cell] ? FluidClass::Body : FluidClass::Fluid;
  }
  for (std::uint32_t row = 0; row < tile.cut.cells.size(); ++row) {
    tile.leaves.push_back(leafOf[tile.cut.cells[row]]);
    if (tile.cut.isTouched[row] == 0) classes[tile.leaves.back()] = FluidClass::Cut;
  }
  for (std::uint32_t arc = 0; arc < tile.cut.content.arcs.size(); ++arc) {
    const auto& it = tile.cut.content.arcs[arc];
    if (it.isOpenPatch()) {
      tile.openArcs.emplace_back(it.face, arc);
      continue;
    }
    if (!it.isNothing) tile.arcs.emplace_back(it.face, arc);
    const bool isOutlined = options.polygons && !tile.cut.polygons.arcs.of(arc).empty();
    if (it.isNothing && isOutlined) tile.points.emplace_back(it.face, arc);
  }
  std::ranges::sort(tile.arcs);
  std::ranges::sort(tile.points);
  std::ranges::sort(tile.openArcs);
  RimNotes(grid, parts, tile).run(surface.meetsItself(), options.polygons);
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
  if (tile.leaves.empty()) return {};
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
