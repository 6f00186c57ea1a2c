#pragma once

#include <Cutwater/Grid/OctreeCells.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <random>

namespace cutwater::test {

using Mesh = OctreeCells<double>;

inline void addRandomLeaves(std::mt19937& random, const Index3& index, int level, int deepest,
                            unsigned percent, std::vector<OctreeCell>& leaves) {
  if (level == deepest || random() % 100 >= percent) {
    leaves.push_back({.index = index, .level = static_cast<std::uint8_t>(level)});
    return;
  }
  for (int child = 0; child < 8; ++child) {
    addRandomLeaves(
        random,
        {2 * index.i + (child & 1), 2 * index.j + (child >> 1 & 1), 2 * index.k + (child >> 2)},
        level + 1, deepest, percent, leaves);
  }
}

/// A cube of one root, divided at random, not balanced.
inline Mesh randomMesh(std::mt19937& random, int deepest, double lower, double width,
                       unsigned percent = 60) {
  std::vector<OctreeCell> leaves;
  addRandomLeaves(random, {}, 0, deepest, percent, leaves);
  return {OctreeDomain<double>({lower, lower, lower}, width, {1, 1, 1}), deepest, leaves};
}

/// The same, with 100 leaves at least.
inline Mesh dividedMesh(std::mt19937& random, int deepest, double lower, double width,
                        unsigned percent = 60) {
  auto mesh = randomMesh(random, deepest, lower, width, percent);
  while (mesh.cells().size() < 100) mesh = randomMesh(random, deepest, lower, width, percent);
  return mesh;
}

inline Solid<double> turnedTorus() {
  Solid<double> solid(MeshSDF<double>(tessellation::torus(0.3, 0.1, 40, 20)));
  solid.rotate(33.0, Vec3<double>{1, 2, 3});
  solid.translate({0.51, 0.49, 0.47});
  return solid;
}

/// The cells of its finest level.
inline GridPatch<double> finestOf(const Mesh& mesh) {
  return {mesh.domain().level(mesh.deepest()), mesh.domain().indices(mesh.deepest())};
}

}  // namespace cutwater::test
