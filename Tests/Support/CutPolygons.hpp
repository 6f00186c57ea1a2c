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

/// The plane of the face of an arc.
inline double planeOfArc(const CutCells& cells, std::size_t arc) {
  return planeBelow(cells, cells.arcs.cell[arc], cells.arcs.axis[arc]);
}
inline double planeOfArc(const CutLeaves& leaves, std::size_t arc) {
  const bool isBelow = leaves.arcs.below[arc] < leaves.pieces.cell.size();
  const auto piece = isBelow ? leaves.arcs.below[arc] : leaves.arcs.above[arc];
  const auto& box = leaves.cut.box[leaves.pieces.cell[piece]];
  return isBelow ? box.upper[leaves.arcs.axis[arc]] : box.lower[leaves.arcs.axis[arc]];
}

/// The pieces of its own cells.
inline std::size_t ownPieces(const CutCells& cells) {
  return cells.pieceCount;
}
inline std::size_t ownPieces(const CutLeaves& leaves) {
  return leaves.pieces.cell.size();
}

/// That polygons close every piece, to the bit. The boundaries of pieces.
template <typename Cut>
std::vector<PolyhedronBoundary> closedPieces(const Cut& cut) {
  std::vector<PolyhedronBoundary> boundaries(ownPieces(cut));
  EXPECT_EQ(cut.arcPolygons.count(), cut.arcs.area.size());
  EXPECT_EQ(cut.firstWallPolygon.size(), cut.wallParts.area.size() + 1);
  EXPECT_EQ(cut.firstWallPolygon.back(), cut.wallPolygons.count());
  for (std::size_t a = 0; a < cut.arcs.area.size(); ++a) {
    const auto outline = cut.arcPolygons.of(a);
    const double plane = planeOfArc(cut, a);
    for (const auto& p : outline) EXPECT_EQ(p[cut.arcs.axis[a]], plane);
    if (cut.arcs.below[a] < boundaries.size()) boundaries[cut.arcs.below[a]].add(outline, 1);
    if (cut.arcs.above[a] < boundaries.size()) boundaries[cut.arcs.above[a]].add(outline, -1);
  }
  for (std::size_t w = 0; w < cut.wallParts.area.size(); ++w) {
    const auto piece = cut.wallParts.piece[w];
    if (piece >= boundaries.size()) continue;
    for (auto n = cut.firstWallPolygon[w]; n < cut.firstWallPolygon[w + 1]; ++n) {
      boundaries[piece].add(cut.wallPolygons.of(n), -1);
    }
  }
  for (std::size_t p = 0; p < boundaries.size(); ++p) {
    EXPECT_EQ(boundaries[p].openEdges(), 0U) << "piece " << p;
  }
  return boundaries;
}

/// That polygons are those of the arcs and walls, and close every piece, to the bit. `faceOf`: the
/// area of the face of an arc; `unitOf`: the volume of a piece's cell. `rounding`: of coordinates,
/// times that of numbers near a cell's size.
template <typename Cut, typename FaceOf, typename UnitOf>
void expectPolygons(const Cut& cut, const FaceOf& faceOf, const UnitOf& unitOf,
                    double rounding = 1) {
  const auto boundaries = closedPieces(cut);
  for (std::size_t a = 0; a < cut.arcs.area.size(); ++a) {
    const double area = areaVector(cut.arcPolygons.of(a))[cut.arcs.axis[a]];
    EXPECT_NEAR(area, cut.arcs.area[a], 1e-13 * rounding * faceOf(a));
  }
  for (std::size_t w = 0; w < cut.wallParts.area.size(); ++w) {
    const auto piece = cut.wallParts.piece[w];
    double area = 0;
    for (auto n = cut.firstWallPolygon[w]; n < cut.firstWallPolygon[w + 1]; ++n) {
      area += length(areaVector(cut.wallPolygons.of(n)));
    }
    EXPECT_NEAR(area, cut.wallParts.area[w], 1e-12 * rounding * std::pow(unitOf(piece), 2.0 / 3));
  }
  for (std::uint32_t p = 0; p < boundaries.size(); ++p) {
    EXPECT_NEAR(boundaries[p].volume(), cut.pieces.volume[p], 1e-12 * rounding * unitOf(p))
        << "piece " << p;
  }
}

inline void expectPolygonsOf(const CutCells& cells, double rounding = 1) {
  const double unit = cells.cellVolume(cells.grid.first);
  expectPolygons(
      cells, [&](std::size_t a) { return cells.faceArea(cells.arcs.cell[a], cells.arcs.axis[a]); },
      [&](std::uint32_t) { return unit; }, rounding);
}

inline void expectPolygonsOf(const CutLeaves& leaves, double rounding = 1) {
  expectPolygons(
      leaves, [&](std::size_t a) { return leaves.arcs.faceArea[a]; },
      [&](std::uint32_t p) { return leaves.leafVolume(leaves.pieces.cell[p]); }, rounding);
}

}  // namespace cutwater::test
