// The code of Docs/cut-cells.md.
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "CutCells/OpenCells.hpp"
#include "Support/DamagedSoups.hpp"
#include "Support/Soups.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

TEST(DocsTest, FractionsAndAperturesOfCutCells) {
  const Solid<double> hull(MeshSDF<double>(tessellation::icosphere(0.4, 3)));
  const Level<double> level({-0.5, -0.5, -0.5}, {0.125, 0.125, 0.125});
  const auto indices = IndexBox::ofSize(8, 8, 8);
  double fluid = 0;
  double faces = 0;
  const auto useFraction = [&](const Index3&, double fraction, const Vec3<double>& centroid) {
    fluid += fraction;
    EXPECT_LE(maxComponent(abs(centroid)), 0.5);
  };
  const auto useFace = [&](const Index3& cell, int axis, double aperture) {
    EXPECT_LE(cell.i, 8);
    EXPECT_LT(axis, 3);
    faces += aperture;
  };
  // [DOCS
  const CellCutter cutter(hull);  // fluid outside; FluidSide::Inside: within it
  const CutCells cells = cutter.cut(GridPatch<double>{level, indices});
  for (std::size_t row = 0; row < cells.cellCount; ++row) {
    const Index3& cell = cells.cells.index[row];
    for (auto p = cells.cells.firstPiece[row]; p < cells.cells.firstPiece[row + 1]; ++p) {
      useFraction(cell, cells.volumeFraction(p), cells.pieces.centroid[p]);
    }
  }
  for (std::uint32_t a = 0; a < cells.arcs.area.size(); ++a) {
    useFace(cells.arcs.cell[a], cells.arcs.axis[a], cells.aperture(a));
  }
  // DOCS]
  EXPECT_GT(fluid, 10);
  EXPECT_LT(fluid, static_cast<double>(cells.cellCount));
  EXPECT_GT(faces, fluid);
}

TEST(DocsTest, TubesWithoutEnds) {
  const auto closed = tessellation::cylinder(0.3, 0.5, 12);
  PolygonSoup open;
  open.points = closed.points;
  for (std::size_t i = 0; i < closed.polygonCount(); ++i) {
    const auto corners = closed.polygon(i);
    const auto isAtSameHeight = [&](std::uint32_t corner) {
      return closed.points[corner].z == closed.points[corners[0]].z;
    };
    if (!std::ranges::all_of(corners, isAtSameHeight)) open.addPolygon(corners);
  }
  const Solid<double> tube{MeshSDF<double>(open)};
  // [DOCS
  const CellCutter cutter(tube, FluidSide::Inside, {.capHoles = true});
  // DOCS]
  const std::vector<double> planes{-0.5, 0, 0.5};
  const auto cells = cutter.cut(cellsBetween({planes, planes, planes}));
  // A prism over a regular polygon.
  EXPECT_NEAR(check(cells).fluidVolume, 0.5 * 12 * 0.5 * 0.09 * std::sin(std::numbers::pi / 6),
              1e-15);
  EXPECT_EQ(cells.patchNames.back(), "cap");
  // [DOCS
  const auto disputed = cutter.disputedCells(cells);  // sorted as rows, cut or not
  // DOCS]
  EXPECT_EQ(disputed.size(), 4U);  // those in the tube
}

TEST(DocsTest, DuctsWithOpenEnds) {
  const auto duct = ductOf(tessellation::box({0.25, 0.3, 0.35}, {0.75, 0.61, 0.72}));
  const Level<double> level({0, 0, 0}, {0.125, 0.125, 0.125});
  const auto indices = IndexBox::ofSize(8, 8, 8);
  double open = 0;
  const auto useOpening = [&](const std::string& patch, const Index3& cell, double aperture) {
    EXPECT_EQ(cell.i, patch == "inlet" ? 2 : 6);
    open += aperture;
  };
  // [DOCS
  const CellCutter cutter(duct, FluidSide::Inside, {.openPatches = {"inlet", "outlet"}});
  const CutCells cells = cutter.cut(GridPatch<double>{level, indices});
  for (std::size_t n = 0; n < cells.openArcs.arc.size(); ++n) {
    const auto arc = cells.openArcs.arc[n];
    const auto& patch = cells.patchNames[cells.openArcs.patch[n]];
    useOpening(patch, cells.arcs.cell[arc], cells.aperture(arc));
  }
  // DOCS]
  EXPECT_NEAR(open, 2 * 0.31 * 0.37 * 64, 1e-13);
}

