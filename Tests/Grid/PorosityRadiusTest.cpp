#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Repetition.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <numbers>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

using std::numbers::pi;

template <typename T>
class PorosityRadiusTest : public ::testing::Test {
 protected:
  const Box<T> cube{{0, 0, 0}, {1, 1, 1}};
  const PorosityRadiusOptions options{.tolerance = 0.05,
                                      .volume = {.fraction = 0.01, .isEstimated = false}};

  static Solid<T> ballOf(T radius) { return Sphere<T>({T(0.5), T(0.5), T(0.5)}, radius); }
};
TYPED_TEST_SUITE(PorosityRadiusTest, Precisions);

TYPED_TEST(PorosityRadiusTest, EnclosesTheRadiusOfABall) {
  using T = TypeParam;
  for (const double radius : {0.2, 0.3123, 0.47}) {
    const double porosity = 1 - 4 * pi / 3 * std::pow(radius, 3);
    const auto found = porosityRadius<T>(porosity, &TestFixture::ballOf, {T(0.01), T(0.5)},
                                         this->cube, this->options);
    EXPECT_LE(found.radius.lower, radius);
    EXPECT_GE(found.radius.upper, radius);
    // Porosities closer than 0.01 are not told apart.
    const double width = 0.05 * 0.49 + 0.0201 / (4 * pi * radius * radius);
    EXPECT_LE(found.radius.upper - found.radius.lower, width);
    EXPECT_TRUE(found.looksMonotone);
    EXPECT_GT(found.solids, 4);
  }
}

TYPED_TEST(PorosityRadiusTest, TakesFamiliesThatGrowAsTheirPorosityDoes) {
  using T = TypeParam;
  const auto hollow = [](T radius) { return ~TestFixture::ballOf(radius); };
  const double porosity = 4 * pi / 3 * 0.027;
  const auto found =
      porosityRadius<T>(porosity, hollow, {T(0.05), T(0.5)}, this->cube, this->options);
  EXPECT_LE(found.radius.lower, 0.3);
  EXPECT_GE(found.radius.upper, 0.3);
  EXPECT_LT(found.radius.upper - found.radius.lower, 0.05);
  EXPECT_TRUE(found.looksMonotone);
}

TYPED_TEST(PorosityRadiusTest, FindsTheBeamsOfASimpleCubicLattice) {
  using T = TypeParam;
  // Three cylinders along the axes that meet: 3 pi r^2 - 8 sqrt(2) r^3 of the unit cell.
  const auto lattice = [](T radius) -> Solid<T> {
    const auto along = [=](Vec3<T> axis) {
      return InfiniteCylinder<T>({T(0.5), T(0.5), T(0.5)}, axis, radius);
    };
    return along({1, 0, 0}) | along({0, 1, 0}) | along({0, 0, 1});
  };
  constexpr double kRadius = 0.2;
  const double porosity = 1 - 3 * pi * 0.04 + 8 * std::numbers::sqrt2 * 0.008;
  auto coarse = this->options;
  coarse.volume.fraction = 0.02;
  const auto found = porosityRadius<T>(porosity, lattice, {T(0.02), T(0.45)}, this->cube, coarse);
  EXPECT_LE(found.radius.lower, kRadius);
  EXPECT_GE(found.radius.upper, kRadius);
  EXPECT_LT(found.radius.upper - found.radius.lower, 0.05);
}

TYPED_TEST(PorosityRadiusTest, TellsOfFamiliesThatAreNotMonotone) {
  using T = TypeParam;
  // Shrinks to almost nothing in the middle, and grows again.
  const auto waves = [](T x) { return TestFixture::ballOf(T(0.25) + T(0.2) * std::sin(8 * x)); };
  const auto found = porosityRadius<T>(0.7, waves, {T(0.3), T(1)}, this->cube, this->options);
  const auto porosityAt = [&](T x) {
    return 1 - 4 * pi / 3 * std::pow(0.25 + 0.2 * std::sin(8 * double{x}), 3);
  };
  EXPECT_LE((porosityAt(found.radius.lower) - 0.7) * (porosityAt(found.radius.upper) - 0.7), 0);
  EXPECT_FALSE(found.looksMonotone);
}

TYPED_TEST(PorosityRadiusTest, RefusesRangesWithoutTheRadius) {
  using T = TypeParam;
  const auto refuses = [&](double porosity, const Interval<T>& range,
                           const PorosityRadiusOptions& given) {
    EXPECT_THROW((void)porosityRadius<T>(porosity, &TestFixture::ballOf, range, this->cube, given),
                 Error);
  };
  refuses(0.5, {T(0.1), T(0.3)}, this->options);
  refuses(0.999, {T(0.1), T(0.3)}, this->options);
  refuses(0.9, {T(0.3), T(0.1)}, this->options);
  refuses(0.9, {T(0.1), std::numeric_limits<T>::infinity()}, this->options);
  refuses(0.9, {T(0.1), T(0.4)}, {.tolerance = 0});
  refuses(0.9, {T(0.1), T(0.4)}, {.volume = {.cells = 0}});
  refuses(0.9, {T(0.1), T(0.4)}, {.samples = -1});
}

}  // namespace
}  // namespace cutwater::test
