#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

const OctreeDomain<double> kDomain({-1.03, -1.01, -1.02}, 0.5, {4, 4, 4});

Octree<double> meshAround(const Solid<double>& solid, int level, Balance balance) {
  Refinement<double> rules;
  rules.cut = level;
  return Octree<double>(solid, kDomain, rules, {.balance = balance});
}

double volumeOf(const CutLeaves& leaves) {
  double volume = leaves.wholeFluid;
  for (const double piece : leaves.pieces.volume) volume += piece;
  return volume;
}

/// What holds for every mesh.
void expectSound(const FluidMesh& mesh, const CutLeaves& leaves) {
  const auto report = check(mesh);
  EXPECT_EQ(report.openCells, 0U);
  EXPECT_EQ(report.repeatedCorners, 0U);
  EXPECT_EQ(report.disordered, 0U);
  EXPECT_LT(report.worstClosure, 1e-14);
  EXPECT_NEAR(report.fluidVolume + mesh.lostVolume, volumeOf(leaves), 5e-12);
  std::vector<char> isUsed(mesh.points.size(), 0);
  for (const auto corner : mesh.faces.corners) isUsed[corner] = 1;
  EXPECT_EQ(std::ranges::count(isUsed, 0), 0);
  std::size_t face = mesh.faces.neighbour.size();
  for (const auto& patch : mesh.patches) {
    EXPECT_EQ(patch.firstFace, face);
    face += patch.faceCount;
  }
  EXPECT_EQ(face, mesh.faces.count());
}

/// checkMesh would have nothing to tell of.
void expectGood(const FluidMesh& mesh) {
  const auto report = check(mesh);
  EXPECT_EQ(report.flatFaces, 0U);
  EXPECT_EQ(report.fewFaces, 0U);
  EXPECT_EQ(report.invertedFaces, 0U);
  EXPECT_EQ(report.invertedCells, 0U);
  EXPECT_EQ(report.skewFaces, 0U);
  EXPECT_LT(report.worstAspectRatio, 1000);
}

TEST(FluidMeshTest, MeshesOfManyLevelsClose) {
  const Solid<double> torus(Torus<double>(0.6, 0.23));
  for (const auto balance : {Balance::Corner, Balance::Face, Balance::None}) {
    const auto mesh = meshAround(torus, 3, balance);
    const auto leaves = SolidCutter(torus).cut(mesh, {.polygons = true});
    for (const double smallest : {0.0, 0.1, 0.4}) {
      for (const bool wallPolygons : {false, true}) {
        const auto fluid =
            fluidMesh(leaves, mesh, {.wallPolygons = wallPolygons, .smallest = smallest});
        expectSound(fluid, leaves);
        EXPECT_EQ(check(fluid).fewFaces, 0U);
        if (!wallPolygons) expectGood(fluid);
        EXPECT_EQ(fluid.regions.size(), 1U);
        EXPECT_EQ(fluid.patches.size(), 7U);
      }
    }
  }
}

TEST(FluidMeshTest, DoesNotDependOnThreads) {
  const Solid<double> torus(Torus<double>(0.6, 0.23));
  const auto mesh = meshAround(torus, 4, Balance::Face);
  const auto leaves = SolidCutter(torus).cut(mesh, {.polygons = true});
  const auto one = fluidMesh(leaves, mesh, {.threads = 1});
  const auto report = check(one, 1);
  ASSERT_GT(one.cells.leaf.size(), 10'000U);  // more than what a thread takes at a time
  const auto several = fluidMesh(leaves, mesh, {.threads = 3});
  EXPECT_EQ(several.points, one.points);
  EXPECT_EQ(several.faces.corners, one.faces.corners);
  EXPECT_EQ(several.faces.first, one.faces.first);
  EXPECT_EQ(several.faces.owner, one.faces.owner);
  EXPECT_EQ(several.faces.neighbour, one.faces.neighbour);
  const auto same = check(one, 3);
  EXPECT_EQ(same.meshVolume, report.meshVolume);
  EXPECT_EQ(same.meanNonOrthogonality, report.meanNonOrthogonality);
  EXPECT_EQ(same.worstSkewness, report.worstSkewness);
  EXPECT_EQ(same.worstAspectRatio, report.worstAspectRatio);
}

/// Polygons of a mesh are plane: they enclose the fluid.
TEST(FluidMeshTest, PolygonsOfWallsEncloseTheFluid) {
  auto solid = Solid<double>(MeshSDF<double>(bipyramid(9)));
  solid.rotate(20, {1, 2, 3});
  const auto mesh = meshAround(solid, 2, Balance::Corner);
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto leaves = CellCutter(solid, side).cut(mesh, {.polygons = true});
    const auto fluid = fluidMesh(leaves, mesh, {.wallPolygons = true});
    expectSound(fluid, leaves);
    const auto report = check(fluid);
    EXPECT_NEAR(report.meshVolume, report.fluidVolume, 1e-13);
  }
}

