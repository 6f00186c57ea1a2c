// renderCells().

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Render/Detail/ColorMap.hpp>
#include <Cutwater/Render/Detail/SliceFrame.hpp>
#include <Cutwater/Render/Slice.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "Colors.hpp"

namespace cutwater::test {
namespace {

/// Cells of width 1 in [0, 8] x [0, 6] x [0, 4], and a picture of a layer across y.
struct ShownCells {
  static constexpr int kWidth = 900;
  static constexpr int kHeight = 700;

  explicit ShownCells(const PolygonSoup& soup, FluidSide side = FluidSide::Outside)
      : cells(CellCutter(Solid<double>(MeshSDF<double>(soup)), side)
                  .cut(GridPatch<double>{Level<double>({0, 0, 0}, {1, 1, 1}),
                                         IndexBox::ofSize(8, 6, 4)},
                       {.polygons = true})),
        image(renderCells(cells, 1, 2, {.width = kWidth, .height = kHeight})),
        area(detail::fitted(detail::SliceLayout(kWidth, kHeight).room(), {0, 8}, {0, 4})) {}

  /// At x and z.
  [[nodiscard]] Rgb at(double x, double z) const {
    return image.at(static_cast<int>(area.x0 + area.width * x / 8),
                    static_cast<int>(area.y0 + area.height * (4 - z) / 4));
  }
  /// The share of pixels in a box about this place that have nearly this colour.
  [[nodiscard]] double shareOf(const Rgb& color, double x, double z, double half) const {
    int found = 0;
    int all = 0;
    for (double a = x - half; a <= x + half; a += 0.01) {
      for (double b = z - half; b <= z + half; b += 0.01, ++all) {
        found += difference(at(a, b), color) < 12 ? 1 : 0;
      }
    }
    return static_cast<double>(found) / all;
  }

