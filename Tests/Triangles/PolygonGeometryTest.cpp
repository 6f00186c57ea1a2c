#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "Support/Float128.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

using Corners = std::array<Vec3<double>, 3>;

struct Exact {
  Vec3<double> normal;
  double area;
  std::array<double, 3> angles;
};

/// From the definition, in quadruple precision.
Exact exactShape(const Corners& p) {
  Exact result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto u = Vec3Float128::difference(p[(i + 1) % 3], p[i]);
    const auto v = Vec3Float128::difference(p[(i + 2) % 3], p[i]);
    const auto n = cross(u, v);
    const Float128 size = squareRoot(dot(n, n));
    result.normal = {static_cast<double>(n.x / size), static_cast<double>(n.y / size),
                     static_cast<double>(n.z / size)};
    result.area = static_cast<double>(size / 2);
    result.angles[i] = std::atan2(static_cast<double>(size), static_cast<double>(dot(u, v)));
  }
  return result;
}

/// A triangle with an edge of about 1 and a height over it of about `ratio`, anywhere and any way
/// round; its normal is ill-conditioned, but a definite number.
Corners needle(RandomPoints<double>& random, double ratio) {
  const Vec3<double> a = random.next();
  const Vec3<double> b = a + random.next();
  const double t = 0.7 * random.next().x;
  const Vec3<double> c = a + t * (b - a) + ratio * random.next();
  return {a, b, c};
}

TEST(PolygonGeometry, NormalsOfNeedlesAreThoseOfTheirExactCorners) {
  RandomPoints<double> random(1);
  for (const double ratio : {1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    for (int i = 0; i < 2000; ++i) {
      const Corners corners = needle(random, ratio);
      const Exact want = exactShape(corners);
      const TriangleShape got = triangleShape(corners);
      ASSERT_LE(length(got.normal - want.normal), 64 * kEps) << ratio;
      ASSERT_NEAR(got.area, want.area, 64 * kEps * want.area) << ratio;
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_NEAR(got.angles[k], want.angles[k], 64 * kEps * want.angles[k]) << ratio;
      }
    }
  }
}

TEST(PolygonGeometry, OffsetsCostNothing) {
  RandomPoints<double> random(1);
  for (int i = 0; i < 2000; ++i) {
    Corners corners = needle(random, 1e-4);
    for (auto& p : corners) p += Vec3<double>{1e6, -3e6, 2e6};
    const Exact want = exactShape(corners);
    const TriangleShape got = triangleShape(corners);
    ASSERT_LE(length(got.normal - want.normal), 64 * kEps);
    ASSERT_NEAR(got.area, want.area, 64 * kEps * want.area);
  }
}

TEST(PolygonGeometry, SizeChangesNoDigit) {
  const Corners corners{{{0.1, 0.2, 0.3}, {1.1, 0.3, 0.5}, {0.7, 1.9, 0.2}}};
  const TriangleShape want = triangleShape(corners);
  for (const int exponent : {-600, -300, 300, 500}) {
    Corners scaled = corners;
    for (auto& p : scaled) p *= std::ldexp(1.0, exponent);
    const TriangleShape got = triangleShape(scaled);
    EXPECT_EQ(got.normal, want.normal) << exponent;
    EXPECT_EQ(got.angles, want.angles) << exponent;
    EXPECT_EQ(got.area, std::ldexp(want.area, 2 * exponent)) << exponent;
  }
}

TEST(PolygonGeometry, CollinearCornersHaveNoArea) {
  for (const Corners& corners :
       {Corners{{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}}, Corners{{{1, 1, 1}, {1, 1, 1}, {2, 0, 5}}},
        Corners{{{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}}},
        Corners{{{0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}, {0.3, 0.3, 0.3}}}}) {
    const TriangleShape shape = triangleShape(corners);
    EXPECT_EQ(shape.normal, Vec3<double>{});
    EXPECT_EQ(shape.area, 0);
    EXPECT_EQ(shape.angles, (std::array<double, 3>{}));
  }
}