/// Faces of one rim nearly do.
TEST(FluidMeshTest, FacesOfOneRimEncloseItToTheSecondOrder) {
  const Solid<double> ball(Sphere<double>({0, 0, 0}, 0.7));
  std::array<double, 2> errors{};
  for (const int level : {2, 3}) {
    const auto mesh = meshAround(ball, level, Balance::Corner);
    const auto leaves = SolidCutter(ball).cut(mesh, {.polygons = true});
    const auto report = check(fluidMesh(leaves, mesh));
    errors[static_cast<std::size_t>(level - 2)] = std::abs(report.meshVolume - report.fluidVolume);
    EXPECT_EQ(report.invertedCells, 0U);
    EXPECT_LT(report.meanNonOrthogonality, 25);
  }
  EXPECT_LT(errors[1], errors[0] / 3);
  EXPECT_LT(errors[0], 0.02);
}

/// The whole leaves of a box that fills leaves are a brick: all numbers are known.
TEST(FluidMeshTest, ADomainWithoutABody) {
  const Solid<double> away(Sphere<double>({9, 0, 0}, 0.1));
  const auto mesh = meshAround(away, 2, Balance::Corner);
  const auto leaves = SolidCutter(away).cut(mesh, {.polygons = true});
  const auto fluid = fluidMesh(leaves, mesh);
  expectSound(fluid, leaves);
  EXPECT_EQ(fluid.cells.leaf.size(), 64U);
  EXPECT_EQ(fluid.faces.neighbour.size(), 3U * 3 * 16);
  EXPECT_EQ(fluid.faces.count(), 3U * 5 * 16);
  EXPECT_EQ(fluid.points.size(), 125U);
  ASSERT_EQ(fluid.patches.size(), 6U);
  EXPECT_EQ(fluid.patches[3].name, "yMax");
  EXPECT_EQ(fluid.patches[3].faceCount, 16U);
  const auto report = check(fluid);
  EXPECT_NEAR(report.meshVolume, 8, 1e-14);
  EXPECT_LT(report.worstNonOrthogonality, 1e-5);
}

TEST(FluidMeshTest, CavitiesAreLeftOutOrKept) {
  const auto shell = Sphere<double>({0, 0, 0}, 0.8) - Sphere<double>({0, 0, 0}, 0.5);
  const auto mesh = meshAround(shell, 2, Balance::Corner);
  const auto leaves = SolidCutter(shell).cut(mesh, {.polygons = true});
  const double cavity = 4 * std::numbers::pi / 3 * 0.125;
  const auto open = fluidMesh(leaves, mesh);
  expectSound(open, leaves);
  EXPECT_EQ(open.regions.size(), 1U);
  EXPECT_EQ(open.lostRegions, 1U);
  EXPECT_NEAR(open.lostVolume, cavity, 1e-4);
  const auto all = fluidMesh(leaves, mesh, {.cavities = Cavities::Kept});
  expectSound(all, leaves);
  ASSERT_EQ(all.regions.size(), 2U);
  EXPECT_NEAR(all.regions[1], cavity, 1e-4);
  const auto inner = fluidMesh(leaves, mesh, {.within = Vec3<double>{0, 0, 0}});
  expectSound(inner, leaves);
  EXPECT_EQ(inner.regions, std::vector<double>{all.regions[1]});
  EXPECT_EQ(inner.patches.size(), 1U);
}

