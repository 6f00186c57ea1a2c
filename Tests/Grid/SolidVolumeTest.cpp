#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Repetition.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <numbers>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

using std::numbers::pi;

template <typename T>
class SolidVolumeTest : public ::testing::Test {
 protected:
  /// Not symmetric about any of the solids.
  const Box<T> box{{T(-1.31), T(-1.22), T(-1.24)}, {T(1.13), T(1.27), T(1.6)}};
  const T tiny = 1000 * std::numeric_limits<T>::epsilon();
};
TYPED_TEST_SUITE(SolidVolumeTest, Precisions);

template <typename T>
struct Known {
  Solid<T> solid;
  double volume;
  /// How far numbers of type T make it another solid.
  double error = 10 * std::numeric_limits<T>::epsilon();
};

template <typename T>
std::vector<Known<T>> knownSolids() {
  const auto ball = Sphere<T>({T(0.1), 0, 0}, T(0.7));
  const auto along = [](Vec3<T> axis) { return InfiniteCylinder<T>({0, 0, 0}, axis, T(0.5)); };
  return {{ball, 4 * pi / 3 * 0.343},
          {~ball, 2.44 * 2.49 * 2.84 - 4 * pi / 3 * 0.343},
          {Cuboid<T>({T(-0.69), T(-0.6), T(-0.5)}, {T(0.6), T(0.7), T(0.8)}), 1.29 * 1.3 * 1.3},
          {Torus<T>(T(0.7), T(0.25)), 2 * pi * pi * 0.7 * 0.0625},
          // Steinmetz' bicylinder, 16 r^3 / 3, and tricylinder, 8 (2 - sqrt(2)) r^3.
          {along({1, 0, 0}) & along({0, 1, 0}), 16 * 0.125 / 3},
          {along({1, 0, 0}) & along({0, 1, 0}) & along({0, 0, 1}),
           8 * (2 - std::numbers::sqrt2) * 0.125},
          // Endless ones, as far as they are in the box.
          {along({0, 0, 1}), pi * 0.25 * 2.84},
          {Plane<T>({0, 0, T(0.25)}, {0, 0, 1}), 2.44 * 2.49 * 1.49}};
}

TYPED_TEST(SolidVolumeTest, EnclosesClosedFormsAsCloselyAsAskedFor) {
  using T = TypeParam;
  for (const auto& [solid, volume, error] : knownSolids<T>()) {
    SCOPED_TRACE(solid.describe());
    for (const double fraction : {0.1, 0.02}) {
      const auto found = solidVolume(solid, this->box, {.fraction = fraction});
      EXPECT_LE(found.volume.lower, volume + error);
      EXPECT_GE(found.volume.upper, volume - error);
      EXPECT_LE(found.volume.upper - found.volume.lower, fraction * found.boxVolume);
      EXPECT_NEAR(found.boxVolume, 2.44 * 2.49 * 2.84, 1e-5);
      EXPECT_TRUE(found.isWithinTolerance);
      const auto [lower, upper] = found.porosity();
      EXPECT_NEAR(lower, 1 - found.volume.upper / found.boxVolume, 1e-12);
      EXPECT_NEAR(upper, 1 - found.volume.lower / found.boxVolume, 1e-12);
      EXPECT_LE(found.volume.lower, found.estimate);
      EXPECT_GE(found.volume.upper, found.estimate);
    }
    const auto found = solidVolume(solid, this->box, {.fraction = 0, .relative = 0.1});
    EXPECT_LE(found.volume.upper - found.volume.lower, 0.1 * volume);
    EXPECT_TRUE(found.isWithinTolerance);
  }
}

TYPED_TEST(SolidVolumeTest, EstimatesFarMoreCloselyThanItIsCertain) {
  using T = TypeParam;
  for (const auto& [solid, volume, error] : knownSolids<T>()) {
    SCOPED_TRACE(solid.describe());
    const auto found = solidVolume(solid, this->box, {.fraction = 0.01});
    EXPECT_NEAR(found.estimate, volume, 3e-4 * found.boxVolume + error);
  }
}

