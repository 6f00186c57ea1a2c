#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {

inline Vec3<double> areaVector(std::span<const Vec3<double>> polygon) {
  Vec3<double> area;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    area += 0.5 * cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  }
  return area;
}

/// Polygons that should be the boundary of a polyhedron.
class PolyhedronBoundary {
 public:
  /// `sign`: 1 if the polygon's normal points out of the polyhedron.
  void add(std::span<const Vec3<double>> polygon, int sign) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto& a = polygon[k];
      const auto& b = polygon[(k + 1) % polygon.size()];
      if (a == b) continue;
      const bool goesUp = std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
      edges_.emplace_back(goesUp ? keyOf(a, b) : keyOf(b, a), goesUp ? sign : -sign);
    }
    if (polygon.empty()) return;
    if (isEmpty_) origin_ = polygon[0];
    isEmpty_ = false;
    volume_ += sign * dot(polygon[0] - origin_, areaVector(polygon)) / 3;
  }
  [[nodiscard]] double volume() const { return volume_; }
  [[nodiscard]] std::size_t openEdges() {
    std::ranges::sort(edges_);
    std::size_t open = 0;
    for (std::size_t i = 0; i < edges_.size();) {
      int sum = 0;
      const auto& key = edges_[i].first;
      for (; i < edges_.size() && edges_[i].first == key; ++i) sum += edges_[i].second;
      if (sum != 0) ++open;
    }
    return open;
  }

 private:
  using Key = std::array<double, 6>;
  static Key keyOf(const Vec3<double>& a, const Vec3<double>& b) {
    return {a.x, a.y, a.z, b.x, b.y, b.z};
  }

  std::vector<std::pair<Key, int>> edges_;
  Vec3<double> origin_;
  double volume_ = 0;
  bool isEmpty_ = true;
};

inline double planeBelow(const CutCells& cells, const Index3& cell, int axis) {
  const auto& first = cells.grid.first;
  const int n = axis == 0 ? cell.i - first.i : axis == 1 ? cell.j - first.j : cell.k - first.k;
  return cells.grid.planes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(n) + 1];
}

/// That polygons are those of the arcs and walls, and close every piece, to the bit. `planeOf` and
/// `faceOf`: of the face of an arc, its place and its area; `unitOf`: the volume of a piece's cell.
/// `rounding`: of coordinates, times that of numbers near a cell's size.
template <typename Cut, typename PlaneOf, typename FaceOf, typename UnitOf>
void expectPolygons(const Cut& cut, std::size_t pieceCount, const PlaneOf& planeOf,
                    const FaceOf& faceOf, const UnitOf& unitOf, double rounding = 1) {
  ASSERT_EQ(cut.arcPolygons.count(), cut.arcs.area.size());
  ASSERT_EQ(cut.firstWallPolygon.size(), cut.wallParts.area.size() + 1);
  ASSERT_EQ(cut.firstWallPolygon.back(), cut.wallPolygons.count());
  std::vector<PolyhedronBoundary> boundaries(pieceCount);
  for (std::size_t a = 0; a < cut.arcs.area.size(); ++a) {
    const auto outline = cut.arcPolygons.of(a);
    const int axis = cut.arcs.axis[a];
    const double plane = planeOf(a);
    for (const auto& p : outline) ASSERT_EQ(p[axis], plane);
    EXPECT_NEAR(areaVector(outline)[axis], cut.arcs.area[a], 1e-13 * rounding * faceOf(a));
    if (cut.arcs.below[a] < pieceCount) boundaries[cut.arcs.below[a]].add(outline, 1);
    if (cut.arcs.above[a] < pieceCount) boundaries[cut.arcs.above[a]].add(outline, -1);
  }
  for (std::size_t w = 0; w < cut.wallParts.area.size(); ++w) {
    const auto piece = cut.wallParts.piece[w];
    double area = 0;
    for (auto n = cut.firstWallPolygon[w]; n < cut.firstWallPolygon[w + 1]; ++n) {
      const auto polygon = cut.wallPolygons.of(n);
      area += length(areaVector(polygon));
      if (piece < pieceCount) boundaries[piece].add(polygon, -1);
    }
    EXPECT_NEAR(area, cut.wallParts.area[w], 1e-12 * rounding * std::pow(unitOf(piece), 2.0 / 3));
  }
  for (std::uint32_t p = 0; p < pieceCount; ++p) {
    EXPECT_EQ(boundaries[p].openEdges(), 0U) << "piece " << p;
    EXPECT_NEAR(boundaries[p].volume(), cut.pieces.volume[p], 1e-12 * rounding * unitOf(p))
        << "piece " << p;
  }
}

inline void expectPolygonsOf(const CutCells& cells, double rounding = 1) {
  const double unit = cells.cellVolume(cells.grid.first);
  expectPolygons(
      cells, cells.pieceCount,
      [&](std::size_t a) { return planeBelow(cells, cells.arcs.cell[a], cells.arcs.axis[a]); },
      [&](std::size_t a) { return cells.faceArea(cells.arcs.cell[a], cells.arcs.axis[a]); },
      [&](std::uint32_t) { return unit; }, rounding);
}

inline void expectPolygonsOf(const CutLeaves& leaves, double rounding = 1) {
  const auto planeOf = [&](std::size_t a) {
    const bool isBelow = leaves.arcs.below[a] < leaves.pieces.cell.size();
    const auto piece = isBelow ? leaves.arcs.below[a] : leaves.arcs.above[a];
    const auto& box = leaves.cut.box[leaves.pieces.cell[piece]];
    return isBelow ? box.upper[leaves.arcs.axis[a]] : box.lower[leaves.arcs.axis[a]];
  };
  expectPolygons(
      leaves, leaves.pieces.cell.size(), planeOf,
      [&](std::size_t a) { return leaves.arcs.faceArea[a]; },
      [&](std::uint32_t p) { return leaves.leafVolume(leaves.pieces.cell[p]); }, rounding);
}

}  // namespace cutwater::test
