#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <algorithm>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

namespace cutwater::test {

/// Expects that the leaves of an octree of one level have the rows of its cells, to the bit.
inline void expectRowsOfGrid(const CutLeaves& leaves, const OctreeCells<double>& mesh,
                             const CutCells& cells) {
  ASSERT_EQ(leaves.cut.leaf.size(), cells.cellCount);
  ASSERT_EQ(leaves.pieces.cell.size(), cells.pieceCount);
  const auto indexOf = [&](std::uint32_t leaf) { return mesh.cells()[leaf].index; };
  std::map<std::uint32_t, std::uint32_t> partners{{CutLeaves::kWholeCell, CutCells::kWholeCell}};
  for (std::uint32_t row = 0; row < leaves.cut.leaf.size(); ++row) {
    const auto same = cells.rowOf(indexOf(leaves.cut.leaf[row]));
    ASSERT_NE(same, CutCells::kNoRow);
    EXPECT_EQ(leaves.cut.fluidCorners[row], cells.cells.fluidCorners[same]);
    EXPECT_EQ(leaves.cut.meets[row], cells.cells.meets[same]);
    EXPECT_EQ(leaves.cut.wallFaces[row], cells.cells.wallFaces[same]);
    auto q = cells.cells.firstPiece[same];
    for (auto p = leaves.cut.firstPiece[row]; p < leaves.cut.firstPiece[row + 1]; ++p, ++q) {
      EXPECT_EQ(leaves.pieces.volume[p], cells.pieces.volume[q]);
      EXPECT_EQ(leaves.pieces.centroid[p], cells.pieces.centroid[q]);
      EXPECT_EQ(leaves.pieces.wallArea[p], cells.pieces.wallArea[q]);
      EXPECT_EQ(leaves.pieces.wallVector[p], cells.pieces.wallVector[q]);
      EXPECT_EQ(leaves.pieces.wallCentroid[p], cells.pieces.wallCentroid[q]);
      EXPECT_EQ(leaves.pieces.wallFaces[p], cells.pieces.wallFaces[q]);
      EXPECT_EQ(leaves.volumeFraction(p), cells.volumeFraction(q));
      partners[p] = q;
    }
    EXPECT_EQ(q, cells.cells.firstPiece[same + 1]);
  }
  ASSERT_EQ(leaves.arcs.area.size(), cells.arcs.area.size());
  using Key = std::tuple<int, int, int, int, std::uint32_t, std::uint32_t, double>;
  std::map<Key, Vec3<double>> expected;
  for (std::uint32_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto& cell = cells.arcs.cell[a];
    const auto known = [&](const Index3& at, std::uint32_t piece) {
      return cells.grid.indices().contains(at) ? piece : CutCells::kBeyond;
    };
    expected[{cell.i, cell.j, cell.k, cells.arcs.axis[a],
              known(cells.arcs.cellBelow(a), cells.arcs.below[a]), known(cell, cells.arcs.above[a]),
              cells.aperture(a)}] = cells.arcs.centroid[a];
  }
  partners[CutLeaves::kBeyond] = CutCells::kBeyond;
  for (std::uint32_t a = 0; a < leaves.arcs.area.size(); ++a) {
    const auto axis = int{leaves.arcs.axis[a]};
    auto cell = indexOf(std::min(leaves.arcs.leafAbove[a], leaves.arcs.leafBelow[a]));
    if (leaves.arcs.leafAbove[a] == CutLeaves::kNoLeaf) {
      ++(axis == 0 ? cell.i : axis == 1 ? cell.j : cell.k);
    } else {
      cell = indexOf(leaves.arcs.leafAbove[a]);
    }
    const auto found =
        expected.find({cell.i, cell.j, cell.k, axis, partners.at(leaves.arcs.below[a]),
                       partners.at(leaves.arcs.above[a]), leaves.aperture(a)});
    ASSERT_NE(found, expected.end());
    EXPECT_EQ(found->second, leaves.arcs.centroid[a]);
  }
}

}  // namespace cutwater::test
