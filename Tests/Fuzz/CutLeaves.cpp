#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/Io/PointData.hpp>

#include "Rows.hpp"

namespace cutwater::test {
namespace {

/// Some octree of so many leaves: roots in a row, the first of which is divided towards its lowest
/// corner as often as there are leaves for.
OctreeCells<double> octreeOf(std::size_t leaves) {
  constexpr int kMostDivisions = 8;
  const auto deepest = static_cast<int>(std::min<std::size_t>((leaves - 1) / 7, kMostDivisions));
  const auto roots = static_cast<int>(leaves) - 7 * deepest;
  std::vector<OctreeCell> cells;
  for (int level = deepest; level > 0; --level) {
    for (int child = level == deepest ? 0 : 1; child < 8; ++child) {
      cells.push_back({.index = {child & 1, child >> 1 & 1, child >> 2},
                       .level = static_cast<std::uint8_t>(level)});
    }
  }
  for (int root = deepest == 0 ? 0 : 1; root < roots; ++root) {
    cells.push_back({.index = {root, 0, 0}});
  }
  return {OctreeDomain<double>({0, 0, 0}, 1, {roots, 1, 1}), deepest, cells};
}

void ask(const CutLeaves& leaves) {
  constexpr std::size_t kMost = 1000;  // more would only take longer
  static_cast<void>(check(leaves));
  if (leaves.classes.empty() || leaves.classes.size() > kMost) return;
  const auto mesh = octreeOf(leaves.classes.size());
  static_cast<void>(CutRegions(leaves, mesh));
  static_cast<void>(merged(leaves, mesh, {.smallest = 0.5}));
  if (!leaves.firstWallPolygon.empty()) static_cast<void>(cutCellMesh(leaves, mesh, true));
}

}  // namespace
}  // namespace cutwater::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace test = cutwater::test;
  test::readTwice(std::span(data, size), cutwater::cutLeavesFrom, test::ask);
  return 0;
}
