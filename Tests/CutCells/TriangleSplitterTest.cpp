#include <Cutwater/CutCells/Detail/Tiles/TriangleSplitter.hpp>

#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using Cell = std::array<std::int32_t, 3>;

/// Planes at 0, 1, ... 4 along each axis.
struct Grid {
  std::vector<double> positions{0, 1, 2, 3, 4};
  GridPlanes planes{{positions, positions, positions}};
};

std::map<Cell, Fragment> split(const Grid& grid, const std::array<Vec3<double>, 3>& corners,
                               const std::array<std::uint32_t, 3>& vertices = {0, 1, 2}) {
  std::array<MovedVertex, 3> triangle;
  for (std::size_t i = 0; i < 3; ++i) triangle[i].position = corners[i];
  std::map<Cell, Fragment> result;
  TriangleSplitter(grid.planes).split(triangle, vertices, [&](const Fragment& fragment) {
    EXPECT_TRUE(result.emplace(fragment.cell, fragment).second);
  });
  return result;
}

Vec3<double> areaOf(const Fragment& fragment) {
  Vec3<double> sum;
  for (std::size_t i = 2; i < static_cast<std::size_t>(fragment.size); ++i) {
    sum += 0.5 * cross(fragment.points[i - 1] - fragment.points[0],
                       fragment.points[i] - fragment.points[0]);
  }
  return sum;
}

TEST(TriangleSplitterTest, LeavesATriangleInOneCellAsItIs) {
  const std::array<Vec3<double>, 3> corners{{{1.1, 2.2, 3.3}, {1.9, 2.1, 3.2}, {1.5, 2.7, 3.9}}};
  const auto parts = split(Grid(), corners);
  ASSERT_EQ(parts.size(), 1U);
  const auto& [cell, part] = *parts.begin();
  EXPECT_EQ(cell, (Cell{1, 2, 3}));
  ASSERT_EQ(part.size, 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(part.points[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>(i)]);
    EXPECT_EQ(part.edges[static_cast<std::size_t>(i)], (FragmentEdge{-1, i}));
  }
}

TEST(TriangleSplitterTest, CutsAtAPlaneInTheMiddle) {
  const auto parts = split(Grid(), {{{0.5, 0.25, 0.5}, {1.5, 0.25, 0.5}, {0.5, 0.75, 0.5}}});
  ASSERT_EQ(parts.size(), 2U);
  const auto& left = parts.at({0, 0, 0});
  const auto& right = parts.at({1, 0, 0});
  EXPECT_EQ(left.size, 4);
  EXPECT_EQ(right.size, 3);
  EXPECT_EQ(areaOf(left), (Vec3<double>{0, 0, 0.1875}));
  EXPECT_EQ(areaOf(right), (Vec3<double>{0, 0, 0.0625}));
  EXPECT_EQ(left.points[1], (Vec3<double>{1, 0.25, 0.5}));
  EXPECT_EQ(left.edges[1], (FragmentEdge{0, 1}));  // the plane x = 1
}

TEST(TriangleSplitterTest, TriangleInAPlaneGoesToTheSideItIsMovedTo) {
  std::array<MovedVertex, 3> triangle{{{.position = {1.25, 1.25, 2}},
                                       {.position = {1.75, 1.25, 2}},
                                       {.position = {1.25, 1.75, 2}}}};
  for (const int side : {1, -1}) {
    for (auto& vertex : triangle) vertex.shift[2] = static_cast<std::int8_t>(side);
    std::vector<Cell> cells;
    const Grid grid;
    TriangleSplitter(grid.planes).split(triangle, {0, 1, 2}, [&](const Fragment& fragment) {
      cells.push_back(fragment.cell);
    });
    EXPECT_EQ(cells, (std::vector<Cell>{{1, 1, side == 1 ? 2 : 1}}));
  }
}

TEST(TriangleSplitterTest, LeavesOutWhatIsBeyondTheGrid) {
  const auto parts = split(Grid(), {{{-5, 0.5, 0.5}, {9, 0.5, 0.5}, {-5, 0.5, 0.75}}});
  EXPECT_EQ(parts.size(), 4U);
  EXPECT_TRUE(split(Grid(), {{{-5, 5, 0.5}, {9, 6, 0.5}, {-5, 7, 0.75}}}).empty());
}

TEST(TriangleSplitterTest, PartsAddUpToTheTriangle) {
  RandomPoints<double> random(1.99, 1);
  const Grid grid;
  for (int n = 0; n < scaled(2000); ++n) {
    std::array<Vec3<double>, 3> corners;
    for (auto& corner : corners) corner = Vec3<double>{2, 2, 2} + random.next();
    Vec3<double> sum;
    for (const auto& [cell, part] : split(grid, corners)) {
      sum += areaOf(part);
      for (std::size_t i = 0; i < static_cast<std::size_t>(part.size); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
          const double low = cell[static_cast<std::size_t>(axis)];
          EXPECT_GE(part.points[i][axis], low);
          EXPECT_LE(part.points[i][axis], low + 1);
        }
      }
    }
    const auto whole = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
    EXPECT_LT(length(sum - whole), 1e-14 * 16);
  }
}

TEST(TriangleSplitterTest, TrianglesAtAnEdgeComputeTheSamePointsOnIt) {
  RandomPoints<double> random(2, 2);
  const Grid grid;
  const auto pointsOnEdge = [&](const std::array<Vec3<double>, 3>& corners,
                                const std::array<std::uint32_t, 3>& vertices, int edge) {
    std::map<Cell, std::vector<Vec3<double>>> result;
    for (const auto& [cell, part] : split(grid, corners, vertices)) {
      const auto size = static_cast<std::size_t>(part.size);
      for (std::size_t i = 0; i < size; ++i) {
        if (part.edges[i] != FragmentEdge{-1, edge}) continue;
        result[cell] = {part.points[i], part.points[(i + 1) % size]};
      }
    }
    return result;
  };
  for (int n = 0; n < scaled(2000); ++n) {
    std::array<Vec3<double>, 4> p;
    for (auto& point : p) point = Vec3<double>{2, 2, 2} + random.next();
    const auto forwards = pointsOnEdge({p[0], p[1], p[2]}, {7, 3, 5}, 0);
    auto backwards = pointsOnEdge({p[3], p[1], p[0]}, {9, 3, 7}, 1);
    for (auto& [cell, ends] : backwards) std::swap(ends[0], ends[1]);
    EXPECT_EQ(forwards, backwards);
  }
}

}  // namespace
}  // namespace cutwater::test
