#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/Io/PointData.hpp>

#include "Rows.hpp"

namespace cutwater::test {
namespace {

void ask(const CutCells& cells) {
  constexpr std::size_t kMost = 100'000;  // more would only take longer
  const auto box = cells.grid.indices();
  if (box.count() > kMost) return;
  static_cast<void>(check(cells));
  static_cast<void>(coarsened(cells, {1, 1, 1}));
  static_cast<void>(merged(cells, {.smallest = 0.5}));
  if (!cells.firstWallPolygon.empty()) static_cast<void>(cutCellMesh(cells, true));
}

}  // namespace
}  // namespace cutwater::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace test = cutwater::test;
  test::readTwice(std::span(data, size), cutwater::cutCellsFrom, test::ask);
  return 0;
}
