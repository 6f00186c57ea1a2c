// The code of Docs/shapes.md.
#include <Cutwater/Sdf/FunctionSDF.hpp>

#include <gtest/gtest.h>

#include "OwnShape/Lens.hpp"
#include "Support/Guarantee.hpp"

namespace cutwater::test {
namespace {

TEST(LensTest, MatchesHandComputedValues) {
  const Lens lens(1, 0.6);  // the rim is a circle of radius 0.8
  EXPECT_DOUBLE_EQ(lens.signedDistance({0, 0, 0}), -0.4);
  EXPECT_DOUBLE_EQ(lens.signedDistance({0, 0, -1}), 0.6);
  EXPECT_DOUBLE_EQ(lens.signedDistance({0.9, 0, 0.6}), 0.5);
  EXPECT_DOUBLE_EQ(lens.signedDistance({0, -1.4, 0.25}), 0.65);  // from the rim
}

// [DOCS
TEST(LensTest, KeepsItsGuarantee) {
  const auto inside = [](const Vec3<double>& p) {
    return length(p - Vec3<double>{0, 0, 0.6}) < 1 && length(p + Vec3<double>{0, 0, 0.6}) < 1;
  };
  expectGuarantee(Lens(1, 0.6), /*extent=*/1.5, {.inside = inside});
}
// DOCS]

TEST(LensTest, RefusesWhatIsNoLens) {
  EXPECT_THROW(Lens(1, 1), Error);
  EXPECT_THROW(Lens(1, 0), Error);
  EXPECT_THROW(Lens(std::numeric_limits<double>::infinity(), 1), Error);
}

TEST(DocsTest, FunctionsOfOnesOwn) {
  // [DOCS
  // A wavy floor; its slope is at most 0.2 * 3, so values change by at most hypot(1, 0.6) a length.
  const auto height = [](const Vec3<double>& p) { return p.z - 0.2 * std::sin(3 * p.x); };
  const Guarantee<double> promise{.lipschitz = std::hypot(1, 0.6), .continuous = true, .size = 1};
  const FunctionSDF floor(height, promise);
  const BoxClass below = floor.classify({{-1, -1, -2}, {1, 1, -1.5}});  // Inside, certainly
  // DOCS]
  EXPECT_EQ(below, BoxClass::Inside);
  expectGuarantee(floor, /*extent=*/1.5);
}

}  // namespace
}  // namespace cutwater::test
