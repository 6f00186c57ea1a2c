#include <Cutwater/Adapters/Chombo.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>

#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

using Point = IndexTM<Real, GLOBALDIM>;
using Derivative = IndexTM<int, GLOBALDIM>;

ChomboIF around(const Solid<Real>& solid) {
  return ChomboIF({solid, FluidSide::Outside, {Real(0.01), Real(0.02), Real(0.03)}});
}

Point pointAt(Real x, Real y, Real z) {
  Point p;
  p[0] = x;
  p[1] = y;
  p[2] = z;
  return p;
}

/// Through the base, as Chombo asks.
GeometryService::InOut kindOf(const BaseIF& function, const RealVect& low, const RealVect& high) {
  EXPECT_TRUE(function.fastIntersection(low, high));
  return function.InsideOutside(low, high);
}

const Sphere<Real> kBall({0.5, 0.5, 0.5}, 0.25);

TEST(ChomboTest, IsNegativeInTheFluid) {
  const auto function = around(kBall);
  const BaseIF& base = function;
  EXPECT_EQ(base.value(RealVect(0.5, 0.5, 0.5)), Real(0.25));
  EXPECT_EQ(base.value(RealVect(0.5, 0.5, 0)), Real(-0.25));
  EXPECT_EQ(base.value(pointAt(0.5, 0.5, 0)), Real(-0.25));
  const ChomboIF within({kBall, FluidSide::Inside, {0.5, 0.5, 0.5}});
  EXPECT_EQ(within.value(RealVect(0.5, 0.5, 0.5)), Real(-0.25));
}

TEST(ChomboTest, KnowsFirstDerivatives) {
  const auto function = around(kBall);
  const auto p = pointAt(0.5, 0.5, 0);
  Derivative derivative;
  EXPECT_EQ(function.value(derivative, p), Real(-0.25));
  derivative[2] = 1;
  EXPECT_EQ(function.value(derivative, p), Real(1));
  derivative[2] = 0;
  derivative[1] = 1;
  EXPECT_EQ(function.value(derivative, p), Real(0));
  derivative[2] = 1;
  EXPECT_THROW(static_cast<void>(function.value(derivative, p)), std::runtime_error);
}

TEST(ChomboTest, ClassifiesBoxes) {
  const auto function = around(kBall);
  EXPECT_EQ(kindOf(function, {0, 0, 0}, {0.125, 1, 1}), GeometryService::Regular);
  EXPECT_EQ(kindOf(function, {0.375, 0.375, 0.375}, {0.625, 0.625, 0.625}),
            GeometryService::Covered);
  EXPECT_EQ(kindOf(function, {0, 0, 0}, {1, 1, 1}), GeometryService::Irregular);
  EXPECT_EQ(kindOf(function, {0, 0.375, 0.375}, {0.25, 0.625, 0.625}), GeometryService::Irregular)
      << "touches";
  const ChomboIF within({kBall, FluidSide::Inside, {0.5, 0.5, 0.5}});
  EXPECT_EQ(kindOf(within, {0, 0, 0}, {0.125, 1, 1}), GeometryService::Covered);
  EXPECT_EQ(kindOf(within, {0.375, 0.375, 0.375}, {0.625, 0.625, 0.625}), GeometryService::Regular);
}

// A plate a hundredth as thick as the box: no corner sees it.
TEST(ChomboTest, NeverCallsABoxRegularThatTheSurfaceTouches) {
  RandomPoints<Real> random(1);
  for (int n = 0; n < 500; ++n) {
    const Real at = Real(0.5) + Real(0.3) * random.next().x;
    const auto function =
        around(Cuboid<Real>({at, Real(0.1), Real(0.1)}, {at + Real(1e-3), Real(0.9), Real(0.9)}));
    const Real low = at - Real(0.099) * (1 + random.next().y) / 2;
    const RealVect lower(low, Real(0.45), Real(0.45));
    EXPECT_EQ(kindOf(function, lower, {low + Real(0.1), Real(0.55), Real(0.55)}),
              GeometryService::Irregular);
  }
}

TEST(ChomboTest, CopiesLiveOnTheirOwn) {
  std::unique_ptr<BaseIF> copy;
  {
    const auto function = around(kBall);
    copy.reset(function.newImplicitFunction());
  }
  EXPECT_EQ(copy->value(RealVect(0.5, 0.5, 0.5)), Real(0.25));
  EXPECT_EQ(kindOf(*copy, {0, 0, 0}, {1, 1, 1}), GeometryService::Irregular);
}

TEST(ChomboTest, RefusesTheWrongSide) {
  EXPECT_THROW(ChomboIF({kBall, FluidSide::Outside, {0.5, 0.5, 0.5}}), Error);
  EXPECT_THROW(ChomboIF({kBall, FluidSide::Inside, {0, 0, 0}}), Error);
}

}  // namespace
}  // namespace cutwater::test
