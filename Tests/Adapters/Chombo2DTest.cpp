#include <Cutwater/Adapters/Chombo.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

const Sphere<double> kBall({0.5, 0.5, 0.5}, 0.25);

TEST(Chombo2DTest, IsThatOfThePlane) {
  const ChomboIF function({kBall, FluidSide::Outside, {0, 0, 0.6}}, 0.6);
  EXPECT_EQ(function.value(RealVect(0.5, 0.7)), -kBall.signedDistance({0.5, 0.7, 0.6}));
  IndexTM<double, 2> p;
  p[0] = 0.5;
  p[1] = 0.7;
  EXPECT_EQ(function.value(p), -kBall.signedDistance({0.5, 0.7, 0.6}));
  IndexTM<int, 2> derivative;
  derivative[1] = 1;
  EXPECT_EQ(function.value(derivative, p), -kBall.gradient({0.5, 0.7, 0.6}).y);
}

TEST(Chombo2DTest, ClassifiesInThePlane) {
  const ChomboIF function({kBall, FluidSide::Outside, {0, 0, 0.6}}, 0.6);
  EXPECT_EQ(function.InsideOutside({0.4, 0.4}, {0.6, 0.6}), GeometryService::Covered);
  EXPECT_EQ(function.InsideOutside({0.4, 0.4}, {0.9, 0.6}), GeometryService::Irregular);
  EXPECT_EQ(function.InsideOutside({0, 0}, {0.2, 0.9}), GeometryService::Regular);
  const ChomboIF above({kBall, FluidSide::Outside, {0, 0, 0.76}}, 0.76);
  EXPECT_EQ(above.InsideOutside({0.4, 0.4}, {0.6, 0.6}), GeometryService::Regular);
}

}  // namespace
}  // namespace cutwater::test