TEST(DocsTest, BafflesInATank) {
  auto soup = tessellation::box({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9});
  soup.patchNames = {"tank", "fin", "sail"};
  for (const std::uint32_t patch : {1U, 2U}) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const auto& [y, z] : {std::pair(0.2, 0.3), {0.5, 0.3}, {0.2, 0.6}}) {
      soup.points.push_back({0.3 * patch, y, z});
    }
    soup.addPolygon(std::array{first, first + 1, first + 2}, patch);
  }
  const Solid<double> tank(MeshSDF<double>{soup});
  const Level<double> level({0, 0, 0}, {0.125, 0.125, 0.125});
  const auto indices = IndexBox::ofSize(8, 8, 8);
  double walls = 0;
  const auto useWalls = [&](const std::vector<double>& areas,
                            const std::vector<std::uint32_t>& patches) {
    for (std::size_t i = 0; i < areas.size(); ++i) walls += patches[i] > 0 ? areas[i] : 0;
  };
  // [DOCS
  const CellCutter cutter(tank, FluidSide::Inside, {.baffles = {"fin", "sail"}});
  const CutCells cells = cutter.cut(GridPatch<double>{level, indices});
  useWalls(cells.wallParts.area, cells.wallParts.patch);
  // DOCS]
  EXPECT_NEAR(walls, 4 * 0.045, 1e-14);
}

TEST(DocsTest, SectionsInAPlane) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(tessellation::icosphere(0.4, 3)))};
  const std::vector<double> x{-0.5, -0.2, 0, 0.1, 0.5};
  const std::vector<double> y{-0.5, 0.1, 0.5};
  const double z = 0.1;
  // [DOCS
  const CutCells section = cutter.cutInPlane(cellsBetween({x, y, {0, 1}}), z);
  // DOCS]
  EXPECT_NEAR(check(section).bodyVolume, std::numbers::pi * 0.15, 0.005);
}

TEST(DocsTest, PolyhedraOfCutCells) {
  const TemporaryFolder folder;
  const auto path = folder / "cells.vtu";
  const CellCutter cutter{Solid<double>(MeshSDF<double>(tessellation::icosphere(0.4, 1)))};
  const Level<double> level({-0.5, -0.5, -0.5}, {0.25, 0.25, 0.25});
  const auto indices = IndexBox::ofSize(4, 4, 4);
  // [DOCS
  const CutCells cells = cutter.cut(GridPatch<double>{level, indices}, {.polygons = true});
  writePointData(path, cutCellMesh(cells));  // .vtu, which ParaView opens: each piece a polyhedron
  // DOCS]
  EXPECT_EQ(cutCellMesh(cells).cells.count(), cells.pieceCount);
  EXPECT_GT(std::filesystem::file_size(path), 64 * cells.pieceCount);
}

