#include <Cutwater/Adapters/Amrex.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "CutCells.hpp"
#include "Support/Grid.hpp"

namespace cutwater::test {
namespace {

using amrex::Box;
using amrex::IntVect;
constexpr auto kCpu = amrex::RunOn::Cpu;

/// A plane through a sphere, above its middle: a disc.
constexpr double kZ = 0.6;
const Sphere<double> kBall({0.5012, 0.4987, 0.5031}, 0.3);
const double kDiscSquared = 0.09 - (kZ - 0.5031) * (kZ - 0.5031);

amrex::Geometry unitSquare(int n) {
  return {Box(IntVect(0), IntVect(n - 1)), {0, 0}, {1, 1}};
}

AmrexShop shop(double z = kZ) {
  return AmrexShop({kBall, FluidSide::Outside, {0.01, 0.01, z}}, z);
}

TEST(Amrex2DTest, FunctionIsThatOfThePlane) {
  const AmrexFunction function({kBall, FluidSide::Inside, {0.5, 0.5, kZ}}, kZ);
  EXPECT_EQ(function({0.1, 0.7}), kBall.signedDistance({0.1, 0.7, kZ}));
}

TEST(Amrex2DTest, CutCellsFollowTheDisc) {
  for (const int n : {16, 32, 64, 128, 256}) {
    const auto geometry = unitSquare(n);
    const auto at = shop();
    const CutCells result(at, geometry, 16);
    std::size_t cut = 0;
    forEachIndex(IndexBox::ofSize(n, n, 1), [&](const Index3& cell) {
      int inDisc = 0;
      for (int corner = 0; corner < 4; ++corner) {
        const double x = (cell.i + (corner & 1)) / double(n) - 0.5012;
        const double y = (cell.j + (corner >> 1)) / double(n) - 0.4987;
        inDisc += x * x + y * y < kDiscSquared ? 1 : 0;
      }
      cut += 0 < inDisc && inDisc < 4 ? 1 : 0;
    });
    EXPECT_EQ(result.count(), cut);
    EXPECT_EQ(result.wrongIntercepts(), 0U);
    const double error = std::abs(result.fluidVolume() - (1 - std::numbers::pi * kDiscSquared));
    EXPECT_LT(error, 0.3 / n / std::sqrt(n));
  }
}

TEST(Amrex2DTest, BoxesAreClassifiedInThePlane) {
  const auto geometry = unitSquare(16);
  const Box middle({7, 7}, {9, 9});
  EXPECT_EQ(shop().getBoxType(middle, geometry, kCpu), AmrexShop::allcovered);
  EXPECT_EQ(shop().getBoxType({{0, 0}, {2, 2}}, geometry, kCpu), AmrexShop::allregular);
  EXPECT_EQ(shop().getBoxType({{0, 0}, {8, 8}}, geometry, kCpu), AmrexShop::mixedcells);
  EXPECT_EQ(shop(0.81).getBoxType(middle, geometry, kCpu), AmrexShop::allregular) << "above it";
}

TEST(Amrex2DTest, TagsCellsThatTheDiscsEdgeMeets) {
  constexpr int kCells = 40;
  for (const double z : {0.0, kZ}) {  // where thickness is the least number, and where it is none
    auto ball = kBall;
    ball.translate({0, 0, z - kZ});
    amrex::TagBoxArray tags({Box(IntVect(0), IntVect(kCells - 1))}, 0);
    tagCells(Refinement<double>{.cut = 1}, ball, tags, unitSquare(kCells), 0, z);
    std::size_t set = 0;
    forEachIndex(IndexBox::ofSize(kCells, kCells, 1), [&](const Index3& cell) {
      const auto range = [](int i, double center) {
        const double a = i / double(kCells) - center;
        const double b = (i + 1) / double(kCells) - center;
        const double least = a * b <= 0 ? 0 : std::min(a * a, b * b);
        return std::pair(least, std::max(a * a, b * b));
      };
      const auto [xLeast, xMost] = range(cell.i, 0.5012);
      const auto [yLeast, yMost] = range(cell.j, 0.4987);
      const bool isMet = xLeast + yLeast <= kDiscSquared && kDiscSquared <= xMost + yMost;
      const bool isSet = tags.fabs()[0].array()(cell.i, cell.j, 0) == amrex::TagBox::SET;
      EXPECT_EQ(isSet, isMet) << cell.i << ' ' << cell.j;
      set += isSet ? 1 : 0;
    });
    EXPECT_GT(set, 60U);
  }
}

}  // namespace
}  // namespace cutwater::test
