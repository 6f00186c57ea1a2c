// Meshes of all patterns, and what fits between them.
#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>
#include <Cutwater/Tpms/TwoFluids.hpp>

#include "Support/ClosedSurface.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class PatternSurfacesTest : public ::testing::Test {};
TYPED_TEST_SUITE(PatternSurfacesTest, Precisions);

template <typename T>
constexpr T kSpacing = T(0.025);

/// A cell and a bit, not along the grid.
template <typename T>
Box<T> block() {
  return {{T(0.013), T(-0.021), T(0.037)}, {T(1.06), T(1.01), T(1.02)}};
}

/// Which leaves walls of some width, and channels.
template <typename T>
T levelOf(const TpmsPattern& pattern) {
  return static_cast<T>(0.7 *
                        std::min(pattern.pinch(TpmsChannel::A), pattern.pinch(TpmsChannel::B)));
}

template <typename T>
double meshedVolume(const Solid<T>& solid, const std::string& what) {
  const auto mesh =
      isosurface<T>(solid, nodesAround(block<T>(), kSpacing<T>), {.featureAngle = 40});
  expectClosed(mesh, what);
  return measure(mesh).volume;
}

/// A closed surface around what is certainly there. Gives its volume.
template <typename T>
double expectMesh(const Solid<T>& solid, const std::string& what) {
  const double volume = meshedVolume(solid, what);
  const auto certain = solidVolume(solid, block<T>(), {.fraction = 0.25});
  EXPECT_TRUE(certain.isWithinTolerance) << what;
  EXPECT_TRUE(certain.volume.contains(volume))
      << what << ": " << volume << " of " << certain.volume.lower << " to " << certain.volume.upper;
  EXPECT_NEAR(volume, certain.estimate, 0.006) << what;
  return volume;
}

TEST(ClippedPatternsTest, AreClosedAndOfTheCertainVolume) {
  using T = double;
  const Cuboid<T> box(block<T>());
  for (const auto& pattern : TpmsPattern::all()) {
    const TpmsField<T> field(pattern, T(1));
    const auto part = [&](TpmsPart which, T level) {
      return box & TpmsSolid<T>(field, which, level);
    };
    const T level = levelOf<T>(pattern);
    const auto& name = pattern.name();
    const double wall = expectMesh(part(TpmsPart::Wall, level), name + ", wall");
    const double a = expectMesh(part(TpmsPart::ChannelA, level), name + ", channel A");
    const double b = expectMesh(part(TpmsPart::ChannelB, level), name + ", channel B");
    // Each cuts off edges of the block of its own.
    const auto size = block<T>().size();
    EXPECT_NEAR(wall + a + b, double{size.x} * double{size.y} * double{size.z}, 0.012) << name;
    expectMesh(part(TpmsPart::ChannelA, 0), name + ", network");
  }
}

TYPED_TEST(PatternSurfacesTest, OfEndlessSolidsAreClosedWhereTheGridEnds) {
  using T = TypeParam;
  for (const auto& pattern : TpmsPattern::all()) {
    const TpmsField<T> field(pattern, T(1));
    double sum = 0;
    for (const auto part : {TpmsPart::Wall, TpmsPart::ChannelA, TpmsPart::ChannelB}) {
      sum += meshedVolume<T>(TpmsSolid<T>(field, part, levelOf<T>(pattern)), pattern.name());
    }
    const auto nodes = nodesAround(block<T>(), kSpacing<T>).indices;
    double cells = 1;
    for (int axis = 0; axis < 3; ++axis) cells *= static_cast<double>(nodes.length(axis) - 1);
    // Channels of the lidinoid are thin at this level.
    EXPECT_NEAR(sum, cells * std::pow(kSpacing<T>, 3), 0.01) << pattern.name();
  }
}

}  // namespace
}  // namespace cutwater::test
