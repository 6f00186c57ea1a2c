// Open patches in leaves of octrees, in planes, of caps across holes; and what is refused.
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/JoinedCells.hpp"
#include "CutCells/MomentCells.hpp"
#include "CutCells/OpenCells.hpp"
#include "CutCells/RandomLeaves.hpp"
#include "CutCells/RandomVoxels.hpp"
#include "Support/CutIdentities.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/Refusal.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// Of each patch, what it has of faces.
template <typename Cut>
std::vector<double> openAreas(const Cut& cut) {
  std::vector<double> areas(cut.patchNames.size());
  for (std::size_t n = 0; n < cut.openArcs.arc.size(); ++n) {
    areas[cut.openArcs.patch[n]] += cut.arcs.area[cut.openArcs.arc[n]];
  }
  return areas;
}

/// Whether a triangle lies in a face of the leaf on this side of it.
bool isInFace(const Mesh& mesh, const FlatTriangle& t, FluidSide side) {
  auto in = t.middle;
  in[t.axis] += (side == FluidSide::Outside ? 1 : -1) * t.facing / 64.0;
  for (const auto& [index, level, kind] : mesh.cells()) {
    const auto box = mesh.domain().level(level).cell(index);
    if (maxComponent(max(box.lower - in, in - box.upper)) > 0) continue;
    return box.lower[t.axis] == t.middle[t.axis] || box.upper[t.axis] == t.middle[t.axis];
  }
  return false;
}

TEST(OpenPatchesKindsTest, LeavesOfAnyLevelAreAsTheirFinestCellsJoined) {
  std::mt19937 random(11);
  std::size_t arcs = 0;
  for (int n = 0; n < scaled(8) && !HasFailure(); ++n) {
    const auto side = n % 2 == 0 ? FluidSide::Outside : FluidSide::Inside;
    const auto mesh = randomMesh(random, 4, 0, 1, 80);
    const Solid<double> solid{MeshSDF<double>(withPatches(
        meshOf(randomVoxels(random)).soup(), {"wall", "a", "b"}, [&](const FlatTriangle& t) {
          return isInFace(mesh, t, side) ? static_cast<std::uint32_t>(random() % 3) : 0U;
        }))};
    const CellCutter cutter(solid, side, {.openPatches = {"a", "b"}});
    const auto leaves = cutter.cut(mesh, {.polygons = true, .moments = 2});
    expectIdentities(leaves, 1e-13);
    EXPECT_LT(check(leaves).worstMoments, 1e-13);
    expectPolygonsOf(leaves);
    const auto fine = cutter.cut(finestOf(mesh));
    JoinedCells(fine, mesh).expectSame(leaves);
    for (std::size_t patch = 0; patch < 3; ++patch) {
      EXPECT_NEAR(openAreas(leaves)[patch], openAreas(fine)[patch], 1e-13);
    }
    arcs += leaves.openArcs.arc.size();
  }
  EXPECT_GT(arcs, 500U);
}

TEST(OpenPatchesKindsTest, AnOctreeOfOneLevelIsTheGrid) {
  const auto duct = ductOf(tessellation::box({0.25, 0.3, 0.35}, {0.75, 0.61, 0.72}, 2));
  const CellCutter cutter(duct, FluidSide::Inside, {.openPatches = {"inlet", "outlet"}});
  const OctreeDomain<double> domain({0, 0, 0}, 0.125, {8, 8, 8});
  const Octree<double> mesh(duct, domain, {.cut = 0});
  const auto leaves = cutter.cut(mesh);
  const auto cells = cutter.cut(finestOf(mesh));
  ASSERT_EQ(leaves.pieces.cell.size(), cells.pieceCount);
  ASSERT_EQ(leaves.arcs.area.size(), cells.arcs.area.size());
  using Key = std::tuple<double, double, double, double, bool>;
  std::vector<Key> expected;
  std::vector<Key> found;
  const auto add = [](const auto& arcs, std::size_t a, std::vector<Key>& to) {
    const auto& c = arcs.centroid[a];
    to.emplace_back(arcs.area[a], c.x, c.y, c.z, arcs.above[a] == CutCells::kBeyond);
  };
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) add(cells.arcs, a, expected);
  for (std::size_t a = 0; a < leaves.arcs.area.size(); ++a) add(leaves.arcs, a, found);
  std::ranges::sort(expected);
  std::ranges::sort(found);
  EXPECT_EQ(found, expected);
  const CutRegions regions(leaves, mesh);
  ASSERT_EQ(regions.regions().size(), 1U);
  EXPECT_TRUE(regions.regions()[0].goesOn);
}

