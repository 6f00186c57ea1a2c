#include <Cutwater/Render/Detail/PixelSamples.hpp>

#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "Colors.hpp"

namespace cutwater::test {
namespace {

using detail::Camera;
using detail::PicturePoint;
using detail::PixelSamples;
using detail::PlotArea;
using detail::SurfaceSample;

constexpr PlotArea kArea{7, 5, 50, 40};

/// Pixels of size 1, seen along z.
Camera camera() {
  return {View::named("+z"), Box<double>{{-30, -30, -1}, {30, 30, 1}}, {32, 25, 60, 60}, 0};
}

SurfaceSample flat(std::uint32_t surface, float along = 0) {
  SurfaceSample sample;
  sample.along = along;
  sample.normal = {0, 0, 1};
  sample.surface = surface;
  return sample;
}

/// Surfaces of different names each.
constexpr auto kApart = [](std::uint32_t, std::uint32_t) { return false; };

/// What is seen at a point.
using Scene = SurfaceSample (*)(const PicturePoint&, double spacing);

struct Traced {
  explicit Traced(Scene scene, int threads = 1, int side = 3)
      : eye(camera()),
        samples(eye, kArea,
                {.trace =
                     [&](std::span<const PicturePoint> points, const detail::RaySpread& spread,
                         std::span<SurfaceSample> found) {
                       rays += points.size();
                       for (std::size_t i = 0; i < points.size(); ++i)
                         found[i] = scene(points[i], spread.spacing);
                     },
                 .light = [](std::span<const PicturePoint>, std::span<SurfaceSample>) {},
                 .side = side},
                {.threads = threads, .progress = {}}) {}

  [[nodiscard]] Image image(double lineWidth = 0) const {
    Image picture(64, 50, kWhite);
    samples.draw(picture, [](const SurfaceSample&, const PicturePoint&) { return kBlack; }, kApart,
                 lineWidth, {.threads = 1, .progress = {}});
    return picture;
  }

