#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "Support/CutIdentities.hpp"
#include "Support/DamagedSoups.hpp"
#include "Support/Grid.hpp"
#include "Support/Scale.hpp"
#include "Support/Shells.hpp"

namespace cutwater::test {
namespace {

Solid<double> torus() {
  Solid<double> solid(MeshSDF<double>(tessellation::torus(0.3, 0.1, 40, 20)));
  solid.rotate(33.0, Vec3<double>{1, 2, 3});
  solid.translate({0.51, 0.49, 0.47});
  return solid;
}

GridPatch<double> unitCube(int n) {
  return {Level<double>({0, 0, 0}, {1.0 / n, 1.0 / n, 1.0 / n}), IndexBox::ofSize(n, n, n)};
}

TEST(CellCutterTest, CellsTogetherAreTheSurface) {
  const auto solid = torus();
  const auto& mesh = *solid.as<MeshSDF<double>>();
  const double volume = volumeOf(mesh.soup());
  const double area = areaOf(mesh.soup());
  const CellCutter cutter(solid);
  for (const int n : {1, 2, 7, 16, 40}) {
    const auto cells = cutter.cut(unitCube(n));
    expectIdentities(cells, 1e-14);
    const auto report = check(cells);
    EXPECT_NEAR(report.bodyVolume, volume, 1e-14);
    EXPECT_NEAR(report.fluidVolume, 1 - volume, 1e-14);
    EXPECT_NEAR(report.wallArea, area, 1e-12);
    EXPECT_EQ(report.cutCells, cells.cellCount);
  }
}

TEST(CellCutterTest, FluidAndBodyFillEveryCell) {
  const auto solid = torus();
  const auto outside = CellCutter(solid, FluidSide::Outside).cut(unitCube(20));
  const auto inside = CellCutter(solid, FluidSide::Inside).cut(unitCube(20));
  ASSERT_EQ(outside.cellCount, inside.cellCount);
  for (std::size_t row = 0; row < outside.cellCount; ++row) {
    ASSERT_EQ(outside.cells.index[row], inside.cells.index[row]);
    double sum = 0;
    for (const auto* cells : {&outside, &inside}) {
      for (auto p = cells->cells.firstPiece[row]; p < cells->cells.firstPiece[row + 1]; ++p) {
        sum += cells->pieces.volume[p];
      }
    }
    EXPECT_NEAR(sum * 8000, 1, 1e-14);
  }
  const auto report = check(inside);
  EXPECT_NEAR(report.fluidVolume, check(outside).bodyVolume, 1e-14);
  expectIdentities(inside, 1e-14);
}

TEST(CellCutterTest, ClassesAreThoseOfTheSolid) {
  const auto solid = torus();
  const auto patch = unitCube(24);
  const auto cells = CellCutter(solid).cut(patch);
  std::map<FluidClass, int> count;
  for (std::int32_t k = 0; k < 24; ++k) {
    for (std::int32_t j = 0; j < 24; ++j) {
      for (std::int32_t i = 0; i < 24; ++i) {
        const auto found = cells.classOf({i, j, k});
        const auto expected = solid.classify(patch.level.cell({i, j, k}));
        ++count[found];
        EXPECT_EQ(found == FluidClass::Cut, expected == BoxClass::Cut);
        EXPECT_EQ(found == FluidClass::Fluid, expected == BoxClass::Outside);
        EXPECT_EQ(found == FluidClass::Body, expected == BoxClass::Inside);
      }
    }
  }
  EXPECT_GT(count[FluidClass::Body], 10);
}

/// Everything about a piece but its row.
using PieceKey = std::tuple<double, double, double, double, double, double, double>;
PieceKey keyOf(const CutCells& cells, std::uint32_t piece) {
  const auto& centroid = cells.pieces.centroid[piece];
  const auto& vector = cells.pieces.wallVector[piece];
  return {
      cells.pieces.volume[piece], centroid.x, centroid.y, centroid.z, vector.x, vector.y, vector.z};
}
using Place = std::tuple<int, int, int>;
Place placeOf(const Index3& index) {
  return {index.i, index.j, index.k};
}

/// Whatever is known about a cell, including the pieces beyond its faces.
struct KnownCells {
  std::map<Place, std::vector<PieceKey>> pieces;
  std::map<std::tuple<Place, int, PieceKey>, std::vector<std::pair<double, PieceKey>>> arcs;

  explicit KnownCells(const CutCells& cells) {
    for (std::size_t row = 0; row < cells.cellCount; ++row) {
      auto& list = pieces[placeOf(cells.cells.index[row])];
      for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
        list.push_back(keyOf(cells, p));
      }
    }
    const auto key = [&](std::uint32_t piece) {
      return piece == CutCells::kWholeCell ? PieceKey{} : keyOf(cells, piece);
    };
    for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
      for (const bool isBelow : {true, false}) {
        const auto own = isBelow ? cells.arcs.below[a] : cells.arcs.above[a];
        const auto other = isBelow ? cells.arcs.above[a] : cells.arcs.below[a];
        if (own >= cells.pieceCount) continue;
        const auto place = placeOf(cells.cells.index[cells.pieces.cell[own]]);
        const int face = 2 * cells.arcs.axis[a] + (isBelow ? 1 : 0);
        arcs[{place, face, key(own)}].emplace_back(cells.arcs.area[a], key(other));
      }
    }
  }
};