TEST(OpenPatchesKindsTest, InAPlaneTheyAreArcsOfSides) {
  const auto duct = ductOf(tessellation::box({0.25, 0.3, 0.35}, {0.75, 0.61, 0.72}, 3));
  const CellCutter cutter(duct, FluidSide::Inside, {.openPatches = {"inlet"}});
  const std::vector<double> planes{0, 0.25, 0.375, 0.5, 0.75, 1};
  const auto cells = cutter.cutInPlane(cellsBetween({planes, planes, {0, 1}}), 0.5);
  expectIdentities(cells, 1e-14);
  EXPECT_NEAR(check(cells).fluidVolume, 0.5 * 0.31, 1e-15);
  EXPECT_NEAR(check(cells).wallArea, 2 * 0.5 + 0.31, 1e-15);
  double open = 0;
  std::size_t arcs = 0;
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    if (!isOpenPatch(cells, a)) continue;
    ++arcs;
    EXPECT_EQ(cells.arcs.below[a], CutCells::kBeyond);
    EXPECT_EQ(cells.arcs.cell[a].i, 1);
    EXPECT_EQ(cells.arcs.centroid[a].x, 0.25);
    open += cells.arcs.area[a];
  }
  EXPECT_NEAR(open, 0.31, 1e-15);
  EXPECT_EQ(arcs, 3U);  // in rows of cells from 1/4, 3/8 and 1/2
  EXPECT_TRUE(CutRegions(cells).regions()[0].goesOn);
  const CellCutter off(duct, FluidSide::Inside, {.openPatches = {"outlet"}});
  const std::vector<double> others{0, 0.25, 0.7, 1};
  const auto cut = [&] { return off.cutInPlane(cellsBetween({others, planes, {0, 1}}), 0.5); };
  EXPECT_NE(refusal(cut).find("\"outlet\" lies in no plane of the grid at (0.75, "),
            std::string::npos);
}

TEST(OpenPatchesKindsTest, InPlanesOfRandomVoxelsTheyTakeThePlaceOfWalls) {
  std::mt19937 random(5);
  std::size_t arcs = 0;
  std::size_t rounds = 0;
  for (int n = 0; n < scaled(6) && !HasFailure(); ++n) {
    const auto side = n % 2 == 0 ? FluidSide::Outside : FluidSide::Inside;
    const Solid<double> solid{MeshSDF<double>(withPatches(
        meshOf(randomVoxels(random)).soup(), {"wall", "a", "b"},
        [&](const FlatTriangle&) { return static_cast<std::uint32_t>(random() % 3); }))};
    const auto grid = planesOf(unitGrid(16));
    const double z = 0.3 + 0.05 * (n % 6);
    const auto open =
        CellCutter(solid, side, {.openPatches = {"a"}}).cutInPlane(grid, z, {.threads = 2});
    expectIdentities(open, 1e-13);
    arcs += open.openArcs.arc.size();
    ++rounds;
    expectOpened(open, CellCutter(solid, side).cutInPlane(grid, z),
                 [](std::uint32_t patch) { return patch == 1; });
  }
  EXPECT_GT(arcs, 20 * rounds);
}

/// A bend: the half of a torus at y >= 0, without its ends.
PolygonSoup bend(int sides) {
  const auto whole = tessellation::torus(0.3, 0.1, 36, sides);
  PolygonSoup half;
  half.points = whole.points;
  for (auto& p : half.points) p.y = std::abs(p.y) < 1e-12 ? 0 : p.y;
  for (std::size_t i = 0; i < whole.polygonCount(); ++i) {
    const auto corners = whole.polygon(i);
    const auto isBehind = [&](std::uint32_t corner) { return half.points[corner].y >= 0; };
    if (std::ranges::all_of(corners, isBehind)) half.addPolygon(corners);
  }
  return half;
}

