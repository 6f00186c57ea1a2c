// Whether the number of pieces of a cell is certain; and what is certain about leaves.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/MomentCells.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "Support/Refusal.hpp"

namespace cutwater::test {
namespace {

const Vec3<double> kMiddleOfCells{0.5, 0.5, 0.5};

Solid<double> plateOf(double thickness) {
  return Cuboid<double>({-1, -1, 0.43 - thickness / 2}, {2, 2, 0.43 + thickness / 2});
}
Solid<double> gyroidWall() {
  return TpmsSolid<double>(TpmsField<double>(TpmsPattern::gyroid(), 1), TpmsPart::Wall, 0.3);
}
std::vector<std::uint32_t> undecidedOf(const SolidCutter& cutter, const CutCells& cells,
                                       std::size_t boxes = 100'000, double width = 0.1) {
  return cutter.certified(cells, {.width = width, .boxes = boxes, .pieces = true}).undecided;
}

TEST(CertifiedPiecesTest, AreAskedForAlone) {
  const SolidCutter cutter(plateOf(0.02));
  EXPECT_TRUE(cutter.certified(cutter.cut(unitGrid(4)), {.boxes = 1}).undecided.empty());
}

TEST(CertifiedPiecesTest, ThoseOfPlainSolidsAreDecided) {
  for (const auto& solid :
       {Solid<double>(Sphere<double>({0.51, 0.49, 0.505}, 0.37)),
        Solid<double>(Torus<double>({0.513, 0.507, 0.489}, {3, -2, 4}, 0.28, 0.13)),
        plateOf(0.02)}) {
    SCOPED_TRACE(solid.describe());
    for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
      const SolidCutter cutter(solid, side);
      const auto cells = cutter.cut(unitGrid(5));
      EXPECT_TRUE(undecidedOf(cutter, cells).empty());
    }
  }
  EXPECT_EQ(check(SolidCutter(plateOf(0.02)).cut(unitGrid(6))).multiPieceCells, 36U);
  const SolidCutter walls(gyroidWall());
  const auto cells = walls.cut(GridPatch<double>{unitGrid(5).level, {{1, 0, 0}, {2, 1, 0}}});
  EXPECT_GT(check(cells).multiPieceCells, 2U);
  EXPECT_TRUE(undecidedOf(walls, cells).empty());
}

TEST(CertifiedPiecesTest, ThinnerPlatesNeedMoreBoxes) {
  const SolidCutter cutter(plateOf(0.004));
  const auto cells = cutter.cut(unitGrid(4));
  ASSERT_EQ(cells.pieceCount, 32U);
  EXPECT_EQ(undecidedOf(cutter, cells, 1000).size(), 16U);
  EXPECT_EQ(undecidedOf(cutter, cells, 300'000).size(), 0U);
}

/// Rows of one solid, where another is: what is said of it is wrong, and not taken for certain.
TEST(CertifiedPiecesTest, WrongNumbersAreNeverDecided) {
  const auto plate = plateOf(0.03);
  const auto bored = plate - Cylinder<double>({0.5, 0.5, 0}, {0.5, 0.5, 1}, 0.1);
  const auto ofPlate = SolidCutter(plate).cut(unitGrid(3));
  const auto ofBored = SolidCutter(bored).cut(unitGrid(3));
  const auto middle = ofPlate.rowOf({1, 1, 1});
  EXPECT_EQ(undecidedOf(SolidCutter(bored), ofPlate), std::vector<std::uint32_t>{middle});
  EXPECT_EQ(undecidedOf(SolidCutter(plate), ofBored), std::vector<std::uint32_t>{middle});
  EXPECT_TRUE(undecidedOf(SolidCutter(bored), ofBored).empty());
}

/// A cell with a corner and a side of fluid, joined along an edge between them, by a neck that is
/// a thousandth of the cell wide.
TEST(CertifiedPiecesTest, ANeckAlongAnEdgeIsFoundThere) {
  const SolidCutter cutter(Solid<double>(Torus<double>({0.51, 0.5, 0.49}, {1, 2, 3}, 0.3, 0.1)));
  const auto cells = cutter.cut(unitGrid(6));
  const auto row = cells.rowOf({2, 4, 2});
  EXPECT_EQ(cells.cells.firstPiece[row + 1] - cells.cells.firstPiece[row], 1U);
  EXPECT_TRUE(undecidedOf(cutter, cells).empty());
}

/// Two balls of fluid that overlap, touch within a hair, or are apart.
TEST(CertifiedPiecesTest, ANarrowNeckIsOnePieceOnceItIsSeen) {
  const auto undecided = [](double distance, std::size_t boxes) {
    const auto balls = Solid<double>(Sphere<double>({0.3, 0.52, 0.49}, 0.15)) |
                       Sphere<double>({0.3 + distance, 0.52, 0.49}, 0.15);
    const SolidCutter cutter(balls, FluidSide::Inside);
    const auto cells = cutter.cut(unitGrid(1));
    EXPECT_EQ(cells.pieceCount, distance < 0.3 ? 1U : 2U);
    return !undecidedOf(cutter, cells, boxes, 0.02).empty();
  };
  EXPECT_FALSE(undecided(0.25, 100'000));
  EXPECT_TRUE(undecided(0.299, 10'000));
  EXPECT_TRUE(undecided(0.302, 10'000));
  EXPECT_FALSE(undecided(0.36, 100'000));
}

TEST(CertifiedPiecesTest, NothingIsDecidedWithoutAGuarantee) {
  const FunctionSDF function(
      [](const Vec3<double>& p) { return 5 * (lengthSquared(p - kMiddleOfCells) - 0.1369); },
      Guarantee<double>{.lipschitz = std::nullopt, .continuous = true, .size = 1});
  const SolidCutter cutter{Solid<double>(function)};
  const auto cells = cutter.cut(unitGrid(4));
  EXPECT_EQ(undecidedOf(cutter, cells, 10'000).size(), cells.cellCount);
}

TEST(CertifiedLeavesTest, AreThoseOfTheGridOnOneLevel) {
  const SolidCutter cutter(gyroidWall());
  std::vector<OctreeCell> leaves;
  std::mt19937 random(3);
  addRandomLeaves(random, {}, 0, 2, 100, leaves);
  const Mesh mesh(OctreeDomain<double>({0.01, 0.02, 0.03}, 1, {1, 1, 1}), 2, leaves);
  const CertifyOptions options{.width = 0.2, .pieces = true};
  const auto cut = cutter.cut(mesh);
  const auto cells = cutter.cut(finestOf(mesh));
  const auto ofLeaves = cutter.certified(cut, mesh, options);
  const auto ofCells = cutter.certified(cells, options);
  EXPECT_TRUE(ofLeaves.doubtful.empty());
  ASSERT_EQ(ofLeaves.volumeFraction.size(), cells.cellCount);
  for (std::size_t row = 0; row < cells.cellCount; ++row) {
    const auto same = cells.rowOf(mesh.cells()[cut.cut.leaf[row]].index);
    EXPECT_EQ(ofLeaves.volumeFraction[row], ofCells.volumeFraction[same]);
  }
  ASSERT_EQ(ofLeaves.aperture.size(), cut.arcs.area.size());
  std::size_t compared = 0;
  for (std::size_t arc = 0; arc < cut.arcs.area.size(); ++arc) {
    const auto same = std::ranges::find(cells.arcs.centroid, cut.arcs.centroid[arc]);
    if (same == cells.arcs.centroid.end()) continue;
    EXPECT_EQ(ofLeaves.aperture[arc],
              ofCells.aperture[static_cast<std::size_t>(same - cells.arcs.centroid.begin())]);
    ++compared;
  }
  EXPECT_GT(compared, ofLeaves.aperture.size() / 2);
}

TEST(CertifiedLeavesTest, EncloseWhatIsFound) {
  std::mt19937 random(11);
  for (const auto& solid : {gyroidWall(), plateOf(0.001)}) {
    const SolidCutter cutter(solid);
    const auto mesh = dividedMesh(random, 3, 0.013, 1, 70);
    const auto leaves = cutter.cut(mesh);
    const auto certified = cutter.certified(leaves, mesh, {.width = 0.2, .boxes = 50'000});
    EXPECT_TRUE(certified.doubtful.empty());
    std::vector<double> shares(leaves.cut.leaf.size());
    for (std::uint32_t p = 0; p < leaves.pieces.cell.size(); ++p) {
      shares[leaves.pieces.cell[p]] += leaves.volumeFraction(p);
    }
    for (std::size_t row = 0; row < shares.size(); ++row) {
      const double error = leaves.cut.error[row] + 1e-12;
      EXPECT_GE(shares[row], certified.volumeFraction[row].lower - error);
      EXPECT_LE(shares[row], certified.volumeFraction[row].upper + error);
      EXPECT_LE(certified.volumeFraction[row].upper - certified.volumeFraction[row].lower, 0.2001);
    }
    for (std::uint32_t arc = 0; arc < leaves.arcs.area.size(); ++arc) {
      EXPECT_LE(leaves.aperture(arc), certified.aperture[arc].upper + 1e-5);
      EXPECT_LE(certified.aperture[arc].upper - certified.aperture[arc].lower, 0.2001);
    }
  }
}

TEST(CertifiedLeavesTest, AnotherOctreeIsRefused) {
  std::mt19937 random(5);
  const SolidCutter cutter(gyroidWall());
  const auto mesh = dividedMesh(random, 3, 0, 1);
  auto fewer = cutter.cut(mesh);
  fewer.classes.pop_back();
  EXPECT_NE(refusal([&] { (void)cutter.certified(fewer, mesh); }).find("need the mesh"),
            std::string::npos);
}

}  // namespace
}  // namespace cutwater::test
