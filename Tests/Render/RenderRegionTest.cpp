#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <numbers>

#include "BarePicture.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// What cuts and sides of regions leave, in square pixels.
template <typename T>
class RenderRegionTest : public ::testing::Test {};
TYPED_TEST_SUITE(RenderRegionTest, Precisions);

TYPED_TEST(RenderRegionTest, ACutHasTheAreaOfItsPlane) {
  using T = TypeParam;
  const Solid<T> hollow = Solid<T>(Sphere<T>({0, 0, 0}, 1)) - Sphere<T>({0, 0, 0}, T(0.6));
  auto options = bare(View::named("+z"));
  options.cuts = {CutPlane::across(2, 0.3)};
  options.cutColor = {255, 0, 0};
  options.color = Rgb{0, 0, 255};
  const auto image = render(hollow, options);
  double red = 0;
  for (const auto& pixel : image.pixels()) {
    if (pixel.red > 128 && pixel.blue < 100) red += 1;
  }
  const double area = std::numbers::pi * (1 - 0.36) / (pixelSize() * pixelSize());
  EXPECT_NEAR(red, area, 0.005 * area);
}

TYPED_TEST(RenderRegionTest, WhatIsCutAwayLeavesNoHalo) {
  using T = TypeParam;
  // Beyond the rim of the cut, just above its plane, the ball's side was close to the rays.
  const Sphere<T> ball({0, 0, 0}, 1);
  auto options = bare(View::named("+z"));
  options.cuts = {CutPlane::across(2, -0.98)};
  const double radius = std::sqrt(1 - 0.98 * 0.98) / pixelSize();
  EXPECT_NEAR(covered(render(ball, options)), std::numbers::pi * radius * radius, 0.2 * radius);
}

TYPED_TEST(RenderRegionTest, RegionsCutOffWhatIsUnbounded) {
  using T = TypeParam;
  const Plane<T> ground({0, 0, 0}, {0, 0, 1});
  auto options = bare(View::named("-y"));
  options.region = Box<double>{{-1, -1, -0.5}, {1, 1, 0.5}};
  options.cutColor = {255, 0, 0};
  const auto image = render(ground, options);
  EXPECT_NEAR(covered(image), 2 * 0.5 / (pixelSize() * pixelSize()), 400);
  EXPECT_GT(image.at(kWidth / 2, kHeight / 2 + 20).red, 180);
}

TYPED_TEST(RenderRegionTest, FarFromTheOriginNothingGrowsByRounding) {
  using T = TypeParam;
  const Vec3<double> center{1e4, 1e4, -1e4};
  const Sphere<T> ball(Vec3<T>(center), 1);
  auto options = bare(View::named("iso"));
  options.show.reset();
  options.region = Box<double>{center, center}.grown(1.2);
  options.show = options.region;
  options.cuts = {CutPlane::across(2, center.z + 0.5)};
  options.cutColor = {255, 0, 0};
  const auto image = render(ball, options);
  const auto frame = detail::RenderLayout(kWidth, kHeight, {}).frame();
  const double pixel = 2.4 * 2 * std::sqrt(2 / 3.0) / frame.height;
  // The cap that is cut off ends in the circle on the plane, which hides the ball's upper outline.
  const double face = std::numbers::pi * 0.75 * std::sqrt(1 / 3.0) / (pixel * pixel);
  double red = 0;
  for (const auto& color : image.pixels()) red += color.red > 180 && color.blue < 100 ? 1 : 0;
  EXPECT_NEAR(red, face, 0.03 * face);
  options.cuts.clear();
  EXPECT_NEAR(covered(render(ball, options)), std::numbers::pi / (pixel * pixel), 2 / pixel * 0.5);
}

TYPED_TEST(RenderRegionTest, WhatTouchesTheSidesOfTheRegionIsNotCut) {
  using T = TypeParam;
  const Cuboid<T> box({T(-0.61), -1, T(-0.33)}, {T(0.72), 1, T(0.41)});
  const auto sign = [&](const Vec3<T>& p) { return box.signedDistance(p) < 0 ? T(-1) : T(1); };
  const FunctionSDF signs(sign, Guarantee<T>{});
  auto options = bare(View::named("iso"));
  options.cutColor = {255, 0, 0};
  const auto red = [&](const SignedDistanceFunction<T>& solid, double end) {
    options.region = Box<double>{{-0.61, -1, -0.33}, {end, 1, 0.41}};
    std::size_t count = 0;
    const auto image = render(solid, options);
    for (const auto& color : image.pixels()) {
      count += color.red > color.blue + 40 ? 1 : 0;
    }
    return static_cast<double>(count);
  };
  EXPECT_EQ(red(box, 0.72), 0);
  EXPECT_EQ(red(signs, 0.72), 0);
  EXPECT_GT(red(box, 0.5), 1000);
  EXPECT_NEAR(red(signs, 0.5), red(box, 0.5), 100);
}

}  // namespace
}  // namespace cutwater::test