TEST(OpenPatchesKindsTest, ABendIsOpenAtItsEndsOnAllLevels) {
  for (const int sides : {5, 16}) {
    const auto soup = bend(sides);
    const Solid<double> solid{MeshSDF<double>(soup)};
    const CellCutter cutter(solid, FluidSide::Inside, {.capHoles = true, .openPatches = {"cap"}});
    const double section = 0.5 * sides * 0.01 * std::sin(2 * std::numbers::pi / sides);
    double volume = 0;
    const auto expectBend = [&](const auto& cut) {
      expectIdentities(cut, 1e-13);
      const auto report = check(cut);
      EXPECT_NEAR(report.wallArea, measure(soup).area, 1e-13);
      EXPECT_LT(report.worstMoments, 1e-13);
      EXPECT_NEAR(openAreas(cut).back(), 2 * section, 1e-15);
      if (volume == 0) volume = report.fluidVolume;
      EXPECT_NEAR(report.fluidVolume, volume, 1e-14);
    };
    const CutOptions all{.polygons = true, .moments = 2};
    for (const int n : {4, 10, 26}) {
      const auto cells = cutter.cut(unitGrid(n, -0.5, 0.5), all);
      expectBend(cells);
      expectPolygonsOf(cells);
    }
    for (const int finest : {1, 2, 4}) {
      const OctreeDomain<double> domain({-0.5, -0.5, -0.5}, 0.25, {4, 4, 4});
      const Octree<double> mesh(solid, domain, {.cut = 1, .edges = {{40, finest}}},
                                {.balance = Balance::None});
      const auto leaves = cutter.cut(mesh, all);
      expectBend(leaves);
      expectPolygonsOf(leaves, 10);
      const CutRegions regions(leaves, mesh);
      ASSERT_EQ(regions.regions().size(), 1U);
      EXPECT_TRUE(regions.regions()[0].goesOn);
    }
  }
}

/// Without the triangles that lie across an axis.
PolygonSoup withoutEnds(const PolygonSoup& whole, int axis) {
  PolygonSoup open;
  open.points = whole.points;
  for (std::size_t i = 0; i < whole.polygonCount(); ++i) {
    const auto corners = whole.polygon(i);
    const auto isLevel = [&](std::uint32_t corner) {
      return whole.points[corner][axis] == whole.points[corners[0]][axis];
    };
    if (!std::ranges::all_of(corners, isLevel)) open.addPolygon(corners);
  }
  return open;
}

TEST(OpenPatchesKindsTest, CapsAcrossHolesMayBeOpen) {
  const CutterOptions open{.capHoles = true, .openPatches = {"cap"}};
  for (const int sides : {3, 4, 12, 31}) {
    const auto tube = withoutEnds(tessellation::cylinder(0.3, 0.5, sides), 2);
    const CellCutter cutter(Solid<double>(MeshSDF<double>(tube)), FluidSide::Inside, open);
    const double section = 0.5 * sides * 0.09 * std::sin(2 * std::numbers::pi / sides);
    for (const int n : {4, 8, 12}) {
      const auto cells = cutter.cut(unitGrid(n, -0.5, 0.5), {.polygons = true, .moments = 1});
      expectIdentities(cells, 1e-14);
      expectPolygonsOf(cells);
      EXPECT_NEAR(check(cells).fluidVolume, 0.5 * section, 1e-15);
      EXPECT_NEAR(check(cells).wallArea, 0.3 * std::sin(std::numbers::pi / sides) * sides, 1e-14);
      EXPECT_NEAR(openArea(cells), 2 * section, 1e-15);
    }
  }
}

/// Rims with vertices in a line: caps then meet the walls.
TEST(OpenPatchesKindsTest, CapsThatMeetWallsMayBeOpen) {
  for (const int parts : {2, 4, 5}) {
    const auto tube =
        withoutEnds(tessellation::box({0.25, 0.3, 0.35}, {0.75, 0.61, 0.72}, parts), 0);
    const CellCutter cutter(Solid<double>(MeshSDF<double>(tube)), FluidSide::Inside,
                            {.capHoles = true, .openPatches = {"cap"}});
    for (const int n : {4, 8, 12}) {
      const auto cells = cutter.cut(unitGrid(n), {.polygons = true, .moments = 2});
      expectIdentities(cells, 1e-14);
      expectPolygonsOf(cells);
      EXPECT_LT(check(cells).worstMoments, 1e-14);
      EXPECT_GT(check(cells).meetingCells, 0U);
      EXPECT_NEAR(check(cells).fluidVolume, 0.5 * 0.31 * 0.37, 1e-15);
      EXPECT_NEAR(check(cells).wallArea, 0.5 * 2 * (0.31 + 0.37), 1e-14);
      EXPECT_NEAR(openArea(cells), 2 * 0.31 * 0.37, 1e-15);
      EXPECT_TRUE(CutRegions(cells).regions()[0].goesOn);
    }
  }
}

