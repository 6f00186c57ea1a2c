#include <Cutwater/CutCells/Detail/Leaves/RimNotes.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellRims.hpp>

#include <algorithm>
#include <map>
#include <tuple>

namespace cutwater {

namespace {

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

void noteRims(const LeafGrid& grid, const TileParts& parts, bool meetsItself, bool withPolygons,
              LeafTile& tile) {
  RimNotes(grid, parts, tile).run(meetsItself, withPolygons);
}

}  // namespace cutwater
