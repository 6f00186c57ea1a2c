#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Detail/ColorMap.hpp>
#include <Cutwater/Render/Detail/SliceFrame.hpp>
#include <Cutwater/Render/Slice.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <numbers>

#include "Colors.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// A picture whose plot is the room of its layout, and where the plane's points are in it.
template <typename T>
struct Shown {
  static constexpr int kWidth = 900;
  static constexpr int kHeight = 700;

  explicit Shown(const SlicePlane<T>& shownPlane) : plane(shownPlane) {
    const auto room = area();
    pixel = T(4) / static_cast<T>(room.width);
    const T height = pixel * static_cast<T>(room.height);
    options.window = SliceWindow<T>{{-2, -height / 2}, {2, height / 2}};
    options.width = kWidth;
    options.height = kHeight;
  }

  static detail::PlotArea area() { return detail::SliceLayout(kWidth, kHeight).room(); }
  [[nodiscard]] double x(T a) const {
    return area().x0 + static_cast<double>((a - options.window->lower[0]) / pixel);
  }
  [[nodiscard]] double y(T b) const {
    return area().y0 + static_cast<double>((options.window->upper[1] - b) / pixel);
  }
  [[nodiscard]] const Rgb& at(const Image& image, T a, T b) const {
    return image.at(static_cast<int>(std::floor(x(a))), static_cast<int>(std::floor(y(b))));
  }

  SlicePlane<T> plane;
  SliceOptions<T> options;
  T pixel;
};

bool isDark(const Rgb& c) {
  return c.red < 110 && c.green < 110 && c.blue < 110;
}

template <typename T>
class SliceTest : public ::testing::Test {};
TYPED_TEST_SUITE(SliceTest, Precisions);

TYPED_TEST(SliceTest, ColoursTellTheDistanceOnBothSides) {
  using T = TypeParam;
  Shown<T> shown(SlicePlane<T>::across(2, 0));
  shown.options.isolineSpacing = 10;  // no line in sight
  const Sphere<T> sphere({0, 0, 0}, 1);
  const auto image = renderSlice(sphere, shown.plane, shown.options);
  const double farthest = std::hypot(2.0, static_cast<double>(shown.options.window->upper[1])) - 1;
  for (const double a : {-1.9, -1.4, -0.7, 0.02, 0.5, 0.9, 1.2, 1.8}) {
    const double value = std::abs(a) - 1;
    const auto expected = detail::signedDistanceColor(value < 0 ? value : value / farthest);
    EXPECT_LE(difference(shown.at(image, static_cast<T>(a), 0), expected), 8) << a;
  }
}

TYPED_TEST(SliceTest, OutlineStandsWhereTheSurfaceIs) {
  using T = TypeParam;
  // Off the middle and off the plane: the circle in the plane has the radius 0.8.
  for (int axis = 0; axis < 3; ++axis) {
    const Shown<T> shown(SlicePlane<T>::across(axis, T(0.6)));
    Vec3<T> center = T(0.2) * shown.plane.right + T(-0.1) * shown.plane.up;
    const auto image = renderSlice(Sphere<T>(center, 1), shown.plane, shown.options);
    for (int degrees = 0; degrees < 360; degrees += 5) {
      const T angle = static_cast<T>(degrees * std::numbers::pi / 180);
      const auto onRadius = [&](T r) {
        return shown.at(image, T(0.2) + r * std::cos(angle), T(-0.1) + r * std::sin(angle));
      };
      EXPECT_TRUE(isDark(onRadius(T(0.8)))) << axis << ' ' << degrees;
      EXPECT_FALSE(isDark(onRadius(T(0.8) + 5 * shown.pixel))) << axis << ' ' << degrees;
      EXPECT_FALSE(isDark(onRadius(T(0.8) - 5 * shown.pixel))) << axis << ' ' << degrees;
    }
  }
}

/// A half-space with a slanted face: every row shows the line at another fraction of a pixel.
template <std::floating_point T>
class SlantedHalfSpace final : public SignedDistanceFunction<T> {
  T localSignedDistance(const Vec3<T>& p) const override {
    return (p.x - T(0.1) * p.y) / std::sqrt(T(1.01));
  }
};

