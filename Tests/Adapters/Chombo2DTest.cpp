#include <Cutwater/Adapters/Chombo.hpp>
#include <Cutwater/Adapters/ChomboCutCells.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <numbers>

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

TEST(Chombo2DTest, PiecesOfThePlane) {
  const ProblemDomain domain(::Box(IntVect(0), IntVect(15)));
  const Solid<double> ball = kBall;
  const ChomboCutCells cells(SolidCutter(ball), domain, RealVect(), 1.0 / 16, {.z = 0.6});
  BaseFab<int> kinds(domain.domainBox(), 1);
  Vector<IrregNode> nodes;
  cells.fillGraph(kinds, nodes, domain.domainBox(), domain.domainBox(), domain, RealVect(),
                  1.0 / 16, DataIndex());
  double fluid = 0;
  for (int j = 0; j < 16; ++j) {
    for (int i = 0; i < 16; ++i) {
      IntVect at(i);
      at[1] = j;
      fluid += kinds(at, 0) == 1 ? 1 : 0;
    }
  }
  for (const auto& node : nodes.constStdVector()) {
    fluid += node.m_volFrac;
    double open = 0;
    for (const auto& faces : node.m_areaFrac) {
      for (const double share : faces.constStdVector()) open += share;
    }
    EXPECT_GT(open, 0);
  }
  EXPECT_GT(nodes.size(), 20U);
  EXPECT_NEAR(fluid / 256, 1 - std::numbers::pi * (0.0625 - 0.01), 1e-6);
}

}  // namespace
}  // namespace cutwater::test
