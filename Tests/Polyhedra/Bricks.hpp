#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {

/// Unit cubes in a box at the origin, the ones along x first.
inline FluidMesh brick(const Index3& counts) {
  const Solid<double> away(Sphere<double>({99, 0, 0}, 0.1));
  const OctreeDomain<double> domain({0, 0, 0}, 1, counts);
  const Octree<double> octree(away, domain, Refinement<double>{});
  return fluidMesh(SolidCutter(away).cut(octree, {.polygons = true}), octree);
}

/// Cells are closed, edge by edge, and faces in order.
inline void expectClosed(const FluidMesh& mesh) {
  const auto report = check(mesh);
  EXPECT_EQ(report.openCells, 0U);
  EXPECT_EQ(report.disordered, 0U);
  EXPECT_EQ(report.repeatedCorners, 0U);
  EXPECT_LT(report.worstClosure, 1e-14);
  EXPECT_EQ(report.invertedCells, 0U);
}

inline void expectSame(const FluidMesh& mesh, const FluidMesh& other) {
  EXPECT_EQ(mesh.points, other.points);
  EXPECT_EQ(mesh.faces.owner, other.faces.owner);
  EXPECT_EQ(mesh.faces.neighbour, other.faces.neighbour);
  EXPECT_EQ(mesh.faces.first, other.faces.first);
  EXPECT_EQ(mesh.cells.volume, other.cells.volume);
  EXPECT_EQ(mesh.cells.leaf, other.cells.leaf);
  const auto areas = [](const FluidMesh& of, std::size_t face) {
    Vec3<double> area;
    const auto loop = of.faces.of(face);
    for (std::size_t k = 2; k < loop.size(); ++k) {
      const auto& a = of.points[loop[0]];
      area += cross(of.points[loop[k - 1]] - a, of.points[loop[k]] - a);
    }
    return area;
  };
  ASSERT_EQ(mesh.faces.count(), other.faces.count());
  for (std::size_t face = 0; face < mesh.faces.count(); ++face) {
    EXPECT_EQ(areas(mesh, face), areas(other, face));
  }
}

}  // namespace cutwater::test