/// Its triangles are longer than tiles of cells.
Solid<double> turnedBox() {
  Solid<double> solid(MeshSDF<double>(tessellation::box({-0.3, -0.2, -0.35}, {0.3, 0.2, 0.35})));
  solid.rotate(33, Vec3<double>{1, 2, 3});
  solid.translate({0.51, 0.49, 0.47});
  return solid;
}

void expectTheSameEverywhere(const Solid<double>& solid) {
  const CellCutter cutter(solid);
  const auto patch = unitCube(29);
  const KnownCells whole(cutter.cut(patch, {.threads = 1}));
  const KnownCells parallel(cutter.cut(patch, {.threads = 4}));
  EXPECT_EQ(whole.pieces, parallel.pieces);
  EXPECT_EQ(whole.arcs, parallel.arcs);
  std::mt19937 random(1);
  std::size_t compared = 0;
  for (int n = 0; n < scaled(60); ++n) {
    const auto box = randomBox(29, random);
    const KnownCells part(cutter.cut(GridPatch<double>{patch.level, box}));
    for (const auto& [place, pieces] : part.pieces) {
      EXPECT_EQ(pieces, whole.pieces.at(place));
      ++compared;
    }
    for (const auto& [key, arcs] : part.arcs) EXPECT_EQ(arcs, whole.arcs.at(key));
  }
  EXPECT_GT(compared, 1000U);
}

TEST(CellCutterTest, ACellIsTheSameInEveryBoxAndWithAnyNumberOfThreads) {
  expectTheSameEverywhere(torus());
  expectTheSameEverywhere(turnedBox());
}

TEST(CellCutterTest, SoIsOneInWhichTheSurfaceMeetsItself) {
  const auto ring = triangulated(tessellation::torus(0.3, 0.1, 40, 20));
  const auto ball = moved(tessellation::icosphere(0.2, 2), {0.27, 0.05, 0.03});
  Solid<double> solid{MeshSDF<double>(joined({ring, ball}))};
  solid.translate({0.41, 0.49, 0.47});
  EXPECT_GT(check(CellCutter(solid).cut(unitCube(29))).meetingCells, 50U);
  expectTheSameEverywhere(solid);
}

TEST(CellCutterTest, MillionsOfDiagonalsAwayIsAsGoodAsHere) {
  // Multiples of 2^-20, so that nothing is rounded when it is moved.
  auto soup = tessellation::torus(0.3, 0.1, 40, 20);
  for (auto& p : soup.points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * 0x1p20) * 0x1p-20 + 0.5;
  }
  const auto here = CellCutter(Solid<double>(MeshSDF<double>(soup))).cut(unitCube(16));
  const double far = 0x1p30;
  for (auto& p : soup.points) p += {far, -far, far};
  const Level<double> level({far, -far, far}, {1.0 / 16, 1.0 / 16, 1.0 / 16});
  const MeshSDF<double> mesh(soup);
  const auto there =
      CellCutter(Solid<double>(mesh)).cut(GridPatch<double>{level, IndexBox::ofSize(16, 16, 16)});
  expectIdentities(there, 1e-14);
  ASSERT_EQ(here.pieceCount, there.pieceCount);
  EXPECT_NEAR(check(there).bodyVolume, volumeOf(mesh.soup()), 1e-14);
  for (std::size_t p = 0; p < here.pieceCount; ++p) {
    EXPECT_NEAR(here.pieces.volume[p], there.pieces.volume[p], 1e-18);
  }
}

TEST(CellCutterTest, OnlyCellsWithAWallAreCutAtABoxInPlanesOfTheGrid) {
  const auto soup = tessellation::box({0.25, 0.25, 0.25}, {0.5, 0.75, 0.625});
  const Solid<double> solid{MeshSDF<double>(soup)};
  const auto cells = CellCutter(solid).cut(unitCube(8));
  expectIdentities(cells, 1e-14);
  EXPECT_EQ(cells.cellCount, 2U * (2 * 4 + 2 * 3 + 4 * 3));
  EXPECT_EQ(check(cells).bodyVolume, 0.25 * 0.5 * 0.375);
  EXPECT_EQ(check(cells).wallArea, 2 * (0.25 * 0.5 + 0.25 * 0.375 + 0.5 * 0.375));
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) EXPECT_EQ(cells.volumeFraction(p), 1);
  EXPECT_EQ(cells.classOf({2, 2, 2}), FluidClass::Body);
  EXPECT_EQ(cells.classOf({1, 1, 2}), FluidClass::Fluid);  // touches an edge of the box
  EXPECT_EQ(cells.classOf({1, 2, 2}), FluidClass::Cut);
}

