#pragma once

#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

namespace cutwater::test {

/// A turned mesh and a plate much thinner than cells, in one solid of two patches.
template <typename T>
Solid<T> ballAndPlate() {
  Solid<T> ball = MeshSDF<T>(tessellation::icosphere(0.8, 3));
  ball.rotate(20, {1, 2, 3});
  return named(ball, "ball") |
         named(Cuboid<T>({-1, -1, T(0.0401)}, {T(0.5), 1, T(0.0402)}), "plate");
}

/// Cells around it, down to a level.
template <typename T>
Octree<T> ballAndPlateMesh(int level, Balance balance = Balance::Corner) {
  const OctreeDomain<T> domain({T(-1.3), T(-1.2), T(-1.25)}, T(0.6), {4, 4, 5});
  return Octree<T>(ballAndPlate<T>(), domain, {.cut = level}, {.balance = balance});
}

/// Cells on the deepest level there is, in the domain's uppermost corner.
template <typename T>
Octree<T> deepMesh() {
  const OctreeDomain<T> domain({0, 0, 0}, 1, {16, 16, 3});
  const T tiny = std::ldexp(T(1), -17);
  return Octree<T>(Sphere<T>({16, 16, 3}, tiny), domain, {.cut = domain.deepest()});
}

}  // namespace cutwater::test
