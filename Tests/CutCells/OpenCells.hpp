#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <array>
#include <functional>
#include <map>
#include <utility>

#include <gtest/gtest.h>

namespace cutwater::test {

/// A triangle that lies across an axis, its middle, and where its normal points along that: 1 or
/// -1.
struct FlatTriangle {
  int axis = 0;
  int facing = 0;
  Vec3<double> middle;
};

/// The soup with its patches anew: each triangle that lies across an axis belongs to the one that
/// `patchOf` says; the others to the first.
inline PolygonSoup withPatches(PolygonSoup soup, std::vector<std::string> names,
                               const std::function<std::uint32_t(const FlatTriangle&)>& patchOf) {
  soup.patchNames = std::move(names);
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    const std::array p{soup.points[corners[0]], soup.points[corners[1]], soup.points[corners[2]]};
    const auto normal = cross(p[1] - p[0], p[2] - p[0]);
    soup.patches[i] = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (p[0][axis] != p[1][axis] || p[0][axis] != p[2][axis]) continue;
      soup.patches[i] = patchOf({axis, normal[axis] > 0 ? 1 : -1, (p[0] + p[1] + p[2]) / 3.0});
    }
  }
  return soup;
}

/// A solid whose ends along x are the patches "inlet" and "outlet".
inline Solid<double> ductOf(const PolygonSoup& soup) {
  const auto box = soup.boundingBox();
  return Solid<double>(MeshSDF<double>(
      withPatches(soup, {"wall", "inlet", "outlet"}, [&](const FlatTriangle& t) -> std::uint32_t {
        if (t.axis != 0) return 0;
        return t.middle.x == box.lower.x ? 1 : t.middle.x == box.upper.x ? 2 : 0;
      })));
}

/// With these open.
inline const CutterOptions kEndsOpen{.openPatches = {"inlet", "outlet"}};

/// Whether an arc is a part of an open patch.
inline bool isOpenPatch(const CutCells& cells, std::size_t arc) {
  return cells.openArcs.patchOf(static_cast<std::uint32_t>(arc)) != CutCells::kNoRow;
}

/// What a piece has of open patches: areas, and vectors out of the fluid.
struct OpenSum {
  double area = 0;
  Vec3<double> vector;
  Vec3<double> moment;  ///< areas times centroids
};

/// By piece and patch.
using OpenSums = std::map<std::pair<std::uint32_t, std::uint32_t>, OpenSum>;
inline OpenSums openSums(const CutCells& cells) {
  OpenSums sums;
  const auto& arcs = cells.arcs;
  for (std::size_t n = 0; n < cells.openArcs.arc.size(); ++n) {
    const auto a = cells.openArcs.arc[n];
    const bool isUp = arcs.above[a] == CutCells::kBeyond;
    EXPECT_NE(isUp, arcs.below[a] == CutCells::kBeyond);
    auto& sum = sums[{isUp ? arcs.below[a] : arcs.above[a], cells.openArcs.patch[n]}];
    sum.area += arcs.area[a];
    sum.vector[arcs.axis[a]] += isUp ? arcs.area[a] : -arcs.area[a];
    sum.moment += arcs.area[a] * arcs.centroid[a];
  }
  return sums;
}
inline double openArea(const CutCells& cells) {
  double area = 0;
  for (const auto& [key, sum] : openSums(cells)) area += sum.area;
  return area;
}

/// That cells with open patches are those of the same surface with walls instead, to the bit, and
/// arcs take the places of walls.
inline void expectOpened(const CutCells& open, const CutCells& closed,
                         const std::function<bool(std::uint32_t)>& isOpen) {
  ASSERT_EQ(open.cells.index, closed.cells.index);
  ASSERT_EQ(open.cells.firstPiece, closed.cells.firstPiece);
  EXPECT_EQ(open.cells.fluidCorners, closed.cells.fluidCorners);
  EXPECT_EQ(open.pieces.volume, closed.pieces.volume);
  EXPECT_EQ(open.pieces.centroid, closed.pieces.centroid);
  EXPECT_EQ(open.bodyRuns, closed.bodyRuns);
  EXPECT_EQ(open.moments.volume, closed.moments.volume);
  auto sums = openSums(open);
  std::vector<double> areas(open.pieceCount);
  std::size_t left = 0;
  const auto& walls = closed.wallParts;
  for (std::size_t w = 0; w < walls.area.size(); ++w) {
    const auto piece = walls.piece[w];
    if (!isOpen(walls.patch[w])) {
      ASSERT_LT(left, open.wallParts.area.size());
      EXPECT_EQ(open.wallParts.piece[left], piece);
      EXPECT_EQ(open.wallParts.patch[left], walls.patch[w]);
      EXPECT_EQ(open.wallParts.area[left], walls.area[w]);
      EXPECT_EQ(open.wallParts.vector[left], walls.vector[w]);
      EXPECT_EQ(open.wallParts.centroid[left++], walls.centroid[w]);
      if (piece < open.pieceCount) areas[piece] += walls.area[w];
    } else if (piece < open.pieceCount) {
      auto& sum = sums[{piece, walls.patch[w]}];
      sum.area -= walls.area[w];
      sum.vector -= walls.vector[w];
      sum.moment -= walls.area[w] * walls.centroid[w];
    }
  }
  for (std::uint32_t p = 0; p < open.pieceCount; ++p) {
    const double face = open.faceArea(open.cells.index[open.pieces.cell[p]], 0);
    EXPECT_NEAR(open.pieces.wallArea[p], areas[p], 1e-14 * face);
  }
  for (const auto& [key, sum] : sums) {
    ASSERT_LT(key.first, open.pieceCount);
    const double face = open.faceArea(open.cells.index[open.pieces.cell[key.first]], 0);
    EXPECT_NEAR(sum.area, 0, 1e-14 * face);
    EXPECT_LT(length(sum.vector), 1e-14 * face);
    EXPECT_LT(length(sum.moment), 1e-14 * face);
  }
  std::size_t arc = 0;  // of those of the closed surface
  for (std::size_t a = 0; a < open.arcs.area.size(); ++a) {
    if (isOpenPatch(open, a)) continue;
    ASSERT_LT(arc, closed.arcs.area.size());
    EXPECT_EQ(open.arcs.area[a], closed.arcs.area[arc]);
    EXPECT_EQ(open.arcs.centroid[a], closed.arcs.centroid[arc]);
    EXPECT_EQ(open.arcs.below[a], closed.arcs.below[arc]);
    EXPECT_EQ(open.arcs.above[a], closed.arcs.above[arc]);
    EXPECT_EQ(open.arcs.cell[a], closed.arcs.cell[arc]);
    EXPECT_EQ(open.arcs.axis[a], closed.arcs.axis[arc++]);
  }
  EXPECT_EQ(arc, closed.arcs.area.size());
}

}  // namespace cutwater::test