TEST(DocsTest, MomentsOfCutCells) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(tessellation::icosphere(0.4, 3)))};
  const Level<double> level({-0.5, -0.5, -0.5}, {0.125, 0.125, 0.125});
  const auto indices = IndexBox::ofSize(8, 8, 8);
  std::size_t used = 0;
  const auto useMoments = [&](const Index3&, const std::vector<double>& row, double ofXY) {
    ++used;
    ASSERT_EQ(row.size(), 10U);
    EXPECT_EQ(row[5], ofXY);
    EXPECT_LE(std::abs(row[1]), 0.0625 * row[0]);
  };
  // [DOCS
  const CutCells cells = cutter.cut(GridPatch<double>{level, indices}, {.moments = 2});
  for (std::size_t p = 0; p < cells.pieceCount; ++p) {
    const auto& cell = cells.cells.index[cells.pieces.cell[p]];
    // The integrals of 1, x, y, z, xx, xy, xz, yy, yz and zz, from the center of its cell.
    const auto row =
        shifted(cells.moments.ofVolume(p), cells.pieces.centroid[p], cells.boxOf(cell).center());
    useMoments(cell, row, row[CutCells::Moments::indexOf(1, 1, 0)]);  // the last is that of xy
  }
  // DOCS]
  EXPECT_EQ(used, cells.pieceCount);
}

TEST(DocsTest, QuadratureOfCutCells) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(tessellation::icosphere(0.4, 3)))};
  const Level<double> level({-0.5, -0.5, -0.5}, {0.125, 0.125, 0.125});
  const auto indices = IndexBox::ofSize(8, 8, 8);
  double heat = 0;
  const auto sourceAt = [](const Vec3<double>& p) { return 1 + p.x - p.y * p.z; };
  // [DOCS
  const CutCells cells =
      cutter.cut(GridPatch<double>{level, indices}, {.quadrature = true, .quadratureDegree = 2});
  const auto& inside = cells.quadrature.volume;
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) {
    for (std::size_t i = 0; i < inside.pointsOf(p).size(); ++i) {
      heat += inside.weightsOf(p)[i] * sourceAt(inside.pointsOf(p)[i]);
    }
  }
  // DOCS]
  double volume = 0;
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) volume += cells.pieces.volume[p];
  EXPECT_NEAR(heat, volume, 1e-14);  // the rest cancels by symmetry
}

TEST(DocsTest, CoarserLevels) {
  const Solid<double> hull(MeshSDF<double>(tessellation::icosphere(0.4, 3)));
  const Level<double> level({-0.5, -0.5, -0.5}, {0.125, 0.125, 0.125});
  const auto cells = CellCutter(hull).cut(GridPatch<double>{level, IndexBox::ofSize(8, 8, 8)});
  // [DOCS
  const CutCells half = coarsened(cells, {2, 2, 2});  // and so on, down to one cell
  // DOCS]
  EXPECT_NEAR(check(half).fluidVolume, check(cells).fluidVolume, 1e-15);
}

TEST(DocsTest, LeavesOfAnOctree) {
  const Solid<double> hull(MeshSDF<double>(tessellation::icosphere(0.4, 3)));
  const CellCutter cutter(hull);
  const OctreeDomain<double> domain({-0.5, -0.5, -0.5}, 1, {1, 1, 1});
  double fluid = 0;
  double faces = 0;
  const auto useFraction = [&](std::uint32_t, double fraction) { fluid += fraction; };
  const auto useFace = [&](std::uint32_t below, std::uint32_t above, double aperture) {
    EXPECT_NE(below, above);
    faces += aperture;
  };
  // [DOCS
  const Octree<double> mesh(hull, domain, {.cut = 2, .curvature = {{15, 4}}});
  const CutLeaves leaves = cutter.cut(mesh);
  for (std::uint32_t p = 0; p < leaves.pieces.cell.size(); ++p) {
    useFraction(leaves.cut.leaf[leaves.pieces.cell[p]], leaves.volumeFraction(p));
  }
  for (std::uint32_t a = 0; a < leaves.arcs.area.size(); ++a) {
    useFace(leaves.arcs.leafBelow[a], leaves.arcs.leafAbove[a], leaves.aperture(a));
  }
  // DOCS]
  EXPECT_GT(fluid, 10);
  EXPECT_GT(faces, fluid);
  EXPECT_LT(check(leaves).worstClosure, 1e-14);
}

