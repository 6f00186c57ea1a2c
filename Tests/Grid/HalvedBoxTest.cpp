#include <Cutwater/Grid/Detail/HalvedBox.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class HalvedBoxTest : public ::testing::Test {};
TYPED_TEST_SUITE(HalvedBoxTest, Precisions);

/// Sides of the box's first cell.
template <typename T>
Vec3<T> cellSize(const detail::HalvedBox<T>& grid) {
  return grid.cell({}).size();
}

TYPED_TEST(HalvedBoxTest, HalvesTheLongestSidesFirst) {
  using T = TypeParam;
  detail::HalvedBox<T> grid({{0, 0, 0}, {8, 1, 2}});
  const Vec3<T> sizes[] = {{4, 1, 2}, {2, 1, 2}, {1, 1, 1}, {T(0.5), T(0.5), T(0.5)}};
  const int children[] = {2, 2, 4, 8};
  for (int n = 0; n < 4; ++n) {
    ASSERT_TRUE(grid.divide());
    EXPECT_EQ(cellSize(grid), sizes[n]);
    EXPECT_EQ(grid.children(), children[n]);
  }
  EXPECT_EQ(grid.child({3, 5, 7}, 0), (Index3{6, 10, 14}));
  EXPECT_EQ(grid.child({3, 5, 7}, 6), (Index3{6, 11, 15}));
}

TYPED_TEST(HalvedBoxTest, CoversTheBoxToTheBit) {
  using T = TypeParam;
  // Coordinates that halving rounds; in double precision, -0.33 + (0.87 + 0.33) < 0.87.
  const Box<T> box{{T(-0.33), T(100.3), T(0.1)}, {T(0.87), T(100.4), T(1e-3) + T(0.1)}};
  detail::HalvedBox<T> grid(box);
  EXPECT_EQ(grid.cell({}), box);
  std::vector<Index3> cells{{0, 0, 0}};
  while (cells.size() < 20'000) {
    std::vector<Index3> next;
    const auto before = grid;
    ASSERT_TRUE(grid.divide());
    for (const auto& cell : cells) {
      Box<T> whole;
      double volume = 0;
      for (int n = 0; n < grid.children(); ++n) {
        next.push_back(grid.child(cell, n));
        const auto own = grid.cell(next.back());
        whole.extend(own);
        volume += detail::volumeOf(own);
      }
      // Children lie in their parent and fill it.
      EXPECT_EQ(whole, before.cell(cell));
      EXPECT_NEAR(volume, detail::volumeOf(whole), 1e-15 * volume);
    }
    cells.swap(next);
  }
  // Neighbours share faces.
  const auto a = grid.cell(cells[1234]);
  auto beside = cells[1234];
  ++beside.j;
  EXPECT_EQ(a.upper.y, grid.cell(beside).lower.y);
}

TYPED_TEST(HalvedBoxTest, EndsWhereIndicesEnd) {
  using T = TypeParam;
  detail::HalvedBox<T> grid({{0, 0, 0}, {1, 1, 1}});
  for (int n = 0; n < 30; ++n) EXPECT_TRUE(grid.divide());
  EXPECT_FALSE(grid.divide());
  EXPECT_EQ(cellSize(grid).x, std::ldexp(T(1), -30));
  EXPECT_EQ(grid.cell({(1 << 30) - 1, 0, 0}).upper.x, 1);
}

}  // namespace
}  // namespace cutwater::test
