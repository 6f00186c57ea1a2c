#include <Cutwater/CutCells/Detail/Surface/MovedSurface.hpp>

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "CutCells/RandomVoxels.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

// Every tie, against rational numbers: Oracle/CellSplittingTest.cpp.

TEST(MovedPredicatesTest, LinesAlongAllAxesGiveANodeTheSameWindingNumber) {
  std::mt19937 random(4);
  for (int n = 0; n < 4; ++n) {
    // Voxels on nodes, and between them.
    const double lower = n % 2 == 0 ? 0 : -0.0113;
    const auto surface = randomVoxels(random).surface();
    const MovedSurface moved(surface.positions, surface.triangles);
    int inside = 0;
    const auto along = [&] { return lower + static_cast<double>(random() % 12) / 16; };
    for (int node = 0; node < scaled(40); ++node) {
      const Vec3<double> p{along(), along(), along()};
      std::array<int, 3> windings{};
      for (std::uint32_t id = 0; id < moved.triangleCount(); ++id) {
        for (int axis = 0; axis < 3; ++axis) {
          windings[static_cast<std::size_t>(axis)] += riseBelowNode(moved.triangle(id), p, axis);
        }
      }
      EXPECT_EQ(windings[0], windings[2]);
      EXPECT_EQ(windings[1], windings[2]);
      EXPECT_TRUE(windings[2] == 0 || windings[2] == 1);
      inside += windings[2];
    }
    EXPECT_GT(inside, 3);
  }
}

}  // namespace
}  // namespace cutwater::test
