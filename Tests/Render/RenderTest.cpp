#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/PatchColors.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <numbers>

#include "BarePicture.hpp"
#include "Colors.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// Pixels of a patch in the legend.
constexpr int kSwatch = 49;

double coverage(const Image& image, int x, int y) {
  const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width()) +
                     static_cast<std::size_t>(x);
  return image.opacities()[index] / 255.0;
}

double coveredInRow(const Image& image, int y) {
  double sum = 0;
  for (int x = 0; x < image.width(); ++x) {
    sum += coverage(image, x, y);
  }
  return sum;
}

/// Pixels of exactly this colour where legends stand.
int countInLegend(const Image& image, const Rgb& color) {
  int count = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = kWidth * 2 / 3; x < kWidth; ++x) count += image.at(x, y) == color ? 1 : 0;
  }
  return count;
}

template <typename T>
class RenderTest : public ::testing::Test {};
TYPED_TEST_SUITE(RenderTest, Precisions);

TYPED_TEST(RenderTest, ABallIsADisc) {
  const Sphere<TypeParam> ball({0, 0, 0}, 1);
  for (const auto* name : {"+x", "-z"}) {
    const auto image = render(ball, bare(View::named(name)));
    const double radius = 1 / pixelSize();
    EXPECT_NEAR(covered(image), std::numbers::pi * radius * radius, 2 * radius * 0.2) << name;
    for (int y = 60; y < kHeight - 60; y += 7) {
      const double height = y + 0.5 - 0.5 * kHeight;
      const double chord = 2 * std::sqrt(radius * radius - height * height);
      EXPECT_NEAR(coveredInRow(image, y), chord, 0.5) << y;
    }
  }
}

TEST(RenderSizesTest, LooksTheSameAtAnySize) {
  const auto dark = [](const Image& image) {
    return std::ranges::count_if(image.pixels(), [](const Rgb& c) { return c.red < 40; });
  };
  for (const double radius : {1.0, 1e-140, 1e40, 1e140}) {
    const Sphere<double> ball({0, 0, 0}, radius);
    auto options = bare(View::named("iso"));
    options.show = ball.boundingBox();
    const auto image = render(ball, options);
    const double pixels = covered(image);
    EXPECT_GT(pixels, 1000) << radius;
    EXPECT_LT(static_cast<double>(dark(image)), 0.02 * pixels) << radius;
  }
}

TYPED_TEST(RenderTest, ABoxAlongAnAxisIsARectangle) {
  using T = TypeParam;
  const Cuboid<T> box({T(-0.61), -1, T(-0.33)}, {T(0.72), 1, T(0.41)});
  const auto image = render(box, bare(View::named("-y")));
  const double width = 1.33 / pixelSize();
  int rows = 0;
  for (int y = 0; y < kHeight; ++y) {
    const double row = coveredInRow(image, y);
    if (row < width - 1) continue;
    ++rows;
    EXPECT_NEAR(row, width, 0.35) << y;
  }
  EXPECT_NEAR(rows, 0.74 / pixelSize(), 1.01);
  EXPECT_NEAR(covered(image), width * 0.74 / pixelSize(), 0.004 * covered(image));
}

TYPED_TEST(RenderTest, ThinPlatesSeenFromTheSideAreNotLost) {
  using T = TypeParam;
  constexpr T kHalf = T(5e-6);
  for (const double z : {0.0, 0.1234, 0.31}) {
    const T at = static_cast<T>(z);
    const Cuboid<T> plate({-1, -1, at - kHalf}, {1, 1, at + kHalf});
    for (const double tilt : {0.0, 0.05}) {
      const auto image = render(plate, bare(View::from({tilt, -1, 0}, {0.03, 0, 1})));
      const int x0 = static_cast<int>(0.5 * kWidth - 0.9 / pixelSize());
      const int x1 = static_cast<int>(0.5 * kWidth + 0.9 / pixelSize());
      for (int x = x0; x <= x1; ++x) {
        double column = 0;
        for (int y = 0; y < kHeight; ++y) {
          column += coverage(image, x, y);
        }
        ASSERT_GT(column, 0.1) << x << ' ' << z;
        ASSERT_LT(column, 1.4) << x << ' ' << z;
      }
    }
  }
}