  CutCells cells;
  Image image;
  detail::PlotArea area;
};

constexpr Rgb kMark{214, 0, 110};

int brightness(const Rgb& c) {
  return c.red + c.green + c.blue;
}

TEST(CellSliceTest, CellsHaveTheColourOfTheirShareOfFluid) {
  // Walls at x = 2.25 and 5.5, z = 1.5: shares by hand.
  const ShownCells shown(tessellation::box({2.25, -1, -1}, {5.5, 9, 1.5}));
  const auto expectShare = [&](double x, double z, double share) {
    EXPECT_LE(difference(shown.at(x, z), detail::fluidFractionColor(share)), 4) << x << ' ' << z;
  };
  expectShare(2.12, 0.6, 0.25);
  expectShare(5.7, 0.3, 0.5);
  expectShare(3.5, 1.75, 0.5);
  expectShare(2.1, 1.8, 1 - 0.75 * 0.5);
  expectShare(2.7, 1.7, 1 - 0.75 * 0.5);
  expectShare(5.8, 1.2, 0.75);
  EXPECT_GT(brightness(shown.at(0.5, 0.5)), 740);  // all fluid
  EXPECT_GT(brightness(shown.at(3.5, 3.4)), 740);
  const auto body = shown.at(3.52, 0.45);
  EXPECT_LT(brightness(body), 500);
  EXPECT_LT(std::abs(body.red - body.blue), 30);  // grey
  // The body in a cut cell is grey with a tint of its colour.
  const auto tinted = shown.at(2.75, 0.45);
  const auto share = detail::fluidFractionColor(0.25);
  EXPECT_GT(difference(tinted, body), 20);
  EXPECT_LT(difference(tinted, share), difference(body, share));
  EXPECT_GT(difference(tinted, share), 60);
}

TEST(CellSliceTest, WithFluidInsideTheRestIsBody) {
  const ShownCells shown(tessellation::box({2.25, -1, -1}, {5.5, 9, 1.5}), FluidSide::Inside);
  EXPECT_LE(difference(shown.at(2.7, 0.4), detail::fluidFractionColor(0.75)), 4);
  EXPECT_GT(brightness(shown.at(3.5, 0.5)), 740);
  EXPECT_LT(brightness(shown.at(0.52, 0.45)), 500);
}

TEST(CellSliceTest, TheWallIsALine) {
  auto soup = tessellation::box({-1.5, -9, -1.5}, {1.5, 9, 1.5});
  RigidTransform<double> motion;
  motion.rotate(-20.0, 1);
  motion.translate({4, 3, 2});
  for (auto& p : soup.points) p = motion.toWorld(p);
  const ShownCells shown(soup);
  for (double t = -1.45; t < 1.45; t += 0.05) {
    for (const auto& p : {Vec3<double>{1.5, 0, t}, Vec3<double>{-1.5, 0, t},
                          Vec3<double>{t, 0, 1.5}, Vec3<double>{t, 0, -1.5}}) {
      const auto on = motion.toWorld(p);
      const auto off = motion.toWorld(0.95 * p);
      EXPECT_LT(brightness(shown.at(on.x, on.z)), 250) << p;
      EXPECT_GT(brightness(shown.at(off.x, off.z)), 280) << p;
    }
  }
}

TEST(CellSliceTest, PiecesHaveTheirOwnColoursAndTheirCellsMarks) {
  // A plate that no corner sees, up to x = 5.5.
  const ShownCells shown(tessellation::box({-1, -1, 1.25}, {5.5, 9, 1.25 + 1e-6}));
  for (const double x : {0.25, 2.25, 4.25}) {
    EXPECT_LE(difference(shown.at(x, 1.15), detail::fluidFractionColor(0.25)), 4) << x;
    EXPECT_LE(difference(shown.at(x, 1.75), detail::fluidFractionColor(0.75)), 4) << x;
    EXPECT_GT(shown.shareOf(kMark, x + 0.25, 1.5, 0.03), 0.25) << x;  // the dot
    EXPECT_GT(shown.shareOf(kMark, x + 0.25, 1.97, 0.03), 0.1) << x;  // the frame
  }
  // Where it ends there is one piece around it, and a dot only.
  EXPECT_LE(difference(shown.at(5.75, 1.75), detail::fluidFractionColor(1)), 4);
  EXPECT_GT(shown.shareOf(kMark, 5.5, 1.5, 0.03), 0.25);
  EXPECT_EQ(shown.shareOf(kMark, 5.5, 1.97, 0.03), 0);
  EXPECT_EQ(shown.shareOf(kMark, 6.5, 1.5, 0.4), 0);
}

TEST(CellSliceTest, AWindowShowsAPartToScale) {
  const ShownCells all(tessellation::box({2.25, -1, -1}, {5.5, 9, 1.5}));
  const auto image = renderCells(all.cells, 1, 2,
                                 {.window = SliceWindow<double>{{2, 1}, {4, 2}},
                                  .width = ShownCells::kWidth,
                                  .height = ShownCells::kHeight});
  const auto room = detail::SliceLayout(ShownCells::kWidth, ShownCells::kHeight).room();
  const auto area = detail::fitted(room, {2, 4}, {1, 2});
  for (const auto& [x, z] : {std::pair{2.1, 1.8}, {2.7, 1.7}, {3.5, 1.75}}) {
    const auto& found = image.at(static_cast<int>(area.x0 + area.width * (x - 2) / 2),
                                 static_cast<int>(area.y0 + area.height * (2 - z)));
    EXPECT_EQ(found, all.at(x, z)) << x << ' ' << z;
  }
}

TEST(CellSliceTest, RefusesWhatCannotBeShown) {
  const ShownCells shown(tessellation::box({2.25, -1, -1}, {5.5, 9, 1.5}));
  const auto show = [&](int axis, std::int32_t layer, const CellSliceOptions& options) {
    static_cast<void>(renderCells(shown.cells, axis, layer, options));
  };
  EXPECT_NO_THROW(show(2, 3, {.width = 320, .height = 240}));
  EXPECT_THROW(show(2, 4, {}), Error);
  EXPECT_THROW(show(3, 0, {}), Error);
  EXPECT_THROW(show(0, 0, {.width = 100}), Error);
  EXPECT_THROW(show(0, 0, {.window = SliceWindow<double>{{0, 0}, {0, 1}}}), Error);
  EXPECT_THROW(show(0, 0, {.window = SliceWindow<double>{{0, 0}, {1, INFINITY}}}), Error);
}

}  // namespace
}  // namespace cutwater::test
