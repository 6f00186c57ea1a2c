#include <Cutwater/CutCells/Detail/Leaves/HangingCorners.hpp>

#include <algorithm>
#include <array>

namespace cutwater {

namespace {

/// Whether a finer leaf, or a coarser one that is cut, is across a face or an edge. Beside a
/// coarser one that is not, all polygons are of this level.
bool isBesideOtherLevel(const LeafGrid& grid, const CutLeaves& leaves, std::uint32_t leaf) {
  const auto& [index, level, kind] = grid.leaves()[leaf];
  for (int n = 0; n < 27; ++n) {
    const std::array<int, 3> step{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    if (step[0] != 0 && step[1] != 0 && step[2] != 0) continue;
    auto cell = index;
    for (int axis = 0; axis < 3; ++axis) along(cell, axis) += step[asIndex(axis)];
    const auto other = grid.at(cell, level, leaf);
    if (other == LeafGrid::kNoLeaf || grid.leaves()[other].level == level) continue;
    if (grid.leaves()[other].level > level) return true;
    if (leaves.classes[other] == FluidClass::Cut) return true;
  }
  return false;
}

/// Orders points by the lines along an axis on which they lie, and along these.
struct AlongAxis {
  int axis;
  std::array<double, 3> operator()(const Vec3<double>& p) const {
    return {p[(axis + 1) % 3], p[(axis + 2) % 3], p[axis]};
  }
};

/// Points by the lines along each axis on which they lie.
class PointsOnLines {
 public:
  void add(std::span<const Vec3<double>> points) {
    lines_[0].insert(lines_[0].end(), points.begin(), points.end());
  }
  void sort() {
    lines_[1] = lines_[2] = lines_[0];
    for (int axis = 0; axis < 3; ++axis) {
      auto& points = lines_[asIndex(axis)];
      std::ranges::sort(points, {}, AlongAxis{axis});
      points.erase(std::unique(points.begin(), points.end()), points.end());
    }
  }
  /// Appends the points between two, if these lie on one line.
  void addBetween(const Vec3<double>& from, const Vec3<double>& to,
                  std::vector<Vec3<double>>& out) const {
    int axis = -1;
    for (int a = 0; a < 3; ++a) {
      if (from[a] == to[a]) continue;
      if (axis >= 0) return;
      axis = a;
    }
    if (axis < 0) return;
    const bool goesUp = from[axis] < to[axis];
    const AlongAxis key{axis};
    const auto& points = lines_[asIndex(axis)];
    const auto first = std::ranges::upper_bound(points, key(goesUp ? from : to), {}, key);
    const auto last =
        std::ranges::lower_bound(first, points.end(), key(goesUp ? to : from), {}, key);
    const auto begin = static_cast<std::ptrdiff_t>(out.size());
    out.insert(out.end(), first, last);
    if (!goesUp) std::reverse(out.begin() + begin, out.end());
  }

 private:
  std::array<std::vector<Vec3<double>>, 3> lines_;
};

CutCells::Polygons throughPoints(const CutCells::Polygons& polygons, const PointsOnLines& points) {
  CutCells::Polygons result;
  std::vector<Vec3<double>> corners;
  for (std::size_t n = 0; n < polygons.count(); ++n) {
    const auto polygon = polygons.of(n);
    corners.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      corners.push_back(polygon[k]);
      points.addBetween(polygon[k], polygon[(k + 1) % polygon.size()], corners);
    }
    result.add(corners);
  }
  return result;
}

}  // namespace

void insertHangingCorners(const LeafGrid& grid, CutLeaves& leaves) {
  std::vector<char> isMixed;  // of rows
  for (const auto leaf : leaves.cut.leaf) {
    isMixed.push_back(isBesideOtherLevel(grid, leaves, leaf) ? 1 : 0);
  }
  if (std::ranges::count(isMixed, 1) == 0) return;
  const auto isMixedPiece = [&](std::uint32_t piece) {
    return piece < leaves.pieces.cell.size() && isMixed[leaves.pieces.cell[piece]] != 0;
  };
  PointsOnLines points;
  for (std::size_t arc = 0; arc < leaves.arcs.area.size(); ++arc) {
    if (isMixedPiece(leaves.arcs.below[arc]) || isMixedPiece(leaves.arcs.above[arc])) {
      points.add(leaves.arcPolygons.of(arc));
    }
  }
  for (std::size_t part = 0; part < leaves.wallParts.piece.size(); ++part) {
    if (!isMixedPiece(leaves.wallParts.piece[part])) continue;
    for (auto n = leaves.firstWallPolygon[part]; n < leaves.firstWallPolygon[part + 1]; ++n) {
      points.add(leaves.wallPolygons.of(n));
    }
  }
  points.sort();
  leaves.arcPolygons = throughPoints(leaves.arcPolygons, points);
  leaves.wallPolygons = throughPoints(leaves.wallPolygons, points);
}

}  // namespace cutwater