TYPED_TEST(SliceTest, OutlineIsPlacedToAFractionOfAPixel) {
  using T = TypeParam;
  Shown<T> shown(SlicePlane<T>::across(2, 0));
  shown.options.isolineSpacing = 10;
  const auto image = renderSlice(SlantedHalfSpace<T>(), shown.plane, shown.options);
  const auto area = Shown<T>::area();
  // Red: bright on the outside, still fair on the inside near the surface.
  for (int y = area.y0 + 20; y < area.y0 + area.height - 20; ++y) {
    const T b =
        shown.options.window->upper[1] - (static_cast<T>(y - area.y0) + T(0.5)) * shown.pixel;
    const double expected = shown.x(T(0.1) * b);
    const int middle = static_cast<int>(std::floor(expected));
    double weight = 0, moment = 0;
    for (int x = middle - 6; x <= middle + 6; ++x) {
      const Rgb background = image.at(x < expected ? middle - 7 : middle + 7, y);
      const double dark =
          (background.green - image.at(x, y).green) / std::max(background.green - 24.0, 1.0);
      weight += dark;
      moment += dark * (x + 0.5);
    }
    ASSERT_NEAR(moment / weight, expected, 0.25) << y;
    ASSERT_NEAR(weight, 2.2 * detail::SliceLayout(900, 700).scale(), 0.45) << y;
  }
}

TYPED_TEST(SliceTest, LinesOfEqualDistanceStandAtTheirDistances) {
  using T = TypeParam;
  Shown<T> shown(SlicePlane<T>::across(1, 0));
  const Sphere<T> sphere({0, 0, 0}, 1);
  shown.options.isolineSpacing = T(0.25);
  const auto lined = renderSlice(sphere, shown.plane, shown.options);
  shown.options.isolineSpacing = 10;
  const auto plain = renderSlice(sphere, shown.plane, shown.options);
  for (int i = 20; i < 195; ++i) {
    const T a = T(0.01) * static_cast<T>(i);
    const double fromSurface = std::abs(static_cast<double>(a) - 1);
    const double fromLine = std::abs(fromSurface - 0.25 * std::round(fromSurface / 0.25)) /
                            static_cast<double>(shown.pixel);
    const int change = difference(shown.at(lined, a, 0), shown.at(plain, a, 0));
    if (fromSurface < 0.1 || fromLine > 2) {
      EXPECT_EQ(change, 0) << a;
    } else if (fromLine < 0.1) {
      EXPECT_GT(change, 20) << a;
    }
  }
}

/// Whether anything is drawn there.
bool hasInk(const Image& image, int x0, int y0, int x1, int y1) {
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      if (image.at(x, y).green < 200) return true;
    }
  }
  return false;
}

TYPED_TEST(SliceTest, EachSideOfTheColourBarHasANumber) {
  using T = TypeParam;
  Shown<T> shown(SlicePlane<T>::across(2, 0));
  const auto area = Shown<T>::area();
  const auto numbers = [&](const Image& image, int y0, int y1) {
    return hasInk(image, area.x0 + area.width + 50, y0, area.x0 + area.width + 75, y1);
  };
  const int low = area.y0 + area.height * 3 / 4;
  const int high = area.y0 + area.height / 4;
  const int bottom = area.y0 + area.height + 9;
  for (const T half : {T(0.5), T(0.03), T(1e-4)}) {
    const Solid<T> plate = Cuboid<T>({-half, -9, -9}, {half, 9, 9});
    const auto image = renderSlice(plate, shown.plane, shown.options);
    EXPECT_TRUE(numbers(image, low, bottom)) << half;
    EXPECT_TRUE(numbers(image, area.y0, high)) << half;
    const auto opposite = renderSlice(~plate, shown.plane, shown.options);
    EXPECT_TRUE(numbers(opposite, low, bottom)) << half;
    EXPECT_TRUE(numbers(opposite, area.y0, high)) << half;
  }
}

TYPED_TEST(SliceTest, TellsOfLinesOnlyWhereThereAreSome) {
  using T = TypeParam;
  Shown<T> shown(SlicePlane<T>::across(2, 0));
  const auto area = Shown<T>::area();
  const auto hasNote = [&] {
    const auto image = renderSlice(Sphere<T>({0, 0, 0}, 1), shown.plane, shown.options);
    return hasInk(image, area.x0, area.y0 - 20, area.x0 + area.width, area.y0 - 8);
  };
  EXPECT_TRUE(hasNote());
  shown.options.isolineSpacing = 10;
  EXPECT_FALSE(hasNote());
}

