#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Extrusion.hpp>
#include <Cutwater/Shapes/HexagonalPrism.hpp>

#include "Polygons.hpp"
#include "Support/CpuTime.hpp"
#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ExtrusionTest : public ::testing::Test {};
TYPED_TEST_SUITE(ExtrusionTest, Precisions);

TYPED_TEST(ExtrusionTest, MatchesHandComputedValues) {
  using T = TypeParam;
  // A square pipe.
  const Extrusion<T> pipe(Polygon<T>(rectangle<T>(-4, -4, 4, 4), {rectangle<T>(-2, -2, 2, 2)}), 0,
                          10);
  EXPECT_EQ(pipe.signedDistance({3, 0, 5}), T(-1));
  EXPECT_EQ(pipe.signedDistance({0, 0, 5}), T(2));
  EXPECT_EQ(pipe.signedDistance({1, 1, 5}), T(1));
  EXPECT_EQ(pipe.signedDistance({7, 8, 5}), T(5));
  EXPECT_EQ(pipe.signedDistance({3, 0, T(0.5)}), T(-0.5));
  EXPECT_EQ(pipe.signedDistance({3, 3, -2}), T(2));
  EXPECT_EQ(pipe.signedDistance({7, 0, 14}), T(5));
  EXPECT_EQ(pipe.gradient({1, 0, 5}), (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(pipe.gradient({3, 0, T(9.5)}), (Vec3<T>{0, 0, 1}));
  EXPECT_EQ(pipe.gradient({7, 8, 5}), (Vec3<T>{T(0.6), T(0.8), 0}));
  EXPECT_EQ(pipe.gradient({7, 0, 14}), (Vec3<T>{T(0.6), 0, T(0.8)}));
  EXPECT_EQ(pipe.gradient({0, 0, 5}), Vec3<T>{});
  EXPECT_EQ(pipe.gradient({0, 0, 12}), (Vec3<T>{}));
}

TYPED_TEST(ExtrusionTest, IsWhatShapesWithTheSameSectionAre) {
  using T = TypeParam;
  const Extrusion<T> box(Polygon<T>(rectangle<T>(-1, T(-0.5), 2, T(0.75))), -1, 1);
  const Cuboid<T> cuboid({-1, T(-0.5), -1}, {2, T(0.75), 1});
  const T side = 1 / std::sqrt(T(3));
  const Extrusion<T> hexagon(
      Polygon<T>({{2 * side, 0}, {side, 1}, {-side, 1}, {-2 * side, 0}, {-side, -1}, {side, -1}}),
      T(-0.5), T(0.5));
  const HexagonalPrism<T> prism(1, 1);
  RandomPoints<T> points(3);
  for (int i = 0; i < 2000; ++i) {
    auto p = points.next();
    if (i % 3 == 0) p[i / 3 % 3] = 0;
    EXPECT_NEAR(box.signedDistance(p), cuboid.signedDistance(p), tolerance<T>(8, 1)) << p;
    EXPECT_NEAR(hexagon.signedDistance(p), prism.signedDistance(p), tolerance<T>(8, 4)) << p;
  }
}

/// Against all edges in quadruple precision, sign and all, at points in the plane z = 0.
template <typename T>
void expectBruteForce(const Polygon<T>& polygon, double extent, int count) {
  const Extrusion<T> solid(polygon, T(-1e4), T(1e4));
  RandomPoints<double> random(1);
  const auto all = polygon.loops();
  for (int i = 0; i < count; ++i) {
    const auto r = random.next();
    const auto s = random.next();
    Vec2<T> p{static_cast<T>(extent * r.x), static_cast<T>(extent * r.y)};
    if (i % 2 == 0) {  // near a corner
      const auto& loop = all[static_cast<std::size_t>(i / 2) % all.size()];
      const auto& corner = loop[static_cast<std::size_t>(i / 4) % loop.size()];
      const double away = extent * std::pow(10.0, 3 * (s.x - 1));
      p = {static_cast<T>(corner.x + away * r.x), static_cast<T>(corner.y + away * r.y)};
      if (i % 3 == 0) p.x = corner.x;
      if (i % 5 == 0) p.y = corner.y;
    }
    const double value = double{solid.signedDistance({p.x, p.y, 0})};
    const double exactly = bruteDistance(polygon, p);
    const T allowed = tolerance<T>(length(p) + static_cast<T>(extent), 4);
    EXPECT_NEAR(value, exactly, double{allowed}) << p.x << ' ' << p.y;
  }
}

TYPED_TEST(ExtrusionTest, AgreesWithAllEdgesInQuadruplePrecision) {
  using T = TypeParam;
  expectBruteForce(nastyPolygon<T>(), 1.5, scaled(4000));
  expectBruteForce(Polygon<T>(star<T>({0, 0}, 0.7, 1, 301), {star<T>({0, 0}, 0.2, 0.6, 200)}), 1.5,
                   scaled(2000));
  expectBruteForce(Polygon<T>(star<T>({0.3, 0.1}, 0.01, 1, 2000)), 1.5, scaled(500));  // spiky
}

TYPED_TEST(ExtrusionTest, HasTheSignRightBeyondTheTipOfANeedle) {
  using T = TypeParam;
  // So sharp that near the tip its two sides are equally near but for rounding.
  for (const double slope : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const T y = static_cast<T>(slope);
    const Polygon<T> needle({{-1, -y}, {0, 0}, {-1, y}});
    const Extrusion<T> solid(needle, T(-1e4), T(1e4));
    const Polygon<T> notched({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, y}, {0, 0}, {-1, -y}});
    const Extrusion<T> notch(notched, T(-1e4), T(1e4));
    RandomPoints<double> random(1);
    for (int i = 0; i < 2000; ++i) {
      const auto r = random.next();
      const double along = std::pow(10.0, 4 * (r.x - 1));  // from 1e-8
      const double off = 0.5 * std::pow(10.0, 4 * (r.y - 1));
      const Vec3<T> p{static_cast<T>(i % 2 == 0 ? -along : along),
                      static_cast<T>(i % 4 < 2 ? -off : off), 0};
      for (const auto* pair : {&needle, &notched}) {
        const double exactly = bruteDistance<T>(*pair, {p.x, p.y});
        const T value = (pair == &needle ? solid : notch).signedDistance(p);
        EXPECT_NEAR(double{value}, exactly, double{tolerance<T>(1, 4)}) << slope << " at " << p;
      }
    }
  }
}

TEST(ExtrusionGrowth, TakesAboutAsLongWithAHundredTimesTheEdges) {
  const auto secondsWith = [](int corners) {
    const Polygon<double> outline(star<double>({0, 0}, 0.99, 1, corners));
    const Extrusion<double> solid(outline, -1, 1);
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 3; ++round) {
      RandomPoints<double> points(1.5);
      double sum = 0;
      least = std::min(least, cpuSeconds([&] {
                         for (int i = 0; i < 20000; ++i) sum += solid.signedDistance(points.next());
                       }));
      EXPECT_NE(sum, 0);
    }
    return least;
  };
  const double few = secondsWith(1000);
  const double seconds = cpuSeconds([&] { EXPECT_LT(secondsWith(100000), 12 * few); });
  EXPECT_LT(seconds, 20);  // building it is not quadratic either
}

