#include <Cutwater/Bvh/Detail/FittingAxes.hpp>

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::detail::test {
namespace {

using Triangles = std::vector<std::array<Vec3<double>, 3>>;

std::optional<BoxAxes> axesOf(const Triangles& triangles) {
  return fittingAxes(triangles.size(), [&](std::size_t i) { return triangles[i]; });
}

/// Four triangles around the middle of a rectangle with these sides; `back`: seen from behind.
Triangles rectangle(const Vec3<double>& a, const Vec3<double>& b, bool back = false) {
  const Vec3<double> middle;
  const std::array corners{-0.5 * (a + b), 0.5 * (a - b), 0.5 * (a + b), 0.5 * (b - a)};
  Triangles result;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& p = corners[i];
    const auto& q = corners[(i + 1) % 4];
    result.push_back({middle, back ? q : p, back ? p : q});
  }
  return result;
}

void expectOrthonormal(const BoxAxes& axes) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(dot(Vec3<double>(axes[i]), Vec3<double>(axes[k])), i == k ? 1 : 0, 1e-6);
    }
  }
}

void expectAlong(const Vec3<float>& axis, const Vec3<double>& direction) {
  EXPECT_NEAR(std::abs(dot(Vec3<double>(axis), normalized(direction))), 1, 1e-6);
}

TEST(FittingAxesTest, AreTheSidesOfARectangleHoweverItIsTurned) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 200; ++round) {
    const auto a = normalized(Vec3<double>{number(random), number(random), number(random)});
    const auto away = Vec3<double>{number(random), number(random), number(random)};
    const auto b = 0.3 * normalized(cross(a, away));
    for (const bool isLongFirst : {true, false}) {
      const auto axes = isLongFirst ? axesOf(rectangle(a, b)) : axesOf(rectangle(b, a));
      ASSERT_TRUE(axes);
      expectOrthonormal(*axes);
      expectAlong((*axes)[0], a);
      expectAlong((*axes)[1], b);
      expectAlong((*axes)[2], cross(a, b));
    }
  }
}

TEST(FittingAxesTest, OfAPlateAreThoseOfItsSides) {
  const Vec3<double> a{1, 1, 0};
  const Vec3<double> b{0, 0, 0.25};
  auto plate = rectangle(a, b);
  for (const auto& back : rectangle(a, b, true)) plate.push_back(back);
  const auto axes = axesOf(plate);
  ASSERT_TRUE(axes);
  expectAlong((*axes)[0], a);
  expectAlong((*axes)[2], cross(a, b));
}

TEST(FittingAxesTest, OfASquareAreAnyInItsPlane) {
  const auto axes = axesOf(rectangle({0, 1, 0}, {0, 0, 1}));
  ASSERT_TRUE(axes);
  expectOrthonormal(*axes);
  expectAlong((*axes)[2], {1, 0, 0});
}

TEST(FittingAxesTest, ThereAreNoneWithoutArea) {
  EXPECT_FALSE(axesOf({}));
  EXPECT_FALSE(axesOf({{Vec3<double>{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}}));
}

}  // namespace
}  // namespace cutwater::detail::test