/// An edge of the body that pokes far into leaves, of two patches: such cells are divided.
TEST(FluidMeshTest, CellsAroundEdgesAreSeenFromInside) {
  const auto edge = named(Cuboid<double>({-0.6, -0.6, -0.4}, {0.18, 0.19, 0.4}), "box") |
                    named(Cuboid<double>({-0.5, -0.7, -0.3}, {0.06, 0.44, 0.33}), "bar");
  const auto mesh = meshAround(edge, 2, Balance::Corner);
  const auto leaves = SolidCutter(edge).cut(mesh, {.polygons = true});
  const auto fluid = fluidMesh(leaves, mesh);
  expectSound(fluid, leaves);
  expectGood(fluid);
}

/// Where sides of a block lie in planes of the grid and channels end there, walls touch edges of
/// leaves: faces without area are left out, and those that touch themselves are several.
TEST(FluidMeshTest, WallsThatTouchEdgesOfLeavesHaveAnArea) {
  const TpmsSolid<double> gyroid(TpmsField<double>(TpmsPattern::gyroid(), 1), TpmsPart::Wall, 0.4);
  const auto core = gyroid & Cuboid<double>({-1, -1, -1}, {1, 1, 1});
  for (const double shift : {0.0, 0.01}) {
    const OctreeDomain<double> domain({-1.5 - shift, -1.2 - shift, -1.2 - shift}, 0.1,
                                      {30, 24, 24});
    const Octree<double> octree(core, domain, Refinement<double>{});
    const auto leaves = SolidCutter(core).cut(octree, {.polygons = true});
    const auto fluid = fluidMesh(leaves, octree);
    expectSound(fluid, leaves);
    const auto report = check(fluid);
    EXPECT_EQ(report.flatFaces, 0U);
    EXPECT_EQ(report.fewFaces, 0U);
    EXPECT_EQ(report.skewFaces, 0U);
    EXPECT_LT(report.invertedFaces, 20U);  // of 50 000, where the wall is thinner than a cell
  }
}

/// A sheet that ends within leaves keeps all of its two sides.
TEST(FluidMeshTest, SheetsThatEndInCellsAreWhole) {
  const std::vector<Vec3<double>> corners{
      {-0.6, -0.57, -0.09}, {0.6, -0.57, -0.09}, {0.6, 0.56, -0.09}, {-0.6, 0.56, -0.09}};
  const Solid<double> sheet(MeshSDF<double>(makeSoup(corners, {{0, 1, 2}, {0, 2, 3}})));
  const auto mesh = meshAround(sheet, 2, Balance::Corner);
  const auto leaves =
      CellCutter(sheet, FluidSide::Outside, {.baffles = {"all"}}).cut(mesh, {.polygons = true});
  const auto fluid = fluidMesh(leaves, mesh);
  expectSound(fluid, leaves);
  EXPECT_LE(check(fluid).invertedFaces, 1U);  // at a corner of the sheet
  double area = 0;
  for (std::size_t n = 0; n < fluid.patches.front().faceCount; ++n) {
    const auto loop = fluid.faces.of(fluid.patches.front().firstFace + n);
    for (std::size_t k = 2; k < loop.size(); ++k) {
      const auto& a = fluid.points[loop[0]];
      const auto normal = cross(fluid.points[loop[k - 1]] - a, fluid.points[loop[k]] - a);
      area += normal.z > 0 ? normal.z / 2 : 0;
      area += normal.z < 0 ? -normal.z / 2 : 0;
    }
  }
  EXPECT_NEAR(area, 2 * 1.2 * 1.13, 1e-12);
}

TEST(FluidMeshTest, RefusesWhatIsNoMeshOfTheFluid) {
  const Solid<double> ball(Sphere<double>({0, 0, 0}, 0.7));
  const auto mesh = meshAround(ball, 1, Balance::Corner);
  const auto leaves = SolidCutter(ball).cut(mesh, {.polygons = true});
  const auto refuses = [&](const CutLeaves& cut, const FluidMeshOptions& options) {
    EXPECT_THROW(static_cast<void>(fluidMesh(cut, mesh, options)), Error);
  };
  refuses(SolidCutter(ball).cut(mesh), {});
  refuses(leaves, {.smallest = 1.5});
  refuses(leaves, {.within = Vec3<double>{0, 0, 0}});
  refuses(leaves, {.within = Vec3<double>{9, 0, 0}});
  const auto other = meshAround(ball, 0, Balance::Corner);
  EXPECT_THROW(static_cast<void>(fluidMesh(leaves, other)), Error);
}

}  // namespace
}  // namespace cutwater::test