TYPED_TEST(ExtrusionTest, RefusesImpossibleEnds) {
  using T = TypeParam;
  const Polygon<T> square(rectangle<T>(0, 0, 1, 1));
  EXPECT_THROW((Extrusion<T>(square, 0, 0)), Error);
  EXPECT_THROW((Extrusion<T>(square, 1, 0)), Error);
  EXPECT_THROW((Extrusion<T>(square, 0, std::numeric_limits<T>::infinity())), Error);
  EXPECT_THROW((Extrusion<T>(square, std::numeric_limits<T>::quiet_NaN(), 1)), Error);
}

TYPED_TEST(ExtrusionTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(Extrusion<T>(nastyPolygon<T>(), T(-0.75), T(0.5)), 1.75,
                  {.inside =
                       [](const Vec3<double>& p) {
                         return p.z > -0.75 && p.z < 0.5 &&
                                bruteDistance<T>(nastyPolygon<T>(),
                                                 {static_cast<T>(p.x), static_cast<T>(p.y)}) < 0;
                       },
                   .covering = 8});
  expectGuarantee(Extrusion<T>(Polygon<T>(star<T>({0, 0}, 0.75, 1, 100)), -1, 0), 2,
                  {.covering = 4});
}

TEST(ExtrusionRounding, StaysWithinItsBound) {
  const auto widened = [](const Polygon<float>& polygon) {
    std::vector<Loop<double>> loops;
    for (const auto& loop : polygon.loops()) {
      loops.emplace_back();
      for (const auto& corner : loop) loops.back().push_back({corner.x, corner.y});
    }
    return Polygon<double>(loops[0], {loops.begin() + 1, loops.end()});
  };
  const auto nasty = nastyPolygon<float>();
  expectRounding(Extrusion<float>(nasty, -1, 2), Extrusion<double>(widened(nasty), -1, 2), 4);
  const Polygon<float> round(star<float>({10, 5}, 0.9, 1, 100));
  expectRounding(Extrusion<float>(round, -1, 2), Extrusion<double>(widened(round), -1, 2), 40);
}

}  // namespace
}  // namespace cutwater::test
