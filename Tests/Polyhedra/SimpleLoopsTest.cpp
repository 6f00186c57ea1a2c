#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

double areaOf(const CornerLoop& loop, const std::vector<Vec3<double>>& points) {
  double area = 0;
  for (std::size_t k = 2; k < loop.size(); ++k) {
    area += 0.5 * cross(points[loop[k - 1]] - points[loop[0]], points[loop[k]] - points[loop[0]]).z;
  }
  return area;
}

/// The areas of loops, ascending, none of which has a corner twice.
std::vector<double> areasOf(const CornerLoop& outline, const std::vector<Vec3<double>>& points) {
  std::vector<CornerLoop> loops;
  divideIntoLoops(outline, points, 2, loops);
  std::vector<double> areas;
  for (auto& loop : loops) {
    areas.push_back(areaOf(loop, points));
    std::ranges::sort(loop);
    EXPECT_EQ(std::ranges::adjacent_find(loop), loop.end());
  }
  std::ranges::sort(areas);
  return areas;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

TEST(SimpleLoopsTest, LeavesOutWhatGoesThereAndBack) {
  const auto cleaned = [](CornerLoop loop) {
    clean(loop);
    return loop;
  };
  EXPECT_EQ(cleaned({0, 1, 1, 2}), (CornerLoop{0, 1, 2}));
  EXPECT_EQ(cleaned({0, 1, 5, 1, 2}), (CornerLoop{0, 1, 2}));
  EXPECT_EQ(cleaned({0, 1, 5, 6, 5, 1, 2}), (CornerLoop{0, 1, 2}));
  EXPECT_EQ(cleaned({5, 0, 1, 2, 0}), (CornerLoop{0, 1, 2}));  // across the end
  EXPECT_EQ(cleaned({0, 1, 2, 0, 5}), (CornerLoop{0, 1, 2}));
  EXPECT_TRUE(cleaned({0, 1, 0, 1}).empty());
  EXPECT_TRUE(cleaned({0, 1}).empty());
}

const std::vector<Vec3<double>> kSquares{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},   // outside
                                         {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};  // a hole

TEST(SimpleLoopsTest, AHoleThatWasCutOpenIsCutOnceMore) {
  const auto areas = areasOf({0, 4, 7, 6, 5, 4, 0, 1, 2, 3}, kSquares);
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_GT(areas[0], 0);
  EXPECT_DOUBLE_EQ(sum(areas), 8);
}

TEST(SimpleLoopsTest, AHoleThatTouchesTheRimIsCut) {
  auto points = kSquares;
  points[4] = {0, 0, 0};  // the same as corner 0
  const auto areas = areasOf({0, 7, 6, 5, 0, 1, 2, 3}, points);
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_GT(areas[0], 0);
  EXPECT_DOUBLE_EQ(sum(areas), 9 - areaOf({0, 5, 6, 7}, points));
}

TEST(SimpleLoopsTest, PartsThatTouchAreTwo) {
  const std::vector<Vec3<double>> points{{0, 0, 0},  {1, 0, 0},   {1, 1, 0}, {0, 1, 0},
                                         {-2, 0, 0}, {-2, -1, 0}, {0, -1, 0}};
  EXPECT_EQ(areasOf({0, 1, 2, 3, 0, 4, 5, 6}, points), (std::vector<double>{1, 2}));
}

}  // namespace
}  // namespace cutwater::test