TEST(DocsTest, ConnectedFluid) {
  const auto shell =
      together(tessellation::icosphere(0.4, 2), insideOut(tessellation::icosphere(0.3, 2)));
  const CellCutter cutter{Solid<double>(MeshSDF<double>(shell))};
  const Level<double> level({-0.5, -0.5, -0.5}, {0.125, 0.125, 0.125});
  const auto cells = cutter.cut(GridPatch<double>{level, IndexBox::ofSize(8, 8, 8)});
  std::size_t inCavity = 0;
  const auto useCavity = [&](const Index3& cell, bool isCavity) {
    const double distance = length(cells.boxOf(cell).center());
    EXPECT_LE(std::abs(distance - (isCavity ? 0.3 : 0.4)), 0.11);
    inCavity += isCavity ? 1 : 0;
  };
  // [DOCS
  const CutRegions fluid(cells);
  for (std::uint32_t p = 0; p < cells.pieceCount; ++p) {
    const bool isCavity = !fluid.regions()[fluid.ofPiece(p)].goesOn;
    useCavity(cells.cells.index[cells.pieces.cell[p]], isCavity);
  }
  // DOCS]
  EXPECT_GT(inCavity, 50U);
}

TEST(DocsTest, PolyhedraOfLeaves) {
  const TemporaryFolder folder;
  const auto path = folder / "leaves.vtu";
  const Solid<double> hull(MeshSDF<double>(tessellation::icosphere(0.4, 2)));
  const CellCutter cutter(hull);
  const OctreeDomain<double> domain({-0.5, -0.5, -0.5}, 1, {1, 1, 1});
  const Octree<double> mesh(hull, domain, {.cut = 2});
  // [DOCS
  const CutLeaves withPolygons = cutter.cut(mesh, {.polygons = true});
  writePointData(path, cutCellMesh(withPolygons, mesh));
  // DOCS]
  EXPECT_GT(std::filesystem::file_size(path), 64 * withPolygons.pieces.cell.size());
}

TEST(DocsTest, SinglePrecision) {
  const CellCutter cutter{Solid<double>(MeshSDF<double>(tessellation::icosphere(0.4, 2)))};
  const auto cells = cutter.cut(cellsBetween({{{-1, 0, 1}, {-1, 0, 1}, {-1, 0, 1}}}));
  const auto useVolumes = [&](const auto& volumes, const auto& centroids, const auto& areas) {
    EXPECT_EQ(volumes.size(), centroids.size());
    EXPECT_EQ(areas[0], static_cast<float>(cells.arcs.area[0]));
  };
  // [DOCS
  const CutNumbers<float> numbers = inPrecision<float>(cells);
  useVolumes(numbers.pieces.volume, numbers.pieces.centroid, numbers.arcs.area);
  // DOCS]
}

TEST(DocsTest, PeriodicAxes) {
  const Solid<double> bed(MeshSDF<double>(tessellation::icosphere(0.4, 2)));
  const Level<double> level({0, 0, 0}, {0.125, 0.125, 0.125});
  double through = 0;
  const auto useFace = [&](const Index3& cell, double aperture) {
    if (cell.i == 0) through += aperture;
  };
  // [DOCS
  const CellCutter cutter(bed, FluidSide::Outside, {.period = {1, 1, 0}});
  const CutCells cells = cutter.cut(GridPatch<double>{level, IndexBox::ofSize(8, 8, 8)});
  for (std::uint32_t a = 0; a < cells.arcs.area.size(); ++a) {
    const auto [i, j, k] = cells.arcs.cell[a];  // above the face
    useFace({i % cells.grid.period[0], j % cells.grid.period[1], k}, cells.aperture(a));
  }
  // DOCS]
  EXPECT_GT(through, 8);
}