TEST(PolygonGeometry, CollinearCornersOfManyBitsHaveNoArea) {
  // Corners on a line through the origin, too far apart in size for products without rounding.
  std::mt19937 engine(1);
  std::uniform_int_distribution<int> number(-(1 << 20), 1 << 20);
  for (int i = 0; i < 10000; ++i) {
    const Vec3<double> direction(std::array<double, 3>{
        double(number(engine)), double(number(engine)), double(number(engine))});
    Corners corners;
    int exponent = 0;
    for (auto& p : corners) p = std::ldexp(number(engine), exponent -= 34) * direction;
    EXPECT_EQ(polygonArea(corners).normal, Vec3<double>{});
  }
}

TEST(PolygonGeometry, KnowsHandValues) {
  const TriangleShape half = triangleShape({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}});
  EXPECT_EQ(half.normal, (Vec3<double>{0, 0, 1}));
  EXPECT_EQ(half.area, 2);
  EXPECT_NEAR(half.angles[0], std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(half.angles[1], std::numbers::pi / 4, 1e-15);

  const std::vector<Vec3<double>> ell{{0, 0, 5}, {2, 0, 5}, {2, 1, 5},
                                      {1, 1, 5}, {1, 2, 5}, {0, 2, 5}};
  EXPECT_EQ(polygonArea(ell).area, 3);
  EXPECT_EQ(polygonArea(ell).normal, (Vec3<double>{0, 0, 1}));

  // Two corners up, two down: the best plane is level, and its projection is the unit square.
  const std::vector<Vec3<double>> saddle{{0, 0, 1}, {1, 0, -1}, {1, 1, 1}, {0, 1, -1}};
  EXPECT_EQ(polygonArea(saddle).normal, (Vec3<double>{0, 0, 1}));
  EXPECT_EQ(polygonArea(saddle).area, 1);
  EXPECT_EQ(polygonArea(std::vector<Vec3<double>>{{0, 0, 1}, {1, 0, -1}}).area, 0);
}

TEST(PolygonGeometry, PositionsAreScaledByAPowerOfTwo) {
  const std::vector<Vec3<float>> positions{{3, -12, 0.5F}, {1, 8, -2}};  // 8 <= 12 < 16
  EXPECT_EQ(normalizingScale<float>(positions), 0.125F);
  const std::vector<Vec3<double>> some{{3, -12, 0.5}, {1e200, 0, HUGE_VAL}, {1, 8, -2}};
  const std::vector<std::uint32_t> used{2, 0, 2};
  EXPECT_EQ(normalizingScale(some, used), 0.125);
  EXPECT_EQ(normalizedPositions(some, used),
            (std::vector<Vec3<double>>{{0.375, -1.5, 0.0625}, {}, {0.125, 1, -0.25}}));
  EXPECT_EQ(normalizedPositions(std::vector<Vec3<double>>(2), std::vector{1U}),
            std::vector<Vec3<double>>(2));
}

TEST(PolygonGeometry, PointsOfNoTriangleDoNotChangeTheScale) {
  const std::vector<Vec3<float>> positions{{3, 0, 0}, {0, -5, 0}, {1e30F, 0, 0}, {0, 0, 1}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 3}};
  EXPECT_EQ(normalizingScale<float>(positions, triangles), 0.25F);
  EXPECT_EQ(normalizedPositions<float>(positions, triangles)[1], (Vec3<double>{0, -1.25, 0}));
  EXPECT_EQ(normalizingScale<float>(positions, {}), 1.0F);
}

TEST(PolygonGeometry, BoxesAreThoseOfEachTriangle) {
  const std::vector<Vec3<float>> positions{{0, 0, 0}, {2, 0, 1}, {0, 3, -1}, {-1, 4, 5}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {2, 1, 3}, {3, 3, 3}};
  EXPECT_EQ(triangleBoxes<float>(positions, triangles),
            (std::vector<Box<double>>{
                {{0, 0, -1}, {2, 3, 1}}, {{-1, 0, -1}, {2, 4, 5}}, {{-1, 4, 5}, {-1, 4, 5}}}));
}

}  // namespace
}  // namespace cutwater::test