TYPED_TEST(SolidVolumeTest, HalvesWhatIsBetweenForFourTimesTheCells) {
  using T = TypeParam;
  const Sphere<T> ball({T(0.1), 0, 0}, T(0.7));
  double width = 0;
  std::size_t cells = 0;
  for (const double fraction : {0.08, 0.04, 0.02, 0.01, 0.005}) {
    const auto found = solidVolume(ball, this->box, {.fraction = fraction, .isEstimated = false});
    const double now = found.volume.upper - found.volume.lower;
    if (width > 0.04 * found.boxVolume) continue;
    if (cells > 0) {
      const double order = std::log(static_cast<double>(found.cells) / static_cast<double>(cells)) /
                           std::log(width / now);
      EXPECT_NEAR(order, 2, 0.6);
    }
    width = now;
    cells = found.cells;
  }
}

TYPED_TEST(SolidVolumeTest, SeesPlatesThatSamplesMiss) {
  using T = TypeParam;
  constexpr double kThickness = 1e-4;
  const Cuboid<T> plate({-1, -1, T(0.0123)}, {1, 1, T(0.0123 + kThickness)});
  // 100^3 samples in the box find nothing.
  int samples = 0;
  const auto size = this->box.size() / T(100);
  for (int k = 0; k < 100; ++k) {
    const T z = this->box.lower.z + (T(k) + T(0.5)) * size.z;
    samples += plate.signedDistance({0, 0, z}) < 0 ? 1 : 0;
  }
  EXPECT_EQ(samples, 0);
  const auto found = solidVolume(plate, this->box, {.fraction = 0.001});
  EXPECT_GT(found.volume.upper, 4 * kThickness);
  EXPECT_LE(found.volume.lower, 4 * kThickness * 1.001);
  const auto closer =
      solidVolume(plate, {{0, 0, T(0.012)}, {T(0.001), T(0.001), T(0.013)}}, {.fraction = 0.02});
  const double volume = 1e-6 * kThickness;
  EXPECT_GT(closer.volume.lower, 0.75 * volume);
  EXPECT_LE(closer.volume.lower, 1.001 * volume);
  EXPECT_GE(closer.volume.upper, 0.999 * volume);
}

TYPED_TEST(SolidVolumeTest, EnclosesVolumesOfMeshesByTheDivergenceTheorem) {
  using T = TypeParam;
  const auto soups = {tessellation::icosphere(0.8, 3), tessellation::torus(0.7, 0.3, 40, 20),
                      tessellation::capsule(0.4, 0.6, 24, 8)};
  for (const auto& soup : soups) {
    const double volume = measure(soup).volume;
    MeshSDF<T> mesh(soup);
    mesh.rotate(25, Vec3<T>{1, 2, 3});
    const auto found = solidVolume(mesh, this->box, {.fraction = 0.01});
    EXPECT_TRUE(found.isWithinTolerance);
    EXPECT_LE(found.volume.lower, volume);
    EXPECT_GE(found.volume.upper, volume);
    EXPECT_NEAR(found.estimate, volume, 5e-4 * found.boxVolume);
  }
}