/// A bar through an outlet: what both have in common is no end of the fluid.
TEST(OpenPatchesKindsTest, WhatIsWithinAnotherSolidIsNoAperture) {
  const auto soup = tessellation::box({0.25, 0.3, 0.35}, {0.75, 0.61, 0.72});
  const auto bar = tessellation::box({0.6, 0.4, 0.4}, {0.9, 0.5, 0.5});
  const auto both = together(ductOf(soup).as<MeshSDF<double>>()->soup(), bar);
  const CellCutter cutter(Solid<double>(MeshSDF<double>(both)), FluidSide::Inside,
                          {.openPatches = {"inlet", "outlet"}});
  for (const int n : {4, 8, 20}) {
    const auto cells = cutter.cut(unitGrid(n), {.moments = 2});
    expectIdentities(cells, 1e-14);
    EXPECT_LT(check(cells).worstMoments, 1e-14);
    EXPECT_NEAR(check(cells).fluidVolume, 0.5 * 0.31 * 0.37 + 0.15 * 0.01, 1e-15);
    EXPECT_NEAR(check(cells).wallArea, 0.5 * 2 * (0.31 + 0.37) + 0.15 * 0.4 + 0.01, 1e-14);
    EXPECT_NEAR(openAreas(cells)[1], 0.31 * 0.37, 1e-15);
    EXPECT_NEAR(openAreas(cells)[2], 0.31 * 0.37 - 0.01, 1e-15);
  }
  EXPECT_NE(refusal([&] { return cutter.cut(unitGrid(6)); }).find("in no plane of the grid"),
            std::string::npos);
  const auto inPlane = refusal([&] { return cutter.cutInPlane(planesOf(unitGrid(6)), 0.45); });
  EXPECT_NE(inPlane.find("in no plane of the grid"), std::string::npos) << inPlane;
}

TEST(OpenPatchesKindsTest, RefusesNamesThatThereAreNot) {
  const auto duct = ductOf(tessellation::box({0.25, 0.3, 0.35}, {0.75, 0.61, 0.72}));
  const auto refused = [&](const std::vector<std::string>& names) {
    return refusal([&] { return CellCutter(duct, FluidSide::Inside, {.openPatches = names}); });
  };
  EXPECT_EQ(refused({"inlet", "out"}),
            "cut cells: no patch is called \"out\" that could be open; there are: \"wall\", "
            "\"inlet\", \"outlet\"");
  EXPECT_EQ(refused({"inlet", "outlet", "inlet"}),
            "cut cells: the open patch \"inlet\" is named twice; there are: \"wall\", \"inlet\", "
            "\"outlet\"");
  EXPECT_EQ(refused({"inlet", "outlet"}), "");
}

TEST(OpenPatchesKindsTest, RefusesWhatLiesInNoFace) {
  const auto soup = tessellation::box({0.25, 0.3, 0.35}, {0.75, 0.61, 0.72});
  const CutterOptions open{.openPatches = {"outlet"}};
  const CellCutter cutter(ductOf(soup), FluidSide::Inside, open);
  const auto between = refusal([&] { return cutter.cut(unitGrid(10)); });
  EXPECT_NE(
      between.find("cut cells: the open patch \"outlet\" lies in no plane of the grid at (0.75, "),
      std::string::npos)
      << between;
  EXPECT_THROW((void)cutter.cut(unitGrid(10)), Error);
  const Octree<double> mesh(ductOf(soup), OctreeDomain<double>({0, 0, 0}, 0.1, {10, 10, 10}),
                            {.cut = 0});
  EXPECT_EQ(refusal([&] { return cutter.cut(mesh); }), between);
  // Where it is beyond the box, it does not matter.
  const GridPatch<double> beside{unitGrid(10).level, {{0, 0, 0}, {6, 9, 9}}};
  expectIdentities(cutter.cut(beside), 1e-14);

  // By a millionth of a millionth, and by the last bit.
  for (const double off : {1e-12, 0x1p-53}) {
    auto moved = soup;
    for (auto& p : moved.points) p.x -= p.x == 0.75 ? off : 0;
    const CellCutter near(ductOf(moved), FluidSide::Inside, open);
    EXPECT_NE(refusal([&] { return near.cut(unitGrid(4)); }).find("in no plane of the grid"),
              std::string::npos);
  }
}

TEST(OpenPatchesKindsTest, RefusesInclinedCaps) {
  auto soup = ductOf(tessellation::box({0.25, 0.3, 0.35}, {0.75, 0.61, 0.72}))
                  .as<MeshSDF<double>>()
                  ->soup();
  for (const double off : {0.1, 0x1p-52}) {
    auto moved = soup;
    for (auto& p : moved.points) p.x += p.x == 0.75 && p.y == 0.61 ? off : 0;
    const Solid<double> duct{MeshSDF<double>(moved)};
    const CellCutter cutter(duct, FluidSide::Inside, {.openPatches = {"outlet"}});
    const auto refused = refusal([&] { return cutter.cut(unitGrid(4)); });
    EXPECT_NE(refused.find("the open patch \"outlet\" is across no axis at ("), std::string::npos)
        << refused;
  }
}

}  // namespace
}  // namespace cutwater::test
