#include <Cutwater/Render/Detail/PixelTiles.hpp>
#include <Cutwater/Render/Detail/SparseLight.hpp>

#include <atomic>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using detail::Camera;
using detail::PicturePoint;
using detail::PlotArea;
using detail::SparseLight;
using detail::SurfaceSample;

constexpr PlotArea kLitArea{7, 5, 50, 40};

/// Pixels of size 1, seen along z.
const Camera kCamera(View::named("+z"), Box<double>{{-30, -30, -1}, {30, 30, 1}}, {32, 25, 60, 60},
                     0);

/// Light that grows to the right.
float openAt(const PicturePoint& p) {
  return static_cast<float>(0.01 * p.x);
}

/// A step between columns 30 and 31 of the area.
SurfaceSample stairs(const PicturePoint& p) {
  SurfaceSample sample;
  sample.along = p.x < kLitArea.x0 + 31 ? 0 : 20;
  sample.normal = {0, 0, 1};
  sample.surface = 0;
  return sample;
}

struct Lit {
  explicit Lit(int spacing, SurfaceSample (*scene)(const PicturePoint&), int threads = 1) {
    const auto compute = [&](std::span<const PicturePoint> at, std::span<SurfaceSample> seen) {
      computed += at.size();
      for (std::size_t i = 0; i < at.size(); ++i) seen[i].open = openAt(at[i]);
    };
    SparseLight light(kCamera, kLitArea, spacing, compute);
    for (int y = 0; y < kLitArea.height; ++y) {
      for (int x = 0; x < kLitArea.width; ++x) {
        points.push_back({kLitArea.x0 + x + 0.5, kLitArea.y0 + y + 0.5});
        samples.push_back(scene(points.back()));
      }
    }
    light.prepare(samples, {.threads = threads, .progress = {}});
    const auto width = static_cast<std::size_t>(kLitArea.width);
    for (std::size_t row = 0; row < samples.size(); row += width) {
      light.light(std::span(points).subspan(row, width), std::span(samples).subspan(row, width));
    }
  }

  std::atomic<std::size_t> computed = 0;
  std::vector<PicturePoint> points;
  std::vector<SurfaceSample> samples;
};

TEST(SparseLightTest, IsInterpolatedOnASurface) {
  const Lit lit(4, [](const PicturePoint&) {
    SurfaceSample sample;
    sample.along = 0;
    sample.normal = {0, 0, 1};
    sample.surface = 0;
    return sample;
  });
  EXPECT_LT(lit.computed, lit.samples.size() / 8);
  for (std::size_t i = 0; i < lit.samples.size(); ++i) {
    // Beside the last column that is computed, its light goes on.
    const auto most = openAt({kLitArea.x0 + 48.5, 0});
    ASSERT_NEAR(lit.samples[i].open, std::min(openAt(lit.points[i]), most), 1e-6F);
  }
}

TEST(SparseLightTest, DoesNotCrossSteps) {
  const Lit lit(4, stairs);
  for (std::size_t i = 0; i < lit.samples.size(); ++i) {
    const double x = lit.points[i].x;
    if (x > kLitArea.x0 + 48) continue;
    // Up to the last column before the step, light goes on from there.
    const auto most = x < kLitArea.x0 + 31 ? openAt({kLitArea.x0 + 28.5, 0}) : 1;
    const auto least = x > kLitArea.x0 + 31 ? openAt({kLitArea.x0 + 32.5, 0}) : 0;
    const float open = lit.samples[i].open;
    const float expected = std::clamp(openAt(lit.points[i]), least, most);
    ASSERT_TRUE(std::abs(open - expected) < 1e-6F || open == openAt(lit.points[i])) << x;
  }
}

TEST(SparseLightTest, IsComputedWhereNothingIsNear) {
  const auto dot = [](const PicturePoint& p) {
    SurfaceSample sample;
    if (std::abs(p.x - (kLitArea.x0 + 10.5)) > 0.1 || std::abs(p.y - (kLitArea.y0 + 10.5)) > 0.1) {
      return sample;
    }
    sample.along = 0;
    sample.normal = {0, 0, 1};
    sample.surface = 0;
    return sample;
  };
  const Lit lit(4, dot);
  for (std::size_t i = 0; i < lit.samples.size(); ++i) {
    const float expected = lit.samples[i].isHit() ? openAt(lit.points[i]) : 1;
    EXPECT_EQ(lit.samples[i].open, expected);
  }
}

TEST(SparseLightTest, WithoutSpacingAllIsComputed) {
  const Lit lit(1, stairs);
  EXPECT_EQ(lit.computed, lit.samples.size());
  for (std::size_t i = 0; i < lit.samples.size(); ++i) {
    ASSERT_EQ(lit.samples[i].open, openAt(lit.points[i]));
  }
}

TEST(SparseLightTest, TilesHaveEachPixelOnce) {
  const detail::PixelTiles tiles(kLitArea);
  const auto width = static_cast<std::size_t>(kLitArea.width);
  std::vector<int> visits(width * static_cast<std::size_t>(kLitArea.height));
  for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
    tiles.forPixels(tile, [&](int x, int y) {
      ASSERT_TRUE(0 <= x && x < kLitArea.width && 0 <= y && y < kLitArea.height);
      ++visits[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
    });
  }
  for (const int count : visits) ASSERT_EQ(count, 1);
}

}  // namespace
}  // namespace cutwater::test