TYPED_TEST(RenderTest, PatchesHaveTheirColoursAndALegend) {
  using T = TypeParam;
  const Solid<T> two = named(Solid<T>(Sphere<T>({T(-0.6), 0, 0}, T(0.5))), "port") |
                       named(Solid<T>(Sphere<T>({T(0.6), 0, 0}, T(0.5))), "starboard");
  auto options = bare(View::named("-y"));
  const auto coloured = render(two, options);
  const auto at = [&](const Image& image, double x) {
    return image.at(static_cast<int>(0.5 * kWidth + x / pixelSize()), kHeight / 2);
  };
  EXPECT_LT(difference(at(coloured, -0.6), patchColor(0)), 60);
  EXPECT_LT(difference(at(coloured, 0.6), patchColor(1)), 60);
  EXPECT_GT(difference(at(coloured, -0.6), at(coloured, 0.6)), 60);
  options.color = Rgb{120, 120, 120};
  const auto grey = render(two, options);
  EXPECT_EQ(at(grey, -0.6).red, at(grey, -0.6).blue);
  EXPECT_LT(difference(at(grey, -0.6), at(grey, 0.6)), 3);

  options.color.reset();
  options.legend = true;
  const auto image = render(two, options);
  for (const std::size_t patch : {0U, 1U}) {
    EXPECT_EQ(countInLegend(image, patchColor(patch)), kSwatch) << patch;
  }
}

TYPED_TEST(RenderTest, PatchesOfOneColourHaveNoBorders) {
  PolygonSoup soup;
  soup.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  soup.patchNames = {"right", "left"};
  soup.addPolygon(std::array{0U, 1U, 2U}, 0);
  soup.addPolygon(std::array{0U, 2U, 3U}, 1);
  const MeshSDF<TypeParam> square(soup);
  auto options = bare(View::named("+z"));
  options.sheets = options.lines = true;
  options.width = 320;
  options.height = 240;
  const auto darkest = [&] {
    const auto image = render(square, options);
    int least = 255;
    for (int x = 130; x < 190; ++x) least = std::min<int>(least, image.at(x, 120).green);
    return least;
  };
  EXPECT_LT(darkest(), 110);
  options.color = patchColor(0);
  EXPECT_GT(darkest(), 130);
}

TYPED_TEST(RenderTest, ThinPatchesAreInTheLegend) {
  using T = TypeParam;
  auto options = bare(View::named("-y"));
  options.legend = true;
  // Through no pixel's middle, nor a sample's.
  const T z = static_cast<T>(40.3 * pixelSize());
  const Solid<T> two = named(Solid<T>(Sphere<T>({0, 0, 0}, T(0.4))), "ball") |
                       named(Solid<T>(Cylinder<T>({-1, 0, z}, {1, 0, z}, T(1e-5))), "wire");
  const auto image = render(two, options);
  for (const std::size_t patch : {0U, 1U}) {
    EXPECT_EQ(countInLegend(image, patchColor(patch)), kSwatch) << patch;
  }
}

TYPED_TEST(RenderTest, AMeshLooksLikeItsSolid) {
  using T = TypeParam;
  const MeshSDF<T> mesh(tessellation::icosphere(1, 6));
  const Sphere<T> ball({0, 0, 0}, 1);
  auto options = bare(View::named("iso"));
  options.transparent = false;
  options.cuts = {CutPlane::across(2, 0.4)};
  const auto a = render(mesh, options);
  const auto b = render(ball, options);
  double sum = 0;
  int worst = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const int off = difference(a.pixels()[i], b.pixels()[i]);
    sum += off;
    worst = std::max(worst, off);
  }
  EXPECT_LT(sum / static_cast<double>(a.pixels().size()), 0.6);
  EXPECT_LT(worst, 250);  // of 765: at the silhouette, a few ninths of a pixel
}

TYPED_TEST(RenderTest, TheSameWhateverTheThreads) {
  using T = TypeParam;
  const MeshSDF<T> torus(tessellation::torus(0.8, 0.3, 24, 12));
  RenderOptions options;
  options.width = 400;
  options.height = 320;
  options.fieldOfView = 30;
  options.title = "Torus";
  options.cuts = {CutPlane::through({0, 0, 0}, {1, -1, 0.2})};
  options.threads = 1;
  const auto one = render(torus, options);
  options.threads = 3;
  const auto more = render(torus, options);
  EXPECT_TRUE(std::equal(one.pixels().begin(), one.pixels().end(), more.pixels().begin()));
}