TYPED_TEST(SolidVolumeTest, IsTheSameForAnyNumberOfThreads) {
  using T = TypeParam;
  const MeshSDF<T> mesh(tessellation::torus(0.7, 0.3, 40, 20));
  const Solid<T> shapes = Torus<T>(T(0.7), T(0.25)) - Sphere<T>({T(0.7), 0, 0}, T(0.3));
  for (const Solid<T>& solid : {Solid<T>(mesh), shapes}) {
    // To the end, and with a limit that ends it in the middle of a generation.
    for (const std::size_t cells : {10'000'000U, 5'003U}) {
      const VolumeOptions options{.fraction = 0.015, .cells = cells};
      auto one = options;
      one.threads = 1;
      auto two = options;
      two.threads = 2;
      const auto a = solidVolume(solid, this->box, one);
      const auto b = solidVolume(solid, this->box, two);
      EXPECT_EQ(a.volume, b.volume);
      EXPECT_EQ(a.estimate, b.estimate);
      EXPECT_EQ(a.cells, b.cells);
      EXPECT_EQ(a.isWithinTolerance, cells > 1'000'000);
      EXPECT_LE(a.cells, cells);
    }
  }
}

TYPED_TEST(SolidVolumeTest, KeepsToTheLimitOfCells) {
  using T = TypeParam;
  const Sphere<T> ball({T(0.1), 0, 0}, T(0.7));
  const double volume = 4 * pi / 3 * 0.343;
  double width = 100;
  for (const std::size_t cells : {1U, 8U, 9U, 500U, 2000U, 30'000U, 500'000U}) {
    const auto found = solidVolume(ball, this->box, {.fraction = 0, .cells = cells});
    EXPECT_FALSE(found.isWithinTolerance);
    EXPECT_LE(found.cells, cells);
    EXPECT_GT(found.cells + 8, std::min<std::size_t>(cells, 500'000));
    EXPECT_LE(found.volume.lower, volume);
    EXPECT_GE(found.volume.upper, volume);
    EXPECT_LE(found.volume.upper - found.volume.lower, width);
    width = found.volume.upper - found.volume.lower;
  }
}

TYPED_TEST(SolidVolumeTest, DecidesNothingThatIsNotKnown) {
  using T = TypeParam;
  const auto ball = [](const Vec3<T>& p) { return lengthSquared(p) - T(0.5); };
  const FunctionSDF unknown(ball, Guarantee<T>{});
  const auto found = solidVolume(unknown, this->box, {.cells = 10'000});
  EXPECT_EQ(found.volume.lower, 0);
  EXPECT_GE(found.volume.upper, found.boxVolume);
  EXPECT_EQ(found.porosity(), (Interval<double>{0, 1}));
  EXPECT_NEAR(found.estimate, 4 * pi / 3 * std::pow(0.5, 1.5), 0.02 * found.boxVolume);
}

TYPED_TEST(SolidVolumeTest, KnowsBoxesThatAreWhollyInsideOrOutside) {
  using T = TypeParam;
  const Sphere<T> ball({0, 0, 0}, 10);
  const auto inside = solidVolume(ball, this->box);
  EXPECT_EQ(inside.cells, 1U);
  EXPECT_NEAR(inside.volume.lower, inside.boxVolume, 1e-11);
  EXPECT_EQ(inside.solidFraction().upper, 1);
  EXPECT_NEAR(inside.porosity().upper, 0, 1e-12);
  const auto outside = solidVolume(ball, {{20, 0, 0}, {21, 1, 1}});
  EXPECT_EQ(outside.volume.lower, 0);
  EXPECT_NEAR(outside.volume.upper, 0, 1e-12);
}

TYPED_TEST(SolidVolumeTest, DividesLongBoxesIntoCubes) {
  using T = TypeParam;
  // A tube of 125 diameters.
  const InfiniteCylinder<T> tube({0, 0, 0}, {1, 0, 0}, T(0.4));
  const auto found =
      solidVolume(tube, {{-50, T(-0.5), T(-0.5)}, {50, T(0.5), T(0.5)}}, {.fraction = 0.2});
  EXPECT_TRUE(found.isWithinTolerance);
  EXPECT_LE(found.volume.lower, 100 * pi * 0.16);
  EXPECT_GE(found.volume.upper, 100 * pi * 0.16);
  EXPECT_NEAR(found.estimate, 100 * pi * 0.16, 0.4);
}

TYPED_TEST(SolidVolumeTest, RefusesWhatHasNoAnswer) {
  using T = TypeParam;
  const Sphere<T> ball({0, 0, 0}, 1);
  const auto refuses = [&](const Box<T>& given, const VolumeOptions& options = {}) {
    EXPECT_THROW((void)solidVolume(ball, given, options), Error);
  };
  refuses({});
  refuses(Box<T>::everywhere());
  refuses({{0, 0, 0}, {1, 1, 0}});
  if constexpr (std::is_same_v<T, double>) {
    refuses({{0, 0, 0}, {1e-81, 1, 1}});
    refuses({{0, 0, 0}, {1, 1, 1e81}});
    EXPECT_NO_THROW((void)solidVolume(ball, {{0, 0, 0}, {1e-79, 1e79, 1}}, {.cells = 10}));
  }
  refuses(this->box, {.fraction = -1});
  refuses(this->box, {.fraction = std::nan("")});
  refuses(this->box, {.relative = -1});
  refuses(this->box, {.cells = 0});
  refuses(this->box, {.threads = -1});
}

}  // namespace
}  // namespace cutwater::test
