#pragma once

#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

namespace cutwater::test {

/// What the leaves of a mesh are by the cells of its finest level: pieces of these are one where
/// open faces connect them within a leaf.
class JoinedCells {
 public:
  /// Numbers within `near` of each other are the same.
  JoinedCells(const CutCells& fine, const OctreeCells<double>& mesh, double near = 1e-13)
      : fine_(fine), box_(fine.grid.indices()), near_(near) {
    leafOf_.resize(box_.count());
    for (std::uint32_t leaf = 0; leaf < mesh.cells().size(); ++leaf) {
      const auto& [index, level, kind] = mesh.cells()[leaf];
      const int shift = mesh.deepest() - level;
      const int width = 1 << shift;
      for (int n = 0; n < width * width * width; ++n) {
        leafOf_[numberOf({(index.i << shift) + n % width, (index.j << shift) + n / width % width,
                          (index.k << shift) + n / width / width})] = leaf;
      }
    }
    join();
    sum(mesh.cells().size());
  }

  void expectSame(const CutLeaves& leaves) {
    for (std::uint32_t leaf = 0; leaf < groups_.size() && !::testing::Test::HasFailure(); ++leaf) {
      matchLeaf(leaves, leaf);
    }
    if (!::testing::Test::HasFailure()) expectSameArcs(leaves);
  }
  [[nodiscard]] std::size_t splitLeaves() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(groups_, [](const auto& groups) { return groups.size() > 1; }));
  }

 private:
  struct Sum {
    double volume = 0;
    Vec3<double> moment;
    double wall = 0;
    Vec3<double> wallVector;
  };
  using Key = std::tuple<std::uint32_t, std::uint32_t, int, std::uint32_t, std::uint32_t>;

  [[nodiscard]] std::size_t numberOf(const Index3& cell) const {
    return (static_cast<std::size_t>(cell.k) * box_.length(1) + static_cast<std::size_t>(cell.j)) *
               box_.length(0) +
           static_cast<std::size_t>(cell.i);
  }
  [[nodiscard]] std::uint32_t leafOf(const Index3& cell) const {
    return box_.contains(cell) ? leafOf_[numberOf(cell)] : CutLeaves::kNoLeaf;
  }
  [[nodiscard]] std::uint32_t nodeOf(const Index3& cell, std::uint32_t piece) const {
    if (!box_.contains(cell)) return CutLeaves::kBeyond;
    if (piece != CutCells::kWholeCell) return piece;
    return static_cast<std::uint32_t>(fine_.pieceCount + numberOf(cell));
  }

  /// Calls visit(cell below, cell above, axis, node below, node above, area, centroid).
  template <typename Visit>
  void forFaces(const Visit& visit) const {
    for (std::size_t a = 0; a < fine_.arcs.area.size(); ++a) {
      const auto below = fine_.arcs.cellBelow(a);
      const auto& above = fine_.arcs.cell[a];
      visit(below, above, int{fine_.arcs.axis[a]}, nodeOf(below, fine_.arcs.below[a]),
            nodeOf(above, fine_.arcs.above[a]), fine_.arcs.area[a], fine_.arcs.centroid[a]);
    }
    forWholeFaces(visit);
  }
  /// Those of cells that are all fluid: no arc says that they are open.
  template <typename Visit>
  void forWholeFaces(const Visit& visit) const {
    for (int n = 0; n < static_cast<int>(box_.count()); ++n) {
      const auto x = static_cast<int>(box_.length(0));
      const auto y = static_cast<int>(box_.length(1));
      const Index3 cell{n % x, n / x % y, n / x / y};
      if (fine_.classOf(cell) != FluidClass::Fluid) continue;
      for (const int face : {0, 1, 2, 3, 4, 5})
        visitWholeFace(visit, cell, face / 2, face % 2 == 1);
    }
  }
  template <typename Visit>
  void visitWholeFace(const Visit& visit, const Index3& cell, int axis, bool isHigh) const {
    auto other = cell;
    (axis == 0 ? other.i : axis == 1 ? other.j : other.k) += isHigh ? 1 : -1;
    if (box_.contains(other) && (!isHigh || fine_.rowOf(other) != CutCells::kNoRow)) return;
    const auto box = fine_.boxOf(cell);
    auto centroid = box.center();
    centroid[axis] = isHigh ? box.upper[axis] : box.lower[axis];
    const auto& below = isHigh ? cell : other;
    const auto& above = isHigh ? other : cell;
    visit(below, above, axis, nodeOf(below, CutCells::kWholeCell),
          nodeOf(above, CutCells::kWholeCell), fine_.faceArea(cell, axis), centroid);
  }

  void join() {
    sets_.reset(fine_.pieceCount + box_.count());
    forFaces([&](const Index3& below, const Index3& above, int, std::uint32_t a, std::uint32_t b,
                 double, const Vec3<double>&) {
      if (leafOf(below) == leafOf(above)) sets_.unite(a, b);
    });
  }

  void sum(std::size_t leafCount) {
    groups_.resize(leafCount);
    for (std::uint32_t p = 0; p < fine_.pieceCount; ++p) {
      auto& sum = groups_[leafOf(fine_.cells.index[fine_.pieces.cell[p]])][sets_.find(p)];
      sum.volume += fine_.pieces.volume[p];
      sum.moment += fine_.pieces.volume[p] * fine_.pieces.centroid[p];
      sum.wall += fine_.pieces.wallArea[p];
      sum.wallVector += fine_.pieces.wallVector[p];
    }
    for (int n = 0; n < static_cast<int>(box_.count()); ++n) {
      const auto x = static_cast<int>(box_.length(0));
      const auto y = static_cast<int>(box_.length(1));
      const Index3 cell{n % x, n / x % y, n / x / y};
      if (fine_.classOf(cell) != FluidClass::Fluid) continue;
      auto& sum = groups_[leafOf(cell)][sets_.find(nodeOf(cell, CutCells::kWholeCell))];
      sum.volume += fine_.cellVolume(cell);
      sum.moment += fine_.cellVolume(cell) * fine_.boxOf(cell).center();
    }
  }

  void matchLeaf(const CutLeaves& leaves, std::uint32_t leaf) {
    const auto row = leaves.rowOf(leaf);
    const auto& groups = groups_[leaf];
    if (row == CutLeaves::kNoRow) {
      const bool isFluid = leaves.classes[leaf] == FluidClass::Fluid;
      ASSERT_EQ(groups.size(), isFluid ? 1U : 0U) << leaf;
      for (const auto& [root, sum] : groups) {
        partners_[root] = CutLeaves::kWholeCell;
        EXPECT_EQ(sum.wall, 0);
      }
      return;
    }
    ASSERT_EQ(leaves.cut.firstPiece[row + 1] - leaves.cut.firstPiece[row], groups.size()) << leaf;
    for (const auto& [root, sum] : groups) {
      auto found = CutLeaves::kNoRow;
      for (auto p = leaves.cut.firstPiece[row]; p < leaves.cut.firstPiece[row + 1]; ++p) {
        if (std::abs(leaves.pieces.volume[p] - sum.volume) < near_ &&
            length(leaves.pieces.volume[p] * leaves.pieces.centroid[p] - sum.moment) < near_ &&
            std::abs(leaves.pieces.wallArea[p] - sum.wall) < near_ &&
            length(leaves.pieces.wallVector[p] - sum.wallVector) < near_) {
          found = p;
        }
      }
      ASSERT_NE(found, CutLeaves::kNoRow) << "leaf " << leaf;
      partners_[root] = found;
    }
  }

  void expectSameArcs(const CutLeaves& leaves) {
    std::map<Key, std::pair<double, Vec3<double>>> expected;
    std::map<Key, std::pair<double, Vec3<double>>> found;
    forFaces([&](const Index3& below, const Index3& above, int axis, std::uint32_t a,
                 std::uint32_t b, double area, const Vec3<double>& centroid) {
      if (leafOf(below) == leafOf(above)) return;
      const auto pieceOf = [&](std::uint32_t node) {
        return node == CutLeaves::kBeyond ? node : partners_.at(sets_.find(node));
      };
      const auto pieces = std::pair(pieceOf(a), pieceOf(b));
      if (std::min(pieces.first, pieces.second) >= leaves.pieces.cell.size()) return;
      // Beyond an open patch, there is no leaf.
      const auto leafBeside = [&](const Index3& cell, std::uint32_t node) {
        return node == CutLeaves::kBeyond ? CutLeaves::kNoLeaf : leafOf(cell);
      };
      auto& sum =
          expected[{leafBeside(below, a), leafBeside(above, b), axis, pieces.first, pieces.second}];
      sum.first += area;
      sum.second += area * centroid;
    });
    const auto& arcs = leaves.arcs;
    for (std::size_t i = 0; i < arcs.area.size(); ++i) {
      auto& sum =
          found[{arcs.leafBelow[i], arcs.leafAbove[i], arcs.axis[i], arcs.below[i], arcs.above[i]}];
      sum.first += arcs.area[i];
      sum.second += arcs.area[i] * arcs.centroid[i];
    }
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [key, sum] : expected) {
      const auto same = found.find(key);
      ASSERT_NE(same, found.end());
      EXPECT_NEAR(same->second.first, sum.first, near_);
      EXPECT_LT(length(same->second.second - sum.second), near_);
    }
  }

  const CutCells& fine_;
  IndexBox box_;
  double near_;
  std::vector<std::uint32_t> leafOf_;
  detail::DisjointSets sets_;                         // of pieces, then of all cells
  std::vector<std::map<std::uint32_t, Sum>> groups_;  // of each leaf, by root
  std::map<std::uint32_t, std::uint32_t> partners_;   // of roots: a piece, or kWholeCell
};

}  // namespace cutwater::test
