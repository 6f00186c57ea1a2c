#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeRegions.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <numbers>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OctreeRegionsTest : public ::testing::Test {
 protected:
  [[nodiscard]] Octree<T> meshOf(const Solid<T>& solid, int level) const {
    const Refinement<T> rules{.cut = level};
    return {solid, domain, rules};
  }
  const OctreeDomain<T> domain{{T(-1.31), T(-1.22), T(-1.24)}, T(0.61), {4, 4, 4}};
};
TYPED_TEST_SUITE(OctreeRegionsTest, Precisions);

TYPED_TEST(OctreeRegionsTest, TellTheFluidInACavityFromThatOutside) {
  using T = TypeParam;
  const auto solid = Sphere<T>({0, 0, 0}, T(0.9)) - Sphere<T>({0, 0, 0}, T(0.6));
  const auto mesh = this->meshOf(solid, 4);
  const FluidRegions<T> fluid(mesh);
  ASSERT_EQ(fluid.regions().size(), 2U);
  const auto& outside = fluid.regions()[0];
  const auto& cavity = fluid.regions()[1];
  EXPECT_GT(length(outside.point), 0.9);
  EXPECT_LT(length(cavity.point), 0.6);
  const double ball = 4 * std::numbers::pi / 3 * std::pow(0.6, 3);
  EXPECT_LT(cavity.volume, ball);
  EXPECT_GT(cavity.volume, 0.7 * ball);
  EXPECT_EQ(outside.cells + cavity.cells, mesh.count(BoxClass::Outside));

  const auto left = fluid.unreached(mesh, {-1, -1, -1});
  std::vector<bool> isLeft(mesh.cells().size());
  for (const auto n : left) isLeft[n] = true;
  for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
    const auto& cell = mesh.cells()[n];
    const T radius = length(mesh.center(cell));
    if (cell.kind == BoxClass::Outside) {
      EXPECT_EQ(fluid.regionOf(n), radius < T(0.75) ? 1U : 0U);
      EXPECT_EQ(isLeft[n], radius < T(0.75));
    } else if (cell.kind == BoxClass::Inside) {
      EXPECT_EQ(fluid.regionOf(n), kNone);
      EXPECT_FALSE(isLeft[n]);
    } else if (fluid.regionOf(n) != kNone) {
      EXPECT_EQ(fluid.regionOf(n), radius < T(0.75) ? 1U : 0U);
    }
  }
  EXPECT_GT(fluid.unreached(mesh, {0, 0, 0}).size(), left.size());
}

TYPED_TEST(OctreeRegionsTest, DoNotLeakThroughAWallThinnerThanACell) {
  using T = TypeParam;
  const Solid<T> ball = Sphere<T>({0, 0, 0}, T(0.8));
  const auto skin = ball - Sphere<T>({0, 0, 0}, T(0.799));
  const auto mesh = this->meshOf(skin, 3);
  EXPECT_EQ(FluidRegions<T>(mesh).regions().size(), 2U);
  // A hole of several cells joins them.
  const auto open = skin - Cuboid<T>({T(-0.25), T(-0.25), 0}, {T(0.25), T(0.25), 1});
  EXPECT_EQ(FluidRegions<T>(this->meshOf(open, 3)).regions().size(), 1U);
}

TYPED_TEST(OctreeRegionsTest, RefusePointsThatAreNotInTheFluid) {
  using T = TypeParam;
  const auto mesh = this->meshOf(Sphere<T>({0, 0, 0}, T(0.8)), 3);
  const FluidRegions<T> fluid(mesh);
  EXPECT_THROW((void)fluid.unreached(mesh, {0, 0, 0}), Error);
  EXPECT_THROW((void)fluid.unreached(mesh, {9, 0, 0}), Error);
  EXPECT_TRUE(
      FluidRegions<T>(this->meshOf(Cuboid<T>({-9, -9, -9}, {9, 9, 9}), 1)).regions().empty());
}

TYPED_TEST(OctreeRegionsTest, EncloseTheVolumeEverMoreClosely) {
  using T = TypeParam;
  constexpr double kPi = std::numbers::pi;
  struct Case {
    Solid<T> solid;
    double volume;
    double projections;  ///< of the surface along x, y and z, front and back
  };
  const Case cases[] = {{Sphere<T>({T(0.1), 0, 0}, T(0.7)), 4 * kPi / 3 * 0.343, 6 * kPi * 0.49},
                        {Cuboid<T>({T(-0.69), T(-0.6), T(-0.5)}, {T(0.6), T(0.7), T(0.8)}),
                         1.29 * 1.3 * 1.3, 2 * (1.3 * 1.3 + 2 * 1.29 * 1.3)},
                        {Torus<T>(T(0.7), T(0.25)), 2 * kPi * kPi * 0.7 * 0.0625, 0}};
  for (const auto& [solid, volume, projections] : cases) {
    double last = 0;
    for (int level = 2; level <= 7; ++level) {
      const auto found = solidVolume(this->meshOf(solid, level));
      EXPECT_LE(found.lower, volume);
      EXPECT_GE(found.upper, volume);
      const double width = found.upper - found.lower;
      const double cell = 0.61 * std::ldexp(1.0, -level);
      // The volume of cells that a surface meets is its projections times their width, but for the
      // few with its rim: half of it on each further level.
      if (projections > 0 && level > 4) {
        EXPECT_NEAR(width / (projections * cell), 1, 0.1);
      }
      if (level > 3) {
        EXPECT_NEAR(last / width, 2, level > 5 ? 0.1 : 0.25);
      }
      last = width;
    }
    EXPECT_LT(last, 0.08 * volume);
  }
}

}  // namespace
}  // namespace cutwater::test
