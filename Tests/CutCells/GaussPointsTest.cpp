#include <Cutwater/CutCells/Detail/Quadrature/GaussPoints.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(GaussPointsTest, AreExactForPolynomialsUpToTheirDegree) {
  for (int points = 1; points <= kMostGaussPoints; ++points) {
    for (int degree = 0; degree <= 2 * points; ++degree) {
      double sum = 0;
      for (const auto& g : gaussPoints(points)) sum += g.weight * std::pow(g.at, degree);
      const double off = std::abs(sum - 1.0 / (degree + 1));
      if (degree < 2 * points) {
        EXPECT_LT(off, 1e-15) << points << " points, degree " << degree;
      } else {
        EXPECT_GT(off, 1e-8) << points;
      }
    }
  }
}

TEST(GaussPointsTest, AscendAndHavePositiveWeights) {
  for (int points = 1; points <= kMostGaussPoints; ++points) {
    ASSERT_EQ(gaussPoints(points).size(), static_cast<std::size_t>(points));
    double before = 0;
    for (const auto& g : gaussPoints(points)) {
      EXPECT_GT(g.at, before);
      EXPECT_GT(g.weight, 0);
      before = g.at;
    }
    EXPECT_LT(before, 1);
  }
}

}  // namespace
}  // namespace cutwater::test
