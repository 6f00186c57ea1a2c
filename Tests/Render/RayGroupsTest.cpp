#include <Cutwater/Render/Detail/RayGroups.hpp>

#include <gtest/gtest.h>

#include "Looks.hpp"

namespace cutwater::test {
namespace {

using detail::GroupedRay;
using detail::Ray;

/// Rays through 16 x 16 neighbouring pixels, in squares of squares.
std::vector<Ray> tile(const Look& look) {
  std::vector<Ray> rays;
  for (int n = 0; n < 256; ++n) {
    const auto bits = [&](int from) {
      return (n >> from & 1) | (n >> (from + 1) & 2) | (n >> (from + 2) & 4) |
             (n >> (from + 3) & 8);
    };
    const auto at = Look::middle(40 + bits(0), 40 + bits(1));
    rays.push_back(look.camera.ray(at.x, at.y));
  }
  return rays;
}

/// Advances the rays towards a ball; returns the number of evaluations.
std::size_t advance(const Look& look, std::vector<Ray>& rays, std::vector<GroupedRay>& grouped,
                    double radius, double reach) {
  for (const auto& ray : rays) {
    const double begin = look.camera.isOrthographic() ? -2 : 0;
    grouped.push_back({&ray, 100, begin});
  }
  std::size_t count = 0;
  detail::advanceTogether(grouped, look.camera, reach,
                          [&](std::span<const Vec3<double>> places, std::span<double> free) {
                            count += places.size();
                            for (std::size_t i = 0; i < places.size(); ++i) {
                              free[i] = length(places[i]) - radius;
                            }
                          });
  return count;
}

TEST(RayGroupsTest, NoneIsAdvancedIntoTheSurfaceOrToItsReach) {
  for (const double fieldOfView : {0.0, 40.0}) {
    for (const double radius : {0.02, 0.3, 1.0}) {
      const Look look(View::named("iso"), fieldOfView);
      auto rays = tile(look);
      std::vector<GroupedRay> grouped;
      const auto count = advance(look, rays, grouped, radius, 0.8);
      EXPECT_LT(count, 1500U);  // of 256 rays, one by one about ten times as many
      std::size_t near = 0;
      for (const auto& [ray, end, along] : grouped) {
        // Where the ray has come through, its least distance to the ball; it ascends behind.
        const double middle = std::min(-dot(ray->origin, ray->direction), along);
        const double least = length(ray->at(middle)) - radius;
        ASSERT_GT(least, 0) << radius;
        const double now = length(ray->at(along)) - radius;
        near += now < 8 * look.camera.pixelSize(along) ? 1 : 0;
      }
      const std::size_t fewest =
          radius == 1.0 ? grouped.size() : 0;  // all come close to a large one
      EXPECT_GE(near, fewest);
    }
  }
}

TEST(RayGroupsTest, WhatComesWithinReachIsLeftToTheRays) {
  // All rays pass a small ball; those within the reach of it stop before they have passed.
  const Look look(View::named("+z"));
  auto rays = tile(look);
  std::vector<GroupedRay> grouped;
  const double reach = 2;
  advance(look, rays, grouped, 1e-3, reach);
  std::size_t close = 0;
  for (const auto& [ray, end, along] : grouped) {
    const double passing = -dot(ray->origin, ray->direction);
    const double least = length(ray->at(passing));
    if (least > (reach - 0.5) * Look::kPixel) continue;
    ++close;
    EXPECT_LT(along, passing);
  }
  EXPECT_GT(close, 3U);
}

TEST(RayGroupsTest, NothingIsDoneWithoutRoom) {
  const Look look(View::named("+z"));
  auto rays = tile(look);
  std::vector<GroupedRay> grouped{
      {rays.data(), 5, 1}, {&rays[1], 5, 2}, {&rays[2], 5, 3}, {&rays[3], 5, 4}};
  detail::advanceTogether(
      grouped, look.camera, 1,
      [](std::span<const Vec3<double>>, std::span<double> free) { std::ranges::fill(free, -1); });
  for (std::size_t i = 0; i < grouped.size(); ++i) {
    EXPECT_EQ(grouped[i].along, static_cast<double>(i + 1));
  }
  detail::advanceTogether({}, look.camera, 1,
                          [](std::span<const Vec3<double>>, std::span<double>) { FAIL(); });
}

}  // namespace
}  // namespace cutwater::test
