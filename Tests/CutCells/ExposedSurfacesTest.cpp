#include <Cutwater/CutCells/Detail/Curved/ExposedSurfaces.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

std::shared_ptr<const FluidField> fieldOf(const Ball<double>& ball) {
  return fluidBeside<double>(Sphere<double>(ball.center, ball.radius), FluidSide::Outside);
}

std::shared_ptr<const FluidField> fieldOf(std::span<const Ball<double>> balls) {
  std::vector<Solid<double>> solids;
  for (const auto& [center, radius] : balls) solids.push_back(Sphere<double>(center, radius));
  return fluidBeside<double>(unionOf(solids), FluidSide::Outside);
}

TEST(ExposedSurfacesTest, OneWithinAnotherIsLeftOut) {
  const std::vector<Ball<double>> balls{{{0, 0, 0}, 1}, {{0.3, 0, 0}, 0.2}};
  const auto all = fieldOf(balls);
  const auto outer = fieldOf(balls[0]);
  const auto inner = fieldOf(balls[1]);
  const std::vector<const FluidField*> both{outer.get(), inner.get()};
  const Box<double> around{{0, -0.5, -0.5}, {1.2, 0.5, 0.5}};
  EXPECT_EQ(exposedIn(*all, around, both), std::vector<const FluidField*>{outer.get()});
  const Box<double> within{{0.05, -0.25, -0.25}, {0.55, 0.25, 0.25}};
  EXPECT_TRUE(exposedIn(*all, within, both).empty());
  const Box<double> section{{0, -0.5, 0}, {1.2, 0.5, 0}};
  EXPECT_EQ(exposedIn(*all, section, both), std::vector<const FluidField*>{outer.get()});
}

/// A point of a ball's surface; on the circle in which it meets the plane of a rectangle. Not a
/// number, if it does not.
Vec3<double> anywhereOn(const Ball<double>& ball, const Box<double>& box, int flatAxis,
                        std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vec3<double> offset{normal(random), normal(random), normal(random)};
  double height = 0;
  if (flatAxis >= 0) {
    height = box.lower[flatAxis] - ball.center[flatAxis];
    offset[flatAxis] = 0;
  }
  offset *= std::sqrt(ball.radius * ball.radius - height * height) / length(offset);
  auto point = ball.center + offset;
  if (flatAxis >= 0) point[flatAxis] = box.lower[flatAxis];
  return point;
}

/// Boxes and rectangles across an axis, anywhere in unions of balls: of a surface that is left out,
/// no point there is wall.
TEST(ExposedSurfacesTest, WhatIsLeftOutIsNoWall) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-1, 1);
  std::size_t leftOut = 0;
  std::size_t points = 0;
  for (int round = 0; round < scaled(400); ++round) {
    SCOPED_TRACE(round);
    std::vector<Ball<double>> balls;
    std::vector<std::shared_ptr<const FluidField>> fields;
    std::vector<const FluidField*> surfaces;
    for (int i = 0; i < 5; ++i) {
      balls.push_back({{at(random), at(random), at(random)}, 0.55 + 0.45 * at(random)});
      fields.push_back(fieldOf(balls.back()));
      surfaces.push_back(fields.back().get());
    }
    const auto all = fieldOf(balls);
    const Vec3<double> middle{at(random), at(random), at(random)};
    const double half = 0.35 + 0.25 * at(random);
    Box<double> box{middle - Vec3<double>{half, half, half},
                    middle + Vec3<double>{half, half, half}};
    const int flatAxis = round % 4 - 1;
    if (flatAxis >= 0) box.lower[flatAxis] = box.upper[flatAxis] = middle[flatAxis];
    const auto exposed = exposedIn(*all, box, surfaces);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (std::ranges::find(exposed, surfaces[i]) != exposed.end()) continue;
      ++leftOut;
      for (int n = 0; n < 500; ++n) {
        const auto point = anywhereOn(balls[i], box, flatAxis, random);
        if (!box.contains(point)) continue;
        ++points;
        EXPECT_LT(all->value(point), 0);
      }
    }
  }
  EXPECT_GT(leftOut, static_cast<std::size_t>(scaled(400)));
  EXPECT_GT(points, static_cast<std::size_t>(scaled(2000)));
}

}  // namespace
}  // namespace cutwater::test
