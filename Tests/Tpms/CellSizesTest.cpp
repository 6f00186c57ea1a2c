#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Tpms/CellSizes.hpp>

#include <gtest/gtest.h>

#include "Tpms/CellQuadrature.hpp"

namespace cutwater::test {
namespace {

TEST(CellSizesTest, CellsAreTheIntegralOfTheirNumberPerLength) {
  const std::vector<CellSizeAt<double>> knots{{-1, 0.5}, {0.5, 1}, {2, 0.25}, {2.5, 0.4}};
  const CellSizes<double> sizes(knots);
  for (const double x : {-4.0, -1.0, -0.3, 0.5, 1.1, 2.0, 2.2, 2.5, 7.0}) {
    EXPECT_NEAR(sizes.cellsUpTo(x), cellsByQuadrature(knots, x), 1e-14) << x;
  }
  EXPECT_EQ(sizes.perLength(), (Interval<double>{1, 4}));
  // The most in an interval: at its ends or at a knot within.
  EXPECT_NEAR(sizes.mostPerLength({-3, -2}), 2, 1e-12);
  EXPECT_NEAR(sizes.mostPerLength({0, 0.5}), 4.0 / 3, 1e-12);
  EXPECT_NEAR(sizes.mostPerLength({1.9, 2.4}), 4, 1e-12);
  EXPECT_NEAR(sizes.mostPerLength({3, 9}), 2.5, 1e-12);
  EXPECT_EQ(CellSizes<double>(0.5).cellsUpTo(3), 6);
}

TEST(CellSizesTest, CellsFarAwayHaveTheirSize) {
  const CellSizes<double> sizes(std::vector<CellSizeAt<double>>{{0, 1}, {100, 0.5}});
  // One cell at 90 is as long as it should be; by x / size(x) it would be far from that.
  const double there = 1 / (0.1 * 1 + 0.9 * 2);
  double end = 90;
  while (sizes.cellsUpTo(end) < sizes.cellsUpTo(90) + 1) end += 1e-4;
  EXPECT_NEAR(end - 90, there, 0.01 * there);
  const auto naive = [&](double x) { return x * (1 + x / 100); };
  EXPECT_GT(naive(90 + there) - naive(90), 1.4);
}

TEST(CellSizesTest, RefusesSizesThatAreNone) {
  using Sizes = std::vector<CellSizeAt<double>>;
  for (const double bad : {0.0, -1.0, std::nan(""), Box<double>::kInf, 1e-320}) {
    EXPECT_THROW(CellSizes<double>{bad}, Error) << bad;
    EXPECT_THROW((CellSizes<double>{Sizes{{0, 1}, {1, bad}}}), Error) << bad;
  }
  EXPECT_THROW((CellSizes<double>{Sizes{}}), Error);
  EXPECT_THROW((CellSizes<double>{Sizes{{0, 1}, {0, 2}}}), Error);
  EXPECT_THROW((CellSizes<double>{Sizes{{std::nan(""), 1}}}), Error);
}

}  // namespace
}  // namespace cutwater::test