TEST(DocsTest, FilesOfCutCells) {
  const TemporaryFolder folder;
  const auto path = folder / "ball.cells";
  const CellCutter cutter{Solid<double>(MeshSDF<double>(tessellation::icosphere(0.4, 1)))};
  const auto cells = cutter.cut(cellsBetween({{{-1, 0, 1}, {-1, 0, 1}, {-1, 0, 1}}}));
  // [DOCS
  saveCutCells(path, cells);
  const CutCells loaded = loadCutCells(path);  // the same to the bit
  // DOCS]
  EXPECT_EQ(loaded.pieces.volume, cells.pieces.volume);
}

TEST(DocsTest, OnePieceACell) {
  const Solid<double> plate(MeshSDF<double>(tessellation::box({-1, -1, 0}, {1, 1, 1e-9})));
  const Level<double> level({-0.5, -0.5, -0.45}, {0.125, 0.125, 0.125});
  const auto cells = CellCutter(plate).cut(GridPatch<double>{level, IndexBox::ofSize(8, 8, 8)});
  // [DOCS
  const auto [single, lost] = merged(cells);  // or merged(cells, {.smallest = 0.01})
  // DOCS]
  EXPECT_EQ(lost.size(), 64U);
  EXPECT_EQ(check(single).multiPieceCells, 0U);
}

TEST(DocsTest, SolidsThatAreNoMeshes) {
  const Level<double> level({0, 0, 0}, {0.125, 0.125, 0.125});
  const auto indices = IndexBox::ofSize(8, 8, 8);
  double worst = 0;
  const auto useError = [&](const Index3&, double error) { worst = std::max(worst, error); };
  // [DOCS
  // Two tanks and the pipe between them; fluid inside.
  const Solid<double> tanks = Sphere<double>({0.3, 0.5, 0.5}, 0.17) |
                              Sphere<double>({0.7, 0.5, 0.5}, 0.2) |
                              Cylinder<double>({0.3, 0.5, 0.5}, {0.7, 0.5, 0.5}, 0.06);
  const SolidCutter cutter(tanks, FluidSide::Inside);  // {.points = 4}: errors of higher order
  const CutCells cells = cutter.cut(GridPatch<double>{level, indices});
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    useError(cells.cells.index[row], cells.cells.error[row]);
  }
  // DOCS]
  double widest = 0;
  const auto useBounds = [&](const Index3&, const Interval<double>& share) {
    widest = std::max(widest, share.upper - share.lower);
  };
  const auto refine = [](const Index3&, const Interval<double>&) {};
  // [DOCS
  const CertifiedCells certified = cutter.certified(cells, {.width = 0.05});
  for (std::uint32_t row = 0; row < cells.cellCount; ++row) {
    useBounds(cells.cells.index[row], certified.volumeFraction[row]);
  }
  for (const auto& [cell, share] : certified.doubtful) refine(cell, share);
  // DOCS]
  EXPECT_NEAR(widest, 0.045, 0.02);
  double load = 0;
  const auto pressureAt = [](const Vec3<double>& p) { return p.z - 0.5; };
  // [DOCS
  const CutCells withPoints = cutter.cut(GridPatch<double>{level, indices}, {.quadrature = true});
  const auto& wall = withPoints.quadrature.wall;
  for (std::uint32_t p = 0; p < withPoints.pieceCount; ++p) {
    for (std::size_t i = 0; i < wall.pointsOf(p).size(); ++i) {
      load += wall.weightsOf(p)[i] * pressureAt(wall.pointsOf(p)[i]);
    }
  }
  // DOCS]
  EXPECT_NEAR(load, 0, 1e-9);  // by symmetry, but for errors of the quadrature
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, 1e-2);
  const double balls = 4 * std::numbers::pi / 3 * (std::pow(0.17, 3) + std::pow(0.2, 3));
  EXPECT_GT(check(cells).fluidVolume, balls);
  EXPECT_LT(check(cells).fluidVolume, balls + 0.01);
}

}  // namespace
}  // namespace cutwater::test
