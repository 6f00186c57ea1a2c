#include <Cutwater/Adapters/BoxGrids.hpp>
#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

/// Boxes of a grid that grows along x, all or a random part of them, in any order, with coordinates
/// rounded anyhow.
std::vector<Box<double>> boxesOf(double share, std::mt19937& random) {
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<double> x{-0.3};
  for (int i = 0; i < 21; ++i) x.push_back(x.back() + 0.1 * (1 + 0.05 * i));
  const auto rounded = [&](double at) { return at + 1e-15 * (any(random) - 0.5); };
  std::vector<Box<double>> boxes;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    for (int j = 0; j < 9; ++j) {
      for (int k = 0; k < 3; ++k) {
        if (any(random) >= share) continue;
        boxes.push_back({{rounded(x[i]), rounded(0.2 * j), rounded(0.3 * k)},
                         {rounded(x[i + 1]), rounded(0.2 * (j + 1)), rounded(0.3 * (k + 1))}});
      }
    }
  }
  std::ranges::shuffle(boxes, random);
  return boxes;
}

Box<double> boxOf(const CellPlanes& grid, const Index3& cell) {
  Box<double> box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [at, first] =
        std::array{std::pair(cell.i, grid.first.i), std::pair(cell.j, grid.first.j),
                   std::pair(cell.k, grid.first.k)}[static_cast<std::size_t>(axis)];
    const auto& planes = grid.planes[static_cast<std::size_t>(axis)];
    const auto number = static_cast<std::size_t>(at - first);
    box.lower[axis] = planes.at(number + 1);
    box.upper[axis] = planes.at(number + 2);
  }
  return box;
}

TEST(BoxGridsTest, EveryBoxIsACellOfAGrid) {
  std::mt19937 random(5);
  for (const double share : {1.0, 0.5, 0.02}) {
    SCOPED_TRACE(share);
    auto boxes = boxesOf(share, random);
    std::vector<int> levels(boxes.size(), 3);
    boxes.push_back({{0, 0, 0}, {0.7, 0.3, 0.11}});  // of a level of its own
    levels.push_back(1);
    const auto [grids, places] = gridsOf(boxes, levels);
    ASSERT_EQ(places.size(), boxes.size());
    for (std::size_t n = 0; n < boxes.size(); ++n) {
      const auto& grid = grids.at(places[n].grid);
      ASSERT_TRUE(grid.indices().contains(places[n].cell));
      const auto box = boxOf(grid, places[n].cell);
      EXPECT_LT(length(box.lower - boxes[n].lower) + length(box.upper - boxes[n].upper), 1e-14);
    }
    std::size_t cells = 0;
    for (const auto& grid : grids) {
      EXPECT_LE(grid.indices().count(), 512U);
      cells += grid.indices().count();
    }
    if (share == 1) {
      EXPECT_EQ(cells, boxes.size());
      EXPECT_EQ(grids.size(), 3U * 2 * 1 + 1);
    }
  }
}

TEST(BoxGridsTest, NoCellLiesInAGap) {
  std::vector<Box<double>> boxes;
  for (const double x : {0.0, 1.0, 7.0, 8.0}) boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
  const std::vector<int> levels(boxes.size());
  const auto [grids, places] = gridsOf(boxes, levels);
  ASSERT_EQ(grids.size(), 2U);
  for (const auto& grid : grids) EXPECT_EQ(grid.indices().count(), 2U);
  EXPECT_EQ(places[1].grid, places[0].grid);
  EXPECT_EQ(places[3].grid, places[2].grid);
}

TEST(BoxGridsTest, OtherBoxesAreRefused) {
  const Box<double> unit{{0, 0, 0}, {1, 1, 1}};
  const std::vector shifted{unit, Box<double>{{0.5, 1, 0}, {1.5, 2, 1}}};
  const std::vector<int> levels(2);
  EXPECT_THROW(static_cast<void>(gridsOf(shifted, levels)), Error);
  EXPECT_THROW(static_cast<void>(gridsOf(std::vector{unit}, levels)), Error);
  EXPECT_THROW(static_cast<void>(gridsOf(std::vector{unit, Box<double>()}, levels)), Error);
  EXPECT_TRUE(gridsOf({}, {}).grids.empty());
}

}  // namespace
}  // namespace cutwater::test
