#pragma once

#include <Cutwater/Grid/OctreeCells.hpp>

#include <random>
#include <vector>

namespace cutwater::test {

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
inline OctreeCells<double> randomMesh(std::mt19937& random, int deepest, double lower, double width,
                                      unsigned percent = 60) {
  std::vector<OctreeCell> leaves;
  addRandomLeaves(random, {}, 0, deepest, percent, leaves);
  return {OctreeDomain<double>({lower, lower, lower}, width, {1, 1, 1}), deepest, leaves};
}

}  // namespace cutwater::test
