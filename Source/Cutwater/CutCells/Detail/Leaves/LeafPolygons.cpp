#include <Cutwater/CutCells/Detail/Leaves/LeafPolygons.hpp>
#include <Cutwater/CutCells/Detail/Rows/OpenRows.hpp>
#include <Cutwater/CutCells/Detail/Rows/PieceRows.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

using LineTrace = std::array<Vec3<double>, 2>;

/// Appends the way from a point to another one along traces on the line between them: each begins
/// where the one before ends, but for rounding.
void addChain(const Vec3<double>& to, std::vector<LineTrace> traces,
              std::vector<Vec3<double>>& out) {
  const auto corners = out.size();
  std::erase_if(traces, [](const LineTrace& trace) { return trace[0] == trace[1]; });
  for (auto rest = traces.begin(); rest != traces.end(); ++rest) {
    const auto way = [&](const LineTrace& trace) { return lengthSquared(trace[0] - out.back()); };
    std::iter_swap(rest, std::ranges::min_element(rest, traces.end(), {}, way));
    for (const auto& point : *rest) {
      if (point != out.back()) out.push_back(point);
    }
  }
  if (out.size() > corners && out.back() == to) out.pop_back();
}

}  // namespace

Vec3<double> LeafPolygons::inWorldOf(const LeafTile& tile, const TilePlace& within,
                                     const Vec3<double>& point) const {
  const auto planeOf = [&](int axis, int number) {
    const auto cell = along(tile.first, axis) + number;
    return std::pair(grid_.planeInFrame(tile.level, axis, cell),
                     grid_.plane(tile.level, axis, cell));
  };
  return inWorld(point, frame_, within, tile.cut.numbers.cells(), planeOf);
}

LeafPolygons::Polygon LeafPolygons::outlineOf(std::uint32_t source, std::uint32_t arc) {
  const auto& tile = sources_.tileOf(source);
  const auto& it = tile.cut.content.arcs[arc];
  if (it.isOpenPatch()) {
    const bool isBelow = it.below != kNone;
    CutCells::Polygons parts;
    addWall(source, isBelow ? it.below : it.above, WallPolygons::kOfArc + arc, parts);
    return openOutline(parts, FaceAxes(tile.cut.numbers.axisOfFace(it.face)), isBelow);
  }
  const auto within = tile.cut.numbers.placeOfFace(it.face);
  Polygon result;
  for (const auto& point : tile.cut.polygons.arcs.of(arc)) {
    result.push_back(inWorldOf(tile, within, point));
  }
  return result;
}

LeafPolygons::Polygon LeafPolygons::outlineOfFace(std::uint32_t leaf, int axis, bool isHigh) const {
  const auto box = grid_.boxOf(leaf);
  auto corner = box.lower;
  if (isHigh) corner[axis] = box.upper[axis];
  const int c = (axis + 1) % 3;
  const int d = (axis + 2) % 3;
  Polygon result{corner, corner, corner, corner};
  result[1][c] = result[2][c] = box.upper[c];
  result[2][d] = result[3][d] = box.upper[d];
  return result;
}

void LeafPolygons::addWall(std::uint32_t source, std::uint32_t piece, std::uint32_t patch,
                           CutCells::Polygons& to) {
  const auto& of = sources_.tileOf(source).cut.polygons.wallOf;
  const auto [first, last] = std::equal_range(of.begin(), of.end(), std::pair(piece, patch));
  for (auto wall = first; wall != last; ++wall) {
    to.add(wallPolygon(source, static_cast<std::uint32_t>(wall - of.begin())));
  }
}

LeafPolygons::Polygon LeafPolygons::wallPolygon(std::uint32_t source, std::uint32_t number) {
  const auto& tile = sources_.tileOf(source);
  const auto within = tile.cut.numbers.placeOfCell(tile.cut.cells[sources_.source(source).row]);
  Polygon corners;
  for (const auto& point : tile.cut.polygons.walls.of(number)) {
    corners.push_back(inWorldOf(tile, within, point));
  }
  const auto& edges = tile.rims.wallEdges;
  auto edge = std::ranges::lower_bound(edges, number, {}, &LeafRims::WallEdge::wall);
  Polygon result;
  for (std::uint32_t k = 0; k < corners.size(); ++k) {
    result.push_back(corners[k]);
    for (; edge != edges.end() && edge->wall == number && edge->edge == k; ++edge) {
      const auto& next = corners[(k + 1) % corners.size()];
      addChain(next, finerTraces(source, *edge), result);
    }
  }
  return result;
}

/// Those of the edge's triangle, along the edge.
std::vector<LeafPolygons::Trace> LeafPolygons::finerTraces(std::uint32_t source,
                                                           const LeafRims::WallEdge& edge) {
  std::vector<Trace> result;
  for (const auto finer : finerAcross(source, edge.axis, edge.isHigh)) {
    const auto& tile = sources_.tileOf(finer);
    const auto face = sources_.faceOf(finer, edge.axis, !edge.isHigh);
    const std::pair wanted(face, edge.triangle);
    const auto trace =
        std::ranges::lower_bound(tile.rims.traces, wanted, {}, &LeafRims::Trace::key);
    if (trace == tile.rims.traces.end() || trace->key() != wanted) continue;
    const auto within = tile.cut.numbers.placeOfFace(face);
    result.push_back({inWorldOf(tile, within, trace->from), inWorldOf(tile, within, trace->to)});
    // A trace has the direction of the triangle below its plane.
    if (!edge.isHigh) std::swap(result.back()[0], result.back()[1]);
  }
  return result;
}

std::span<const std::uint32_t> LeafPolygons::finerAcross(std::uint32_t source, int axis,
                                                         bool isHigh) {
  if (source_ != source) {
    source_ = source;
    for (auto& list : finer_) list.clear();
  }
  auto& list = finer_[asIndex(2 * axis + (isHigh ? 1 : 0))];
  if (list.empty()) {
    for (const auto leaf : grid_.finerAcross(sources_.source(source).leaf, axis, isHigh)) {
      if (sources_.of(leaf) != kNone) list.push_back(sources_.of(leaf));
    }
  }
  return list;
}

}  // namespace cutwater