TYPED_TEST(SliceTest, AnyPlaneShowsWhatATurnedSolidShows) {
  using T = TypeParam;
  Solid<T> sphere = Sphere<T>({T(0.7), T(-0.3), T(0.2)}, 1);
  const Shown<T> straight(SlicePlane<T>::across(2, T(0.1)));
  auto slanted = straight;
  slanted.plane = SlicePlane<T>::through({0, T(-0.1), 0}, {3, 0, 0}, {5, 0, 7});
  auto turned = sphere;
  turned.rotate(90, 0);  // y becomes z, z becomes -y
  const auto a = renderSlice(sphere, straight.plane, straight.options);
  const auto b = renderSlice(turned, slanted.plane, slanted.options);
  const auto area = Shown<T>::area();
  for (int y = area.y0 + 2; y < area.y0 + area.height - 2; ++y) {
    for (int x = area.x0 + 2; x < area.x0 + area.width - 2; ++x) {
      ASSERT_LE(difference(a.at(x, y), b.at(x, y)), 6) << x << ' ' << y;
    }
  }
}

TYPED_TEST(SliceTest, ShowsTheWholeSolidWithoutAWindowAndTheSameForAnyThreads) {
  using T = TypeParam;
  const Sphere<T> sphere({100, 50, 0}, 3);
  const auto plane = SlicePlane<T>::across(2, 0);
  const auto image = renderSlice(sphere, plane, {.width = 640, .height = 400, .threads = 1});
  const auto again = renderSlice(sphere, plane, {.width = 640, .height = 400, .threads = 3});
  EXPECT_TRUE(std::equal(image.pixels().begin(), image.pixels().end(), again.pixels().begin()));
  const auto area = detail::SliceLayout(640, 400).room();
  // The disc fills the height but for some room: 1 of 1.16.
  const int middle = area.y0 + area.height / 2;
  const int blue =
      static_cast<int>(std::count_if(image.pixels().begin() + middle * 640,
                                     image.pixels().begin() + middle * 640 + area.x0 + area.width,
                                     [](const Rgb& c) { return c.blue > c.red + 30; }));
  EXPECT_NEAR(blue, area.height / 1.16, 6);
}

TYPED_TEST(SliceTest, WithAMeshShowsAllOfItAndNoMore) {
  using T = TypeParam;
  const Sphere<T> sphere({0, 0, 0}, T(0.5));
  const OctreeDomain<T> flat({-4, -1, -1}, 1, {8, 2, 2});
  const Octree<T> mesh(sphere, flat, {.cut = 2}, {.threads = 1});
  const auto plane = SlicePlane<T>::across(1, 0);
  const auto image = renderSlice(sphere, plane, {.mesh = &mesh});
  const auto expected =
      renderSlice(sphere, plane, {.window = SliceWindow<T>{{-4, -1}, {4, 1}}, .mesh = &mesh});
  EXPECT_TRUE(std::ranges::equal(image.pixels(), expected.pixels()));
}

TYPED_TEST(SliceTest, ShowsNarrowWindows) {
  using T = TypeParam;
  const Sphere<T> sphere({0, 0, 0}, 1);
  for (const T narrow : {T(1e-3), T(1e-9)}) {
    for (const auto& window : {SliceWindow<T>{{-narrow, -100}, {narrow, 100}},
                               SliceWindow<T>{{-100, -narrow}, {100, narrow}}}) {
      const auto image = renderSlice(sphere, SlicePlane<T>::across(2, 0),
                                     {.window = window, .width = 320, .height = 240});
      EXPECT_EQ(image.width(), 320);
    }
  }
}

TYPED_TEST(SliceTest, RefusesWhatCannotBeShown) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const auto plane = SlicePlane<T>::across(2, 0);
  const Sphere<T> sphere({0, 0, 0}, 1);
  const SlantedHalfSpace<T> unbounded;
  const auto show = [&](const SignedDistanceFunction<T>& solid, const SliceOptions<T>& options) {
    static_cast<void>(renderSlice(solid, plane, options));
  };
  EXPECT_THROW(SlicePlane<T>::across(3, 0), Error);
  EXPECT_THROW(SlicePlane<T>::across(0, inf), Error);
  EXPECT_THROW(SlicePlane<T>::through({0, 0, 0}, {1, 2, 3}, {-2, -4, -6}), Error);
  EXPECT_THROW(SlicePlane<T>::through({0, 0, 0}, {0, 0, 0}, {0, 1, 0}), Error);
  EXPECT_THROW(show(unbounded, {}), Error);
  EXPECT_THROW(show(sphere, {.width = 100}), Error);
  EXPECT_THROW(show(sphere, {.window = SliceWindow<T>{{0, 0}, {0, 1}}}), Error);
  EXPECT_THROW(show(sphere, {.window = SliceWindow<T>{{0, 0}, {1, inf}}}), Error);
  EXPECT_THROW(show(sphere, {.isolineSpacing = T(1e-6)}), Error);
  EXPECT_THROW(show(sphere, {.isolineSpacing = -1}), Error);
}

}  // namespace
}  // namespace cutwater::test
