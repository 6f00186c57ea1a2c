#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Render/Detail/CellLayer.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// A ring, a thin plate and a wire, turned.
Solid<double> ringPlateAndWire() {
  auto soup = together(tessellation::torus(0.3, 0.1, 24, 12),
                       tessellation::box({-0.6, -0.6, 0.15}, {0.6, 0.6, 0.151}));
  soup = together(soup, tessellation::box({0.7, -0.6, 0}, {0.71, 0.6, 0.01}));
  Solid<double> solid{MeshSDF<double>(soup)};
  solid.rotate(33.0, Vec3<double>{1, 2, 3});
  return solid;
}

constexpr double kCellWidth = 0.11;

CutCells cut(const Solid<double>& solid, FluidSide side = FluidSide::Outside) {
  const Level<double> level({-1.1, -1.1, -1.1}, {kCellWidth, kCellWidth, kCellWidth});
  return CellCutter(solid, side)
      .cut(GridPatch<double>{level, IndexBox::ofSize(20, 20, 20)}, {.polygons = true});
}

/// Points of a layer's cells, against the sign of the solid.
class LayerSides {
 public:
  LayerSides(const Solid<double>& solid, FluidSide side) : solid_(solid), side_(side) {}

  void check(const detail::CellLayer& layer, int axis) {
    for (const auto& cell : layer.cells()) {
      withoutSegments += cell.segments.empty() ? 1 : 0;
      const auto [lower, upper] = layer.rectangle(cell.row);
      for (int n = 0; n < 10; ++n) {
        const detail::PlanePoint p{lower[0] + share_(random_) * (upper[0] - lower[0]),
                                   lower[1] + share_(random_) * (upper[1] - lower[1])};
        const auto plane = SlicePlane<double>::across(axis, layer.middle());
        const auto distance =
            solid_.signedDistance(plane.origin + p[0] * plane.right + p[1] * plane.up);
        if (std::abs(distance) < 1e-9) continue;
        const bool isFluid = (distance > 0) == (side_ == FluidSide::Outside);
        const auto found = cell.at(p);
        ASSERT_EQ(found.isFluid, isFluid) << axis << ' ' << layer.middle() << ' ' << distance;
        ++(isFluid ? fluid : body);
      }
    }
  }

  std::size_t withoutSegments = 0;
  std::size_t body = 0;
  std::size_t fluid = 0;

 private:
  const Solid<double>& solid_;
  FluidSide side_;
  std::mt19937 random_{2};
  std::uniform_real_distribution<double> share_{0, 1};
};

TEST(CellLayerTest, SidesAreThoseOfTheSolid) {
  const auto solid = ringPlateAndWire();
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto cells = cut(solid, side);
    LayerSides sides(solid, side);
    for (int axis = 0; axis < 3; ++axis) {
      for (std::int32_t index = 0; index < 20; ++index) {
        ASSERT_NO_FATAL_FAILURE(sides.check(detail::CellLayer(cells, axis, index), axis));
      }
    }
    EXPECT_GT(sides.withoutSegments, 50U);
    EXPECT_GT(sides.body, 1000U);
    EXPECT_GT(sides.fluid, 1000U);
  }
}

TEST(CellLayerTest, PointsOnBothSidesOfAPlateBelongToItsTwoPieces) {
  const auto soup = tessellation::box({-9, -9, 0.3}, {9, 9, 0.3 + 1e-6});
  const auto cells = cut(Solid<double>(MeshSDF<double>(soup)));
  const detail::CellLayer layer(cells, 1, 7);
  ASSERT_EQ(layer.cells().size(), 20U);
  for (const auto& cell : layer.cells()) {
    const auto [lower, upper] = layer.rectangle(cell.row);
    const double x = 0.3 * lower[0] + 0.7 * upper[0];
    for (const double z : {0.25, 0.299, 0.301, 0.32}) {
      const auto found = cell.at({x, z});
      EXPECT_TRUE(found.isFluid);
      EXPECT_EQ(cells.pieces.cell[found.piece], cell.row);
      EXPECT_EQ(cells.pieces.centroid[found.piece].z > 0.3, z > 0.3);
    }
  }
}

TEST(CellLayerTest, BothSidesOfABaffleAreFluid) {
  PolygonSoup sail;
  sail.patchNames = {"sail"};
  sail.points = {{-3, -3, 0.1}, {3, -3, 0.5}, {3, 3, 0.5}, {-3, 3, 0.1}};
  sail.addPolygon(std::array{0U, 1U, 2U}, 0);
  sail.addPolygon(std::array{0U, 2U, 3U}, 0);
  const auto heightAt = [](double x) { return 0.3 + 0.2 * x / 3; };
  const Level<double> level({-1.1, -1.1, -1.1}, {kCellWidth, kCellWidth, kCellWidth});
  const auto cells =
      CellCutter(Solid<double>(MeshSDF<double>(sail)), FluidSide::Outside, {.baffles = {"sail"}})
          .cut(GridPatch<double>{level, IndexBox::ofSize(20, 20, 20)}, {.polygons = true});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (const int axis : {0, 1}) {
    const detail::CellLayer layer(cells, axis, 7);
    ASSERT_GE(layer.cells().size(), 20U);
    for (const auto& cell : layer.cells()) {
      const auto [lower, upper] = layer.rectangle(cell.row);
      for (int n = 0; n < 50; ++n) {
        const detail::PlanePoint p{lower[0] + share(random) * (upper[0] - lower[0]),
                                   lower[1] + share(random) * (upper[1] - lower[1])};
        const auto found = cell.at(p);
        ASSERT_TRUE(found.isFluid);
        const auto& centroid = cells.pieces.centroid[found.piece];
        const double height = heightAt(axis == 0 ? layer.middle() : p[0]);
        ASSERT_EQ(centroid.z > heightAt(centroid.x), p[1] > height) << axis << ' ' << p[1];
      }
    }
  }
}

TEST(CellLayerTest, SegmentsAreTheSectionOfTheSurface) {
  // A ball of facets: the section is a closed line as long as its circle, but for the sag.
  const auto cells = cut(Solid<double>(MeshSDF<double>(tessellation::icosphere(0.8, 4))));
  const detail::CellLayer layer(cells, 2, 12);
  EXPECT_DOUBLE_EQ(layer.middle(), -1.1 + 12.5 * kCellWidth);
  double length = 0;
  for (const auto& cell : layer.cells()) {
    for (const auto& s : cell.segments) {
      length += std::hypot(s.to[0] - s.from[0], s.to[1] - s.from[1]);
      EXPECT_GT(s.normal[0] * s.from[0] + s.normal[1] * s.from[1], 0);  // into the fluid
    }
  }
  const double radius = std::sqrt(0.64 - layer.middle() * layer.middle());
  EXPECT_NEAR(length, 2 * M_PI * radius, 0.01 * radius);
}

TEST(CellLayerTest, RefusesLayersThatAreNone) {
  const Solid<double> ball(MeshSDF<double>(tessellation::icosphere(0.8, 1)));
  const auto cells = cut(ball);
  EXPECT_THROW(detail::CellLayer(cells, 3, 0), Error);
  EXPECT_THROW(detail::CellLayer(cells, -1, 0), Error);
  EXPECT_THROW(detail::CellLayer(cells, 0, 20), Error);
  EXPECT_THROW(detail::CellLayer(cells, 0, -1), Error);
  const auto without = CellCutter(ball).cut(cellsBetween({{{0, 1}, {0, 1}, {0, 1}}}));
  EXPECT_THROW(detail::CellLayer(without, 0, 0), Error);
}

}  // namespace
}  // namespace cutwater::test
