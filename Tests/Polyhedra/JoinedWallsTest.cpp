#include <Cutwater/Polyhedra/Detail/JoinedWalls.hpp>

#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

constexpr unsigned kAcrossZ = 4;
constexpr unsigned kAllAxes = 7;

/// A pyramid over a square, the inside of a dent, and one more point above it.
const std::vector<Vec3<double>> kPoints{{0, 0, 0}, {2, 0, 0}, {2, 2, 0},
                                        {0, 2, 0}, {1, 1, 1}, {0, 0, 2}};

CellWall dent() {
  return {.cell = 0,
          .parts = {{.patch = 3, .loops = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}}};
}

const std::vector<CornerLoop>& facesOf(const CellWall& wall) {
  return wall.parts.front().loops;
}

TEST(JoinedWallsTest, APatchHasOneFace) {
  auto wall = dent();
  joinWall(wall, 5, kAllAxes, kPoints, false);
  ASSERT_EQ(facesOf(wall).size(), 1U);
  EXPECT_EQ(facesOf(wall).front().size(), 4U);  // the square
}

TEST(JoinedWallsTest, PolygonsAreKeptOnRequest) {
  auto wall = dent();
  joinWall(wall, 5, kAllAxes, kPoints, true);
  EXPECT_EQ(facesOf(wall), facesOf(dent()));
}

TEST(JoinedWallsTest, NoCellHasFewerThanFourFaces) {
  auto wall = dent();
  joinWall(wall, 1, kAllAxes, kPoints, false);
  EXPECT_EQ(facesOf(wall).size(), 4U);
}

// A cell whose only faces lie across z: of a wall that were one face, nothing is seen along x or y.
TEST(JoinedWallsTest, CellsHaveAnExtentAlongAllAxes) {
  auto wall = dent();
  joinWall(wall, 5, kAcrossZ, kPoints, false);
  EXPECT_GT(facesOf(wall).size(), 1U);
  EXPECT_LT(facesOf(wall).size(), 5U);
  Vec3<double> seen;
  for (const auto& loop : facesOf(wall)) {
    Vec3<double> area;
    for (std::size_t k = 2; k < loop.size(); ++k) {
      area += cross(kPoints[loop[k - 1]] - kPoints[loop[0]], kPoints[loop[k]] - kPoints[loop[0]]);
    }
    seen += abs(area);
  }
  EXPECT_GT(seen.x, 1);
  EXPECT_GT(seen.y, 1);
}

TEST(JoinedWallsTest, LoopsAlongALineAreLeftOut) {
  CellWall wall{.cell = 0, .parts = {{.patch = 0, .loops = {{0, 5, 0}, {0, 1, 4}}}}};
  joinWall(wall, 5, kAllAxes, kPoints, false);
  EXPECT_EQ(facesOf(wall), (std::vector<CornerLoop>{{0, 1, 4}}));
}

}  // namespace
}  // namespace cutwater::test
