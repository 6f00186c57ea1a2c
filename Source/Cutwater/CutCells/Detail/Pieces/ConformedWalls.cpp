#include <Cutwater/CutCells/Detail/Faces/MergedPoints.hpp>
#include <Cutwater/CutCells/Detail/Pieces/ConformedWalls.hpp>
#include <Cutwater/CutCells/Detail/Pieces/WallJoining.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace cutwater {

namespace {

using Polygon = std::vector<Vec3<double>>;

/// Adds the walls of one cell after another.
class WallConformer {
 public:
  WallConformer(const TileSurface& surface, const CellPieces& content,
                const CutCells::Polygons& outlines)
      : surface_(surface), content_(content), outlines_(outlines) {
    for (std::uint32_t arc = 0; arc < content.arcs.size(); ++arc) {
      arcsOfFaces_.emplace_back(content.arcs[arc].face, arc);
    }
    std::ranges::sort(arcsOfFaces_);
  }

  WallPolygons run() {
    const auto& of = content_.meetingWalls.of;
    const auto cellOf = [&](std::size_t wall) { return content_.pieces[of[wall].first].cell; };
    for (std::size_t first = 0; first < of.size();) {
      auto last = first + 1;
      while (last < of.size() && cellOf(last) == cellOf(first)) ++last;
      addCell(cellOf(first), first, last);
      first = last;
    }
    return std::move(result_);
  }

 private:
  void addCell(std::uint32_t cell, std::size_t first, std::size_t last) {
    MergedPoints points;
    keepOutlines(cell, points);
    for (const auto& fragment : sortedUnder(surface_.fragments(), cell, &TileFragment::cell)) {
      for (const auto& p : surface_.points(fragment)) points.merged(p);
    }
    // Of each piece and patch.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Polygon>> parts;
    for (auto wall = first; wall < last; ++wall) {
      auto polygon = points.mergedPolygon(content_.meetingWalls.polygons.of(wall));
      if (!polygon.empty()) parts[content_.meetingWalls.of[wall]].push_back(std::move(polygon));
    }
    MergedPoints corners;  // without those that joining takes away
    keepOutlines(cell, corners);
    for (auto& [of, polygons] : parts) {
      joinConvex(polygons);
      for (const auto& polygon : polygons) corners.keep(polygon);
    }
    for (const auto& [of, polygons] : parts) {
      for (const auto& polygon : polygons) {
        result_.of.push_back(of);
        result_.polygons.add(corners.throughPoints(polygon));
      }
    }
  }
  /// Of the open parts of all faces of a cell.
  void keepOutlines(std::uint32_t cell, MergedPoints& points) const {
    const auto& numbers = surface_.numbers();
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        auto place = numbers.placeOfCell(cell);
        place[asIndex(axis)] += side;
        const std::pair face(numbers.face(axis, place), 0U);
        for (auto arc = std::ranges::lower_bound(arcsOfFaces_, face);
             arc != arcsOfFaces_.end() && arc->first == face.first; ++arc) {
          points.keep(outlines_.of(arc->second));
        }
      }
    }
  }

  const TileSurface& surface_;
  const CellPieces& content_;
  const CutCells::Polygons& outlines_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> arcsOfFaces_;
  WallPolygons result_;
};

}  // namespace

WallPolygons conformedWalls(const TileSurface& surface, const CellPieces& content,
                            const CutCells::Polygons& outlines) {
  if (content.meetingWalls.of.empty()) return {};
  return WallConformer(surface, content, outlines).run();
}

}  // namespace cutwater