TYPED_TEST(RenderTest, FitsWhatIsInSight) {
  using T = TypeParam;
  // A ball in the corner of a box that a second, tiny one stretches, and that is cut away.
  const Solid<T> solid = Sphere<T>({0, 0, 0}, 1) | Sphere<T>({9, 2, 5}, T(0.01));
  auto options = bare(View::named("iso"));
  options.show.reset();
  options.cuts = {CutPlane::through({2, 0, 0}, {1, 1, 1})};
  const auto frame = detail::RenderLayout(kWidth, kHeight, {}).frame();
  EXPECT_NEAR(covered(render(solid, options)), std::numbers::pi / 4 * frame.height * frame.height,
              0.08 * frame.height * frame.height);
}

TYPED_TEST(RenderTest, FitsSolidsByWindingNumbers) {
  // A rod without its ends, along a diagonal of its box.
  PolygonSoup soup;
  soup.points = {{0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}, {1.1, 1, 1}, {1, 1.1, 1}, {1, 1, 1.1}};
  soup.patchNames = {"rod"};
  for (const auto& side : {std::array{0U, 1U, 4U, 3U}, {1U, 2U, 5U, 4U}, {2U, 0U, 3U, 5U}}) {
    soup.addPolygon(side, 0);
  }
  const MeshSDF<TypeParam> rod(soup);
  auto options = bare(View::from({1, 1, 0.3}));
  options.show.reset();
  options.width = 320;
  options.height = 240;
  const auto image = render(rod, options);
  const auto frame = detail::RenderLayout(320, 240, {}).frame();
  int top = 240, bottom = -1;
  for (int y = 0; y < 240; ++y) {
    if (coveredInRow(image, y) == 0) continue;
    top = std::min(top, y);
    bottom = y;
  }
  EXPECT_NEAR(top, frame.centerY - 0.5 * frame.height, 2);
  EXPECT_NEAR(bottom + 1, frame.centerY + 0.5 * frame.height, 2);
}

TYPED_TEST(RenderTest, Refusals) {
  using T = TypeParam;
  const Sphere<T> ball({0, 0, 0}, 1);
  const auto refuses = [&](auto change) {
    auto options = bare(View::named("iso"));
    change(options);
    EXPECT_THROW(static_cast<void>(render(ball, options)), Error);
  };
  refuses([](auto& o) { o.width = 319; });
  refuses([](auto& o) { o.width = o.height = 30000; });
  refuses([](auto& o) { o.fieldOfView = -1; });
  refuses([](auto& o) { o.fieldOfView = NAN; });
  refuses([](auto& o) { o.show = Box<double>{{0, 0, 0}, {0, 0, INFINITY}}; });
  refuses([](auto& o) { o.region = Box<double>{{1, 1, 1}, {0, 0, 0}}; });
  refuses([](auto& o) { o.region = Box<double>{{5, 5, 5}, {6, 6, 6}}; });
  refuses([](auto& o) { o.cuts = {CutPlane::across(0, -3)}; });
  refuses([](auto& o) { o.cuts = {CutPlane{{NAN, 0, 0}, 0}}; });
  refuses([](auto& o) { o.cuts = {CutPlane{{2, 0, 0}, 0}}; });
  refuses([](auto& o) { o.cuts = {CutPlane{{1, 0, 0}, NAN}}; });
  refuses([](auto& o) { o.view.up = o.view.back; });
  refuses([](auto& o) { o.view.back = {0, 0, NAN}; });
  refuses([](auto& o) { o.region = Box<double>{{-1, -1, 0}, {1, 1, 0}}; });
  refuses([](auto& o) { o.eye = Eye{{0.5, 0, 0}, {3, 0, 0}}; });
  EXPECT_THROW(static_cast<void>(render(Plane<T>({0, 0, 0}, {0, 0, 1}), bare(View::named("iso")))),
               Error);
}

}  // namespace
}  // namespace cutwater::test
