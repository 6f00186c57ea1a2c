#include <Cutwater/Surface/Detail/LeafBoxes.hpp>

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

TEST(LeafBoxesTest, LosesNoBoxThatMeetsAndFindsFewOthers) {
  std::mt19937 engine(5);
  RandomPoints<double> random(1, 6);
  std::size_t met = 0;
  std::size_t found = 0;
  for (int round = 0; round < 3000; ++round) {
    // Leaves of all sizes, near the origin and far from it; every fourth side is on a grid, so that
    // boxes touch.
    const double size = std::ldexp(1.0, -static_cast<int>(engine() % 60));
    const Vec3<double> middle = random.next();
    const auto corner = [&] {
      const Vec3<double> p = random.next();
      if (engine() % 4 != 0) return middle + size * p;
      return middle + size * Vec3<double>{std::round(p.x), std::round(p.y), std::round(p.z)};
    };
    std::vector<Box<double>> boxes(1 + engine() % 16);
    for (auto& box : boxes) {
      if (engine() % 8 != 0) box.extend(corner()).extend(corner());
    }
    const LeafBoxes leaf(boxes);
    const Box<double> other = Box<double>{}.extend(corner()).extend(corner());
    const auto lanes = leaf.meeting(other);
    EXPECT_EQ(lanes >> boxes.size(), 0U);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const bool isFound = (lanes >> k & 1U) != 0;
      if (boxes[k].overlaps(other)) {
        EXPECT_TRUE(isFound);
        ++met;
      } else if (boxes[k].empty()) {
        EXPECT_FALSE(isFound);
      }
      found += isFound ? 1U : 0U;
    }
  }
  EXPECT_GT(met, 1000U);
  EXPECT_LT(found, met + met / 50);
}

TEST(LeafBoxesTest, ALeafWithoutTrianglesMeetsNothing) {
  const LeafBoxes leaf({});
  EXPECT_EQ(leaf.meeting({{-1, -1, -1}, {1, 1, 1}}), 0U);
}

}  // namespace
}  // namespace cutwater::test
