#pragma once

#include <Cutwater/CutCells/CutCells.hpp>

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

/// That polygons are those of the arcs and walls, and close every piece, to the bit.
inline void expectPolygonsOf(const CutCells& cells) {
  const double unit = cells.cellVolume(cells.grid.first);
  ASSERT_EQ(cells.arcPolygons.count(), cells.arcs.area.size());
  ASSERT_EQ(cells.firstWallPolygon.size(), cells.wallParts.area.size() + 1);
  ASSERT_EQ(cells.firstWallPolygon.back(), cells.wallPolygons.count());
  std::vector<PolyhedronBoundary> boundaries(cells.pieceCount);
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto outline = cells.arcPolygons.of(a);
    const int axis = cells.arcs.axis[a];
    const double plane = planeBelow(cells, cells.arcs.cell[a], axis);
    for (const auto& p : outline) ASSERT_EQ(p[axis], plane);
    const auto area = areaVector(outline);
    EXPECT_NEAR(area[axis], cells.arcs.area[a], 1e-13 * cells.faceArea(cells.arcs.cell[a], axis));
    if (cells.arcs.below[a] < cells.pieceCount) boundaries[cells.arcs.below[a]].add(outline, 1);
    if (cells.arcs.above[a] < cells.pieceCount) boundaries[cells.arcs.above[a]].add(outline, -1);
  }
  for (std::size_t w = 0; w < cells.wallParts.area.size(); ++w) {
    double area = 0;
    for (auto n = cells.firstWallPolygon[w]; n < cells.firstWallPolygon[w + 1]; ++n) {
      const auto polygon = cells.wallPolygons.of(n);
      area += length(areaVector(polygon));
      const auto piece = cells.wallParts.piece[w];
      if (piece < cells.pieceCount) boundaries[piece].add(polygon, -1);
    }
    EXPECT_NEAR(area, cells.wallParts.area[w], 1e-12 * std::cbrt(unit) * std::cbrt(unit));
  }
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) {
    EXPECT_EQ(boundaries[p].openEdges(), 0U) << "piece " << p;
    EXPECT_NEAR(boundaries[p].volume(), cells.pieces.volume[p], 1e-12 * unit) << "piece " << p;
  }
}

}  // namespace cutwater::test
