// renderCells().

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Render/Detail/CellLayer.hpp>
#include <Cutwater/Render/Detail/ColorMap.hpp>
#include <Cutwater/Render/Detail/SliceFrame.hpp>
#include <Cutwater/Render/Slice.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "Colors.hpp"
#include "Support/Soups.hpp"

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
    const int steps = static_cast<int>(100 * half);
    for (int i = -steps; i <= steps; ++i) {
      for (int j = -steps; j <= steps; ++j, ++all) {
        found += difference(at(x + 0.01 * i, z + 0.01 * j), color) < 12 ? 1 : 0;
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
  for (int n = -29; n < 29; ++n) {
    const double t = 0.05 * n;
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

/// The leaves of an octree of 8 x 6 x 4 roots of width 1, around a box and a thin plate.
struct ShownLeaves {
  explicit ShownLeaves(const Refinement<double>& rules)
      : mesh(solid, OctreeDomain<double>({0, 0, 0}, 1, {8, 6, 4}), rules),
        leaves(CellCutter(solid).cut(mesh, {.polygons = true})) {}

  static Solid<double> made() {
    Solid<double> made{MeshSDF<double>(together(tessellation::box({2.3, 1.2, -1}, {5.6, 9, 1.6}),
                                                tessellation::box({-1, -1, 2.7}, {9, 9, 2.7001})))};
    made.rotate(3.0, Vec3<double>{1, 2, 3});
    return made;
  }

  Solid<double> solid = made();
  Octree<double> mesh;
  CutLeaves leaves;
};

TEST(CellSliceTest, AnOctreeOfOneLevelLooksLikeItsGrid) {
  const CellSliceOptions options{.width = 640, .height = 480, .title = "Cells", .unit = "m"};
  for (const int level : {0, 1}) {
    const ShownLeaves shown({.cut = level, .bands = {{100, level}}});
    const auto grid = CellCutter(shown.solid)
                          .cut(GridPatch<double>{shown.mesh.domain().level(level),
                                                 shown.mesh.domain().indices(level)},
                               {.polygons = true});
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = shown.mesh.domain().level(level).position({2, 2, 2})[axis];
      const auto expected = renderCells(grid, axis, 2, options);
      const auto found = renderCells(shown.leaves, shown.mesh, axis, middle, options);
      ASSERT_TRUE(std::ranges::equal(found.pixels(), expected.pixels())) << axis << ' ' << level;
    }
  }
}

TEST(CellSliceTest, LeavesHaveTheirSizes) {
  // All fluid and body of the section, from its pixels and by sampling the solid.
  const ShownLeaves shown({.cut = 2});
  ASSERT_GT(std::ranges::count(shown.mesh.cells(), 0, &OctreeCell::level), 20);
  const double at = 2.1;
  const CellSliceOptions options{.width = 900, .height = 700};
  const auto image = renderCells(shown.leaves, shown.mesh, 1, at, options);
  const auto area = detail::fitted(detail::SliceLayout(900, 700).room(), {0, 8}, {0, 4});
  const auto pixel = [&](double x, double z) {
    return image.at(static_cast<int>(area.x0 + area.width * x / 8),
                    static_cast<int>(area.y0 + area.height * (4 - z) / 4));
  };
  constexpr Rgb line{196, 201, 207};
  std::size_t whole = 0;
  std::size_t cut = 0;
  for (std::uint32_t leaf = 0; leaf < shown.mesh.cells().size(); ++leaf) {
    const auto box = shown.mesh.box(shown.mesh.cells()[leaf]);
    if (!(box.lower.y <= at && at < box.upper.y)) continue;
    const double width = box.size().x;
    const auto center = box.center();
    const auto row = shown.leaves.rowOf(leaf);
    if (shown.leaves.classes[leaf] == FluidClass::Fluid) {
      // One colour from end to end, with lines around it and no others.
      for (int n = 0; n < 8; ++n) {
        const double x = box.lower.x + (0.15 + 0.1 * n) * width;
        EXPECT_GT(brightness(pixel(x, center.z + 0.1 * width)), 740);
      }
      ++whole;
    } else if (row != CutLeaves::kNoRow &&
               shown.leaves.cut.firstPiece[row + 1] == shown.leaves.cut.firstPiece[row] + 1) {
      const auto share = shown.leaves.volumeFraction(shown.leaves.cut.firstPiece[row]);
      const Vec3<double> p{box.lower.x + 0.3 * width, at, box.lower.z + 0.3 * width};
      if (shown.solid.signedDistance(p) < 0.02 * width + 0.02) continue;
      EXPECT_LE(difference(pixel(p.x, p.z), detail::fluidFractionColor(share)), 4) << p;
      ++cut;
    }
    if (box.lower.x > 0.1) {
      const auto& found = pixel(box.lower.x, center.z + 0.25 * width);
      const auto& left = pixel(box.lower.x - 1.0 * 8 / area.width, center.z + 0.25 * width);
      EXPECT_LT(std::min(brightness(found), brightness(left)), brightness(line) + 90) << center;
    }
  }
  EXPECT_GT(whole, 8U);
  EXPECT_GE(cut, 20U);
}

TEST(CellSliceTest, LeavesFillThePlaneAndDivideItAsTheSolidDoes) {
  const ShownLeaves shown({.cut = 2});
  constexpr int kRight = 800;
  constexpr int kUp = 400;
  int body = 0;
  for (const double at : {1.27, 1.48, 3.76, 3.9}) {  // not in the middle of leaves
    const detail::CellLayer layer(shown.leaves, shown.mesh, 1, at);
    int all = 0;
    int wrong = 0;
    layer.eachCell([&](const detail::ShownCell& cell) {
      const auto& [lower, upper] = cell.rectangle;
      for (int n = 0; n < kRight * kUp; ++n) {
        const detail::PlanePoint p{0.01 * (n % kRight + 0.5), 0.01 * (n / kRight + 0.5)};
        if (!(lower[0] <= p[0] && p[0] < upper[0] && lower[1] <= p[1] && p[1] < upper[1])) continue;
        const bool isFluid =
            cell.row == CutCells::kNoRow ? cell.isFluid : layer.section(cell.row).at(p).isFluid;
        const bool isBody = shown.solid.signedDistance({p[0], at, p[1]}) < 0;
        ++all;
        body += isBody ? 1 : 0;
        wrong += isFluid == isBody ? 1 : 0;
      }
    });
    EXPECT_EQ(all, kRight * kUp) << at;
    EXPECT_EQ(wrong, 0) << at;
  }
  EXPECT_GT(body, kRight * kUp / 4);
}

TEST(CellSliceTest, RefusesLeavesThatAreNotThere) {
  const ShownLeaves shown({.cut = 1});
  EXPECT_THROW(static_cast<void>(renderCells(shown.leaves, shown.mesh, 3, 1, {})), Error);
  EXPECT_THROW(static_cast<void>(renderCells(shown.leaves, shown.mesh, 0, 9, {})), Error);
  EXPECT_THROW(static_cast<void>(renderCells(shown.leaves, shown.mesh, 0, NAN, {})), Error);
  const auto without = CellCutter(shown.solid).cut(shown.mesh);
  EXPECT_THROW(static_cast<void>(renderCells(without, shown.mesh, 0, 1, {})), Error);
  const ShownLeaves other({.cut = 0});
  EXPECT_THROW(static_cast<void>(renderCells(shown.leaves, other.mesh, 0, 1, {})), Error);
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
