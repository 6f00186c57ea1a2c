#include <Cutwater/CutCells/Detail/Quadrature/FewerPoints.hpp>

#include <array>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using Values = std::array<double, 6>;

/// 1, x, y, xx, xy, yy.
Values quadratic(double x, double y) {
  return {1, x, y, x * x, x * y, y * y};
}

/// Adds random points with random weights, on a line or in a square; expects that few are left,
/// which have the same integrals.
void expectFew(std::mt19937& random, std::size_t count, std::size_t most, bool isOnLine) {
  std::uniform_real_distribution<double> anywhere(-1, 1);
  std::uniform_real_distribution<double> weights(1e-3, 1);
  FewerPoints few(6);
  std::vector<Values> all;
  Values before{};
  for (std::size_t i = 0; i < count; ++i) {
    const double x = anywhere(random);
    all.push_back(quadratic(x, isOnLine ? 0.3 - 0.5 * x : anywhere(random)));
    const double weight = weights(random);
    for (std::size_t f = 0; f < 6; ++f) before[f] += weight * all.back()[f];
    few.add(all.back(), weight);
  }
  const auto kept = few.take();
  EXPECT_LE(kept.size(), most);
  Values after{};
  std::size_t next = 0;
  for (const auto& [point, weight] : kept) {
    ASSERT_GE(point, next);
    ASSERT_LT(point, count);
    next = point + 1;
    EXPECT_GT(weight, 0);
    for (std::size_t f = 0; f < 6; ++f) after[f] += weight * all[point][f];
  }
  for (std::size_t f = 0; f < 6; ++f) {
    EXPECT_NEAR(after[f], before[f], 1e-14 * static_cast<double>(1 + count));
  }
  EXPECT_TRUE(few.take().empty());
}

TEST(FewerPointsTest, AreNoMoreThanThereAreFunctions) {
  std::mt19937 random(3);
  for (const std::size_t count : {7U, 18U, 19U, 100U, 1000U}) {
    for (int round = 0; round < 20; ++round) expectFew(random, count, 6, false);
  }
}

/// There, of the six functions only three are linearly independent.
TEST(FewerPointsTest, AreFewerWhereFunctionsDependOnEachOther) {
  std::mt19937 random(4);
  for (const std::size_t count : {7U, 100U}) {
    for (int round = 0; round < 20; ++round) expectFew(random, count, 3, true);
  }
}

TEST(FewerPointsTest, FewAreLeftAsTheyAre) {
  FewerPoints few(6);
  for (int i = 0; i < 6; ++i) few.add(quadratic(0.1, 0.2), 1);
  EXPECT_EQ(few.take().size(), 6U);
  EXPECT_TRUE(few.take().empty());
  for (int i = 0; i < 7; ++i) few.add(quadratic(0.1, 0.2), 1);
  const auto kept = few.take();
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept.front().weight, 7);
}

}  // namespace
}  // namespace cutwater::test
