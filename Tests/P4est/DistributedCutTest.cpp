#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/P4est/DistributedOctree.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <array>
#include <map>

#include "Ranks.hpp"

namespace cutwater::test {
namespace {

/// What is said of a leaf, a piece, a part of a wall or an arc.
using Row = std::vector<double>;

void add(Row& row, const Vec3<double>& p) {
  row.insert(row.end(), {p.x, p.y, p.z});
}
template <typename Value>
void add(Row& row, std::span<const Value> values) {
  for (const auto& value : values) {
    if constexpr (std::is_same_v<Value, Vec3<double>>) {
      add(row, value);
    } else {
      row.push_back(value);
    }
  }
}

/// Rows of cut leaves by the numbers of all leaves.
class Rows {
 public:
  Rows(const CutLeaves& leaves, std::uint64_t first, std::span<const DistributedCut::Rim> rims)
      : leaves_(leaves), first_(first) {
    for (const auto& rim : rims) rims_[rim.arc] = rim;
  }

  [[nodiscard]] std::vector<Row> pieces() const {
    std::vector<Row> rows;
    const auto& of = leaves_.pieces;
    for (std::uint32_t p = 0; p < of.cell.size(); ++p) {
      Row row{numberOf(leaves_.cut.leaf[of.cell[p]]), pieceOf(p), of.volume[p], of.wallArea[p],
              static_cast<double>(leaves_.cut.fluidCorners[of.cell[p]])};
      for (const auto& v : {of.centroid[p], of.wallVector[p], of.wallCentroid[p],
                            leaves_.cut.box[of.cell[p]].lower, leaves_.cut.box[of.cell[p]].upper}) {
        add(row, v);
      }
      add(row, leaves_.moments.ofVolume(p));
      add(row, leaves_.moments.ofWall(p));
      add(row, leaves_.moments.ofWallVector(p));
      rows.push_back(std::move(row));
    }
    return rows;
  }
  [[nodiscard]] std::vector<Row> walls() const {
    std::vector<Row> rows;
    const auto& of = leaves_.wallParts;
    for (std::size_t w = 0; w < of.piece.size(); ++w) {
      const auto leaf = leaves_.cut.leaf[leaves_.pieces.cell[of.piece[w]]];
      Row row{numberOf(leaf), pieceOf(of.piece[w]), static_cast<double>(of.patch[w]), of.area[w]};
      add(row, of.vector[w]);
      add(row, of.centroid[w]);
      for (auto n = leaves_.firstWallPolygon[w]; n < leaves_.firstWallPolygon[w + 1]; ++n) {
        add(row, leaves_.wallPolygons.of(n));
      }
      rows.push_back(std::move(row));
    }
    return rows;
  }
  [[nodiscard]] std::vector<Row> arcs() const {
    std::vector<Row> rows;
    const auto& of = leaves_.arcs;
    for (std::uint32_t a = 0; a < of.area.size(); ++a) {
      Row row{static_cast<double>(of.axis[a]), of.area[a], of.faceArea[a]};
      addSide(a, of.leafBelow[a], of.below[a], row);
      addSide(a, of.leafAbove[a], of.above[a], row);
      add(row, of.centroid[a]);
      add(row, leaves_.moments.ofArc(a));
      add(row, leaves_.arcPolygons.of(a));
      rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  [[nodiscard]] double numberOf(std::uint32_t leaf) const {
    return static_cast<double>(first_ + leaf);
  }
  /// Within its leaf.
  [[nodiscard]] double pieceOf(std::uint32_t piece) const {
    return static_cast<double>(piece - leaves_.cut.firstPiece[leaves_.pieces.cell[piece]]);
  }
  void addSide(std::uint32_t arc, std::uint32_t leaf, std::uint32_t piece, Row& row) const {
    const auto rim = rims_.find(arc);
    if (leaf == CutLeaves::kNoLeaf && rim != rims_.end()) {
      row.insert(row.end(),
                 {static_cast<double>(rim->second.leaf), static_cast<double>(rim->second.piece)});
    } else if (piece < leaves_.pieces.cell.size()) {
      row.insert(row.end(), {numberOf(leaf), pieceOf(piece)});
    } else {
      const bool isThere = leaf != CutLeaves::kNoLeaf;
      row.insert(row.end(), {isThere ? numberOf(leaf) : -1, static_cast<double>(piece)});
    }
  }

  const CutLeaves& leaves_;
  std::uint64_t first_;
  std::map<std::uint32_t, DistributedCut::Rim> rims_;
};

/// Those of all ranks.
std::vector<Row> gatheredRows(const std::vector<Row>& own) {
  std::vector<double> flat;
  for (const auto& row : own) {
    flat.push_back(static_cast<double>(row.size()));
    flat.insert(flat.end(), row.begin(), row.end());
  }
  const auto all = gathered(std::span<const double>(flat));
  std::vector<Row> rows;
  for (auto at = all.begin(); at != all.end();) {
    const auto size = static_cast<std::ptrdiff_t>(*at++);
    rows.emplace_back(at, at + size);
    at += size;
  }
  return rows;
}

Solid<double> turnedTorus() {
  Solid<double> solid(MeshSDF<double>(tessellation::torus(0.3, 0.1, 40, 20)));
  solid.rotate(33.0, Vec3<double>{1, 2, 3});
  solid.translate({0.51, 0.49, 0.47});
  return solid;
}

/// Some that refine only part of what is cut, so that faces between levels are in the surface.
const Refinement<double>& rules() {
  static const Refinement<double> rules = [] {
    Refinement<double> some;
    some.cut = 1;
    some.curvature = {20, 3};
    return some;
  }();
  return rules;
}

void expectSameCut(const OctreeDomain<double>& domain, Balance balance, FluidSide side) {
  const auto solid = turnedTorus();
  const CellCutter cutter(solid, side);
  const DistributedOctree<double> mesh(solid, domain, rules(), MPI_COMM_WORLD,
                                       {.balance = balance});
  const auto own = mesh.cut(cutter, {.polygons = true, .moments = 2, .threads = 1});
  const auto found = check(own.leaves);
  EXPECT_EQ(found.lostPieces, 0U);
  EXPECT_EQ(found.outOfRange, 0U);
  EXPECT_LT(found.worstClosure, 1e-13);
  EXPECT_LT(found.worstMoments, 1e-13);
  std::array sums{found.fluidVolume, found.bodyVolume, found.wallArea};
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), 3, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  const Rows rows(own.leaves, mesh.firstNumber(), own.rims);
  const auto pieces = gatheredRows(rows.pieces());
  const auto walls = gatheredRows(rows.walls());
  auto arcs = gatheredRows(rows.arcs());
  const auto classes = gathered(std::span<const FluidClass>(own.leaves.classes));
  const auto rims = gathered(std::span<const DistributedCut::Rim>(own.rims));
  if (ownRank() != 0) return;

  const Octree<double> octree(solid, domain, rules(), {.balance = balance});
  const auto all = cutter.cut(octree, {.polygons = true, .moments = 2});
  const Rows expected(all, 0, {});
  EXPECT_EQ(classes, all.classes);
  EXPECT_EQ(pieces, expected.pieces());
  EXPECT_EQ(walls, expected.walls());
  // Both ranks have an arc between pieces of theirs.
  const auto count = arcs.size();
  std::ranges::sort(arcs);
  arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());
  auto expectedArcs = expected.arcs();
  std::ranges::sort(expectedArcs);
  EXPECT_EQ(arcs, expectedArcs);
  const auto isPiece = [](const auto& rim) { return rim.piece != CutLeaves::kWholeCell; };
  EXPECT_EQ(count - arcs.size(),
            static_cast<std::size_t>(std::ranges::count_if(rims, isPiece)) / 2);
  EXPECT_EQ(rims.empty(), rankCount() == 1);
  const auto whole = check(all);
  EXPECT_NEAR(sums[0], whole.fluidVolume, 1e-12);
  EXPECT_NEAR(sums[1], whole.bodyVolume, 1e-12);
  EXPECT_NEAR(sums[2], whole.wallArea, 1e-12);
}

TEST(DistributedCutTest, IsThatOfOneProcess) {
  const OctreeDomain<double> brick({0.01, -0.02, 0.03}, 0.26, {4, 4, 3});
  for (const auto balance : {Balance::Corner, Balance::Edge, Balance::Face}) {
    expectSameCut(brick, balance, FluidSide::Outside);
  }
  expectSameCut(OctreeDomain<double>({0, 0, 0}, 1, {1, 1, 1}), Balance::Corner, FluidSide::Inside);
}

TEST(DistributedCutTest, TellsOfOtherRanks) {
  const auto hull = turnedTorus();
  const OctreeDomain<double> domain({0, 0, 0}, 1, {1, 1, 1});
  const DistributedOctree<double> mesh(hull, domain, rules(), MPI_COMM_WORLD);
  std::size_t used = 0;
  const auto useRim = [&](double area, std::uint64_t leaf, std::uint32_t) {
    const bool isOwn =
        leaf >= mesh.firstNumber() && leaf - mesh.firstNumber() < mesh.local().cells().size();
    EXPECT_FALSE(isOwn);
    EXPECT_LT(leaf, mesh.cellCount());
    EXPECT_GE(area, 0);
    ++used;
  };
  // [DOCS
  const DistributedCut own = mesh.cut(CellCutter(hull));  // on all ranks
  for (const auto& [arc, leaf, piece] : own.rims) useRim(own.leaves.arcs.area[arc], leaf, piece);
  // DOCS]
  EXPECT_EQ(used, own.rims.size());
}

TEST(DistributedCutTest, FewerLeavesThanRanks) {
  const auto solid = turnedTorus();
  const OctreeDomain<double> domain({0, 0, 0}, 1, {1, 1, 1});
  const DistributedOctree<double> mesh(solid, domain, {}, MPI_COMM_WORLD);
  const auto own = mesh.cut(CellCutter(solid));
  EXPECT_EQ(own.leaves.classes.size(), mesh.local().cells().size());
  EXPECT_EQ(own.leaves.cut.leaf.size(), mesh.local().cells().size());
  EXPECT_TRUE(own.rims.empty());
  EXPECT_LT(check(own.leaves).worstClosure, 1e-13);
}

TEST(DistributedCutTest, NeedsABalancedMesh) {
  const auto solid = turnedTorus();
  const OctreeDomain<double> domain({0, 0, 0}, 1, {1, 1, 1});
  const DistributedOctree<double> mesh(solid, domain, rules(), MPI_COMM_WORLD,
                                       {.balance = Balance::None});
  expectAgreedError(ErrorKind::Argument, [&] { static_cast<void>(mesh.cut(CellCutter(solid))); });
  const DistributedOctree<double> balanced(solid, domain, rules(), MPI_COMM_WORLD);
  expectAgreedError(ErrorKind::Argument,
                    [&] { static_cast<void>(balanced.cut(CellCutter(solid), {.moments = 9})); });
}

}  // namespace
}  // namespace cutwater::test