  std::atomic<std::size_t> rays = 0;
  Camera eye;
  PixelSamples samples;
};

double dark(const Image& image, int x, int y) {
  return 1 - image.at(x, y).red / 255.0;
}

TEST(PixelSamplesTest, EdgesCoverPartsOfPixels) {
  const Traced traced([](const PicturePoint& p, double) {
    return p.x + 0.3 * p.y < 40.1 ? flat(0) : SurfaceSample{};
  });
  const auto image = traced.image();
  for (int y = kArea.y0; y < kArea.y0 + kArea.height; ++y) {
    double sum = 0;
    for (int x = 0; x < 64; ++x) sum += dark(image, x, y);
    ASSERT_NEAR(sum, 40.1 - 0.3 * (y + 0.5) - kArea.x0, 0.1) << y;
  }
  // Nothing is drawn outside of the area, and few rays suffice.
  EXPECT_EQ(image.at(kArea.x0 - 1, 20), kWhite);
  EXPECT_EQ(image.at(20, kArea.y0 - 1), kWhite);
  EXPECT_LT(traced.rays, 50 * 40 + 9 * 40 * 5);
}

/// A line along x of no width, and what rays know of it.
SurfaceSample hairline(const PicturePoint& p, double spacing) {
  SurfaceSample sample;
  if (std::abs(p.y - 20.34) < 0.71 * spacing) {
    sample.passed = 0;
    sample.normal = {0, p.y < 20.34 ? 1.0F : -1.0F, 0};  // up is towards smaller y
  }
  return sample;
}

TEST(PixelSamplesTest, WhatPassesBetweenRaysIsNotLost) {
  const auto image = Traced(hairline).image();
  const auto blind = Traced([](const PicturePoint& p, double spacing) {
                       auto sample = hairline(p, spacing);
                       sample.passed = kNone;
                       return sample;
                     }).image();
  for (int x = kArea.x0; x < kArea.x0 + kArea.width; ++x) {
    EXPECT_NEAR(dark(image, x, 20), 1 / 3.0 + 1 / 6.0, 0.17) << x;
    EXPECT_EQ(dark(image, x, 19), 0) << x;
    EXPECT_EQ(dark(image, x, 21), 0) << x;
    EXPECT_EQ(dark(blind, x, 20), 0) << x;
  }
}

TEST(PixelSamplesTest, FourSamplesOfAPixelDoWithLess) {
  const Scene edge = [](const PicturePoint& p, double) {
    return p.x + 0.3 * p.y < 40.1 ? flat(0) : SurfaceSample{};
  };
  const Traced four(edge, 1, 2);
  const auto image = four.image();
  for (int y = kArea.y0; y < kArea.y0 + kArea.height; ++y) {
    double sum = 0;
    for (int x = 0; x < 64; ++x) sum += dark(image, x, y);
    ASSERT_NEAR(sum, 40.1 - 0.3 * (y + 0.5) - kArea.x0, 0.25) << y;
  }
  EXPECT_LT(four.rays - 50 * 40, 0.5 * static_cast<double>(Traced(edge).rays - 50 * 40));
  // What passes between rays is not lost.
  const auto line = Traced(hairline, 1, 2).image();
  for (int x = kArea.x0; x < kArea.x0 + kArea.width; ++x) {
    EXPECT_NEAR(dark(line, x, 20), 0.5, 0.01) << x;
    EXPECT_EQ(dark(line, x, 19) + dark(line, x, 21), 0) << x;
  }
}

TEST(PixelSamplesTest, SilhouettesDoNotGrowByWhatPasses) {
  const Traced traced([](const PicturePoint& p, double spacing) {
    SurfaceSample sample = p.x < 30.05 ? flat(0) : SurfaceSample{};
    if (!sample.isHit() && p.x < 30.05 + 0.71 * spacing) {
      sample.passed = 0;
      sample.normal = {1, 0, 0};
    }
    return sample;
  });
  // The edge is at a twentieth of pixel 30, whose first samples are at a sixth.
  EXPECT_EQ(dark(traced.image(), 29, 20), 1);
  EXPECT_EQ(dark(traced.image(), 30, 20), 0);
}

TEST(PixelSamplesTest, LinesStandAtStepsAndBorders) {
  // Two patches in one plane, then a step down, then nothing.
  const Traced traced([](const PicturePoint& p, double) {
    if (p.x < 20.5) return flat(0);
    if (p.x < 31) return flat(1);
    return p.x < 41 ? flat(1, 10) : SurfaceSample{};
  });
  Image plain(64, 50, kWhite);
  Image lined(64, 50, kWhite);
  const auto shade = [](const SurfaceSample&, const PicturePoint&) { return Rgb{250, 250, 250}; };
  traced.samples.draw(plain, shade, kApart, 0, {.threads = 1, .progress = {}});
  traced.samples.draw(lined, shade, kApart, 0.7, {.threads = 1, .progress = {}});
  const auto ink = [&](double from, double to) {
    double sum = 0;
    for (int x = static_cast<int>(from); x < static_cast<int>(to); ++x) {
      sum += dark(lined, x, 20) - dark(plain, x, 20);
    }
    return sum;
  };
  EXPECT_EQ(ink(10, 19), 0);
  EXPECT_GT(ink(19, 22), 0.2);  // on both sides
  EXPECT_EQ(ink(22, 28), 0);
  EXPECT_GT(ink(28, 31), 0.2);
  EXPECT_EQ(ink(31, 38), 0);  // not on what lies behind
  EXPECT_GT(ink(38, 41), 0.2);
}

TEST(PixelSamplesTest, SurfacesThatAreOneHaveALineAtTheirEdgesOnly) {
  // Three patches: two that go on smoothly, and one at an angle.
  const Traced traced([](const PicturePoint& p, double) {
    auto sample = flat(p.x < 20.5 ? 0 : p.x < 35.5 ? 1 : 2);
    if (sample.surface == 2) sample.normal = {0.6F, 0, 0.8F};
    return sample;
  });
  const auto shade = [](const SurfaceSample&, const PicturePoint&) { return kWhite; };
  const auto ink = [&](detail::SurfaceMatcher areOne, int x) {
    Image picture(64, 50, kWhite);
    traced.samples.draw(picture, shade, areOne, 0.7, {.threads = 1, .progress = {}});
    return dark(picture, x - 1, 20) + dark(picture, x, 20) + dark(picture, x + 1, 20);
  };
  EXPECT_GT(ink(kApart, 20), 0.2);
  EXPECT_GT(ink(kApart, 35), 0.2);
  const auto areOne = [](std::uint32_t, std::uint32_t) { return true; };
  EXPECT_EQ(ink(areOne, 20), 0);
  EXPECT_EQ(ink(areOne, 35), ink(kApart, 35));
}

TEST(PixelSamplesTest, TheSameWhateverTheThreads) {
  const Scene scene = [](const PicturePoint& p, double) {
    return std::sin(p.x) * std::cos(0.7 * p.y) > 0.2 ? flat(p.x < 30 ? 0 : 3) : SurfaceSample{};
  };
  const Traced one(scene, 1);
  const Traced more(scene, 3);
  const auto a = one.image(0.7);
  const auto b = more.image(0.7);
  EXPECT_TRUE(std::equal(a.pixels().begin(), a.pixels().end(), b.pixels().begin()));
  EXPECT_EQ(one.rays, more.rays);
}

TEST(PixelSamplesTest, PatchesHaveTheAreasOfTheirSamples) {
  const auto areas = Traced([](const PicturePoint& p, double) {
                       return flat(p.x < 20.4 ? 2 : 0);
                     }).samples.areasOfPatches(3);
  // To 20 and a third, as samples are: 13 1/3 of 50 pixels of 40 rows.
  EXPECT_EQ(areas, (std::vector<std::size_t>{110 * 40 * 3, 0, 40 * 40 * 3}));
  // Both rows of samples beside it.
  EXPECT_EQ(Traced(hairline).samples.areasOfPatches(1)[0], 50U * 3 * 2);
}

}  // namespace
}  // namespace cutwater::test