TEST(CellCutterTest, KnowsWhichCornersAreInTheFluid) {
  const auto solid = torus();
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto cells = CellCutter(solid, side).cut(unitCube(12));
    std::size_t thin = 0;
    for (std::size_t row = 0; row < cells.cellCount; ++row) {
      const auto box = cells.boxOf(cells.cells.index[row]);
      unsigned expected = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const bool isInside = solid.signedDistance(box.corner(corner)) < 0;
        if (isInside == (side == FluidSide::Inside))
          expected |= 1U << static_cast<unsigned>(corner);
      }
      EXPECT_EQ(cells.cells.fluidCorners[row], expected);
      if (expected == 0 || expected == 0xff) ++thin;
    }
    EXPECT_GT(thin, 0U);
    EXPECT_EQ(check(cells).thinCells, thin);
  }
}

TEST(CellCutterTest, PlanesMayBeAnyDistanceApart) {
  const auto solid = torus();
  std::array<std::vector<double>, 3> all;
  for (auto& planes : all) {
    double step = 0.013;
    planes = {0};
    while (planes.back() + step < 1) {
      planes.push_back(planes.back() + step);
      step *= 1.2;
    }
    planes.push_back(1);
  }
  const auto cells = CellCutter(solid).cut(cellsBetween(all, {-3, 5, 100}));
  expectIdentities(cells, 1e-14);
  EXPECT_NEAR(check(cells).bodyVolume, volumeOf(solid.as<MeshSDF<double>>()->soup()), 1e-14);
  EXPECT_NEAR(check(cells).fluidVolume + check(cells).bodyVolume, 1, 1e-14);
  for (const auto& index : cells.cells.index) EXPECT_GE(index.k, 99);
}

TEST(CellCutterTest, WallsKnowTheirPatches) {
  auto soup = tessellation::box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8});
  soup.patchNames = {"sides", "lid"};
  double lid = 0;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    bool isLid = true;
    for (const auto corner : soup.polygon(i)) isLid = isLid && soup.points[corner].z > 0.7;
    soup.patches[i] = isLid ? 1 : 0;
  }
  const auto cells = CellCutter(Solid<double>(MeshSDF<double>(soup))).cut(unitCube(3));
  ASSERT_EQ(cells.patchNames, soup.patchNames);
  Vec3<double> vector;
  for (std::size_t w = 0; w < cells.wallParts.area.size(); ++w) {
    if (cells.wallParts.patch[w] != 1) continue;
    lid += cells.wallParts.area[w];
    vector += cells.wallParts.vector[w];
    EXPECT_DOUBLE_EQ(cells.wallParts.centroid[w].z, 0.8);
  }
  EXPECT_NEAR(lid, 0.36, 1e-15);
  EXPECT_NEAR(vector.z, -0.36, 1e-15);  // out of the fluid above the lid
}

TEST(CellCutterTest, PartsThatTouchAlongAnEdgeKeepTheFluidApart) {
  const auto soup = moved(joined({tessellation::box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.75}),
                                  tessellation::box({0.5, 0.5, 0.25}, {0.75, 0.75, 0.75})}),
                          {0.0134, 0.0134, 0.0134});
  const auto cells = CellCutter(Solid<double>(MeshSDF<double>(soup))).cut(unitCube(8));
  expectIdentities(cells, 1e-14);
  EXPECT_NEAR(check(cells).bodyVolume, 0.0625, 1e-15);
  EXPECT_EQ(check(cells).multiPieceCells, 3U);  // of the five along the edge, not those at its ends
}

TEST(CellCutterTest, FacesWithTwoCornersInOnePlaceDoNotMatter) {
  // An edge opens into a slit of no width, with a needle in it.
  PolygonSoup soup = tessellation::box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8});
  const auto twin = static_cast<std::uint32_t>(soup.points.size());
  const auto corner = soup.corners[0];
  const auto next = soup.corners[1];
  soup.points.push_back(soup.points[corner]);
  soup.corners[0] = twin;
  const auto before = soup.polygon(0).back();
  soup.addPolygon(std::array{corner, next, twin});
  soup.addPolygon(std::array{before, corner, twin});
  const auto cells = CellCutter(Solid<double>(MeshSDF<double>(soup))).cut(unitCube(7));
  expectIdentities(cells, 1e-14);
  EXPECT_NEAR(check(cells).bodyVolume, 0.216, 1e-15);
}

TEST(CellCutterTest, SaysWhatItCannotCut) {
  EXPECT_THROW(CellCutter(Solid<double>(Sphere<double>({0, 0, 0}, 1))), Error);
  auto open = tessellation::box({0, 0, 0}, {1, 1, 1});
  open.patches.pop_back();
  open.offsets.pop_back();
  open.corners.resize(open.offsets.back());
  EXPECT_THROW(CellCutter(Solid<double>(MeshSDF<double>(open))), Error);
  const CellCutter cutter(torus());
  EXPECT_THROW(static_cast<void>(cutter.cut(cellsBetween({{{0, 1}, {0, 1}, {1, 0}}}))), Error);
  EXPECT_THROW(static_cast<void>(cutter.cut(cellsBetween({{{0, 1}, {0}, {0, 1}}}))), Error);
}

}  // namespace
}  // namespace cutwater::test
