#include <Cutwater/Render/Detail/ColorMap.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

/// CIE 1976 lightness, 0 to 100: not the space the map was made in.
double lightness(const Rgb& c) {
  const auto linear = [](std::uint8_t v) {
    const double s = v / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColorMapTest, BlueInsideWarmOutside) {
  for (const double depth : {0.0001, 0.3, 0.7, 1.0}) {
    const auto inside = detail::signedDistanceColor(-depth);
    const auto outside = detail::signedDistanceColor(depth);
    EXPECT_GT(inside.blue, inside.red + 40) << depth;
    EXPECT_GT(outside.red, outside.blue + 10) << depth;
  }
  EXPECT_EQ(detail::signedDistanceColor(0), detail::signedDistanceColor(1e-9));  // 0 is outside
  EXPECT_EQ(detail::signedDistanceColor(-3), detail::signedDistanceColor(-1));
  EXPECT_EQ(detail::signedDistanceColor(3), detail::signedDistanceColor(1));
}

TEST(ColorMapTest, EqualStepsLookEqual) {
  for (const double side : {-1.0, 1.0}) {
    const double total = lightness(detail::signedDistanceColor(side * 1e-6)) -
                         lightness(detail::signedDistanceColor(side));
    EXPECT_GT(total, 40);
    for (int i = 0; i < 10; ++i) {
      const double step = lightness(detail::signedDistanceColor(side * (0.1 * i + 1e-6))) -
                          lightness(detail::signedDistanceColor(side * 0.1 * (i + 1)));
      EXPECT_NEAR(step, total / 10, 0.35 * total / 10) << side << ' ' << i;
    }
  }
}

TEST(ColorMapTest, TheSurfaceIsAStepInLightness) {
  EXPECT_GT(
      lightness(detail::signedDistanceColor(0)) - lightness(detail::signedDistanceColor(-1e-9)),
      10);
}

TEST(ColorMapTest, MoreFluidIsLighterByEqualSteps) {
  const auto at = [](double share) { return lightness(detail::fluidFractionColor(share)); };
  const double total = at(1) - at(0);
  EXPECT_GT(total, 60);
  for (int i = 0; i < 10; ++i) {
    EXPECT_NEAR(at(0.1 * (i + 1)) - at(0.1 * i), total / 10, 0.35 * total / 10) << i;
  }
  EXPECT_EQ(detail::fluidFractionColor(-1), detail::fluidFractionColor(0));
  EXPECT_EQ(detail::fluidFractionColor(2), detail::fluidFractionColor(1));
}

}  // namespace
}  // namespace cutwater::test
