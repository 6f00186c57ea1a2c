#pragma once

#include <Cutwater/Mesh/MeshSDF.hpp>

#include <random>

#include "Support/VoxelSolid.hpp"

namespace cutwater::test {

inline MeshSDF<double> meshOf(const VoxelSolid& solid) {
  const auto surface = solid.surface();
  PolygonSoup soup;
  soup.points = surface.positions;
  soup.patchNames = {"all"};
  for (const auto& t : surface.triangles) soup.addPolygon(t);
  return MeshSDF<double>(soup);
}

/// Of 11^3 voxels of width 1/16, with a random share of them filled.
inline VoxelSolid randomVoxels(std::mt19937& random) {
  VoxelSolid solid(1.0 / 16);
  const auto share = 20 + random() % 60;
  for (int x = 1; x < 12; ++x) {
    for (int y = 1; y < 12; ++y) {
      for (int z = 1; z < 12; ++z) {
        if (random() % 100 < share) solid.add({x, y, z});
      }
    }
  }
  solid.close(12);
  return solid;
}

}  // namespace cutwater::test
