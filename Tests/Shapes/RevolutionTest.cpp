#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Cone.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Revolution.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Polygons.hpp"
#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class RevolutionTest : public ::testing::Test {};
TYPED_TEST_SUITE(RevolutionTest, Precisions);

TYPED_TEST(RevolutionTest, MatchesHandComputedValues) {
  using T = TypeParam;
  // A pipe from z = 0 to 10.
  const Revolution<T> pipe(Polygon<T>(rectangle<T>(2, 0, 4, 10)));
  EXPECT_EQ(pipe.signedDistance({0, 3, 5}), T(-1));
  EXPECT_EQ(pipe.signedDistance({0, 0, 5}), T(2));
  EXPECT_EQ(pipe.signedDistance({7, 0, 14}), T(5));
  EXPECT_EQ(pipe.gradient({0, -1, 5}), (Vec3<T>{0, 1, 0}));
  EXPECT_EQ(pipe.gradient({0, 0, 5}), Vec3<T>{});
  // A rod: the side on the axis does not count.
  const Revolution<T> rod(Polygon<T>(rectangle<T>(0, 0, 4, 10)));
  EXPECT_EQ(rod.signedDistance({0, 0, 5}), T(-4));
  EXPECT_EQ(rod.signedDistance({1, 0, 5}), T(-3));
  EXPECT_EQ(rod.signedDistance({0, 0, 8}), T(-2));
  EXPECT_EQ(rod.signedDistance({0, 0, 12}), T(2));
  EXPECT_EQ(rod.gradient({0, 0, 8}), (Vec3<T>{0, 0, 1}));
}

TYPED_TEST(RevolutionTest, IsWhatShapesWithTheSameProfileAre) {
  using T = TypeParam;
  const Vec3<T> base{T(0.25), T(-0.5), 0};
  const Vec3<T> axis{1, 2, -2};  // 3 long
  const Revolution<T> rod(Polygon<T>(rectangle<T>(0, 0, T(0.5), 3)), base, axis);
  const Cylinder<T> cylinder(base, base + axis, T(0.5));
  const Revolution<T> spike(Polygon<T>({{0, 0}, {0, 3}, {T(0.75), 3}}), base, T(5) * axis);
  const Cone<T> cone(base, base + axis, T(0.75));
  RandomPoints<T> points(4);
  for (int i = 0; i < 2000; ++i) {
    auto p = points.next();
    if (i % 4 == 0) p = base + p.x * axis;
    EXPECT_NEAR(rod.signedDistance(p), cylinder.signedDistance(p), tolerance<T>(12, 4)) << p;
    EXPECT_NEAR(spike.signedDistance(p), cone.signedDistance(p), tolerance<T>(12, 4)) << p;
  }
}

TYPED_TEST(RevolutionTest, ApproachesATorus) {
  using T = TypeParam;
  constexpr int kCorners = 3000;
  const Revolution<T> ring(Polygon<T>(star<T>({2, 0}, 0.5, 0.5, kCorners)));
  const Torus<T> torus(2, T(0.5));
  RandomPoints<T> points(3);
  const double chord = 0.5 * (1 - std::cos(std::numbers::pi / kCorners));
  for (int i = 0; i < 2000; ++i) {
    const auto p = points.next();
    const double difference = double{ring.signedDistance(p)} - double{torus.signedDistance(p)};
    EXPECT_LE(std::abs(difference), chord + double{tolerance<T>(8, 4)}) << p;
  }
}

TYPED_TEST(RevolutionTest, AgreesWithAllEdgesOffTheAxis) {
  using T = TypeParam;
  // A vase with a cavity, whose outline and cavity have sides on the axis.
  const Loop<T> outline{{0, -1},     {T(0.8), -1}, {T(0.3), 0}, {T(0.9), 1},
                        {T(0.7), 1}, {0, T(0.2)},  {0, T(-0.1)}};
  const Loop<T> cavity{{T(0.1), T(-0.8)}, {T(0.4), T(-0.8)}, {T(0.1), T(-0.4)}};
  const Polygon<T> profile(outline, {cavity});
  const Revolution<T> vase(profile);
  // The profile and its mirror image are one polygon without a side on the axis.
  Loop<T> whole(outline.begin() + 1, outline.begin() + 6);
  for (std::size_t i = 4; i > 0; --i) whole.push_back({-outline[i].x, outline[i].y});
  auto mirrored = cavity;
  for (auto& corner : mirrored) corner.x = -corner.x;
  const Polygon<T> both(whole, {cavity, mirrored});
  EXPECT_NEAR(both.area(), 2 * profile.area(), tolerance<T>(8));
  RandomPoints<T> points(T(1.5));
  for (int i = 0; i < 3000; ++i) {
    auto p = points.next();
    if (i % 4 == 0) p.x = p.y = 0;
    const T radial = std::sqrt(p.x * p.x + p.y * p.y);
    EXPECT_NEAR(double{vase.signedDistance(p)}, bruteDistance<T>(both, {radial, p.z}),
                double{tolerance<T>(4, 4)})
        << p;
  }
}

TYPED_TEST(RevolutionTest, AnswersWhereSquaresOverflow) {
  using T = TypeParam;
  const T far = std::sqrt(std::numeric_limits<T>::max()) * 2;
  const Revolution<T> ring(Polygon<T>(rectangle<T>(1, -1, 2, 1)));
  for (const auto& p : {Vec3<T>{far, -far, 3}, Vec3<T>{far, 0, 0}, Vec3<T>{0, 0, -far}}) {
    EXPECT_GT(ring.signedDistance(p), far / 2) << p;
    EXPECT_TRUE(isFinite(ring.gradient(p))) << p;
    EXPECT_TRUE(isFinite(ring.closestPoint(p).point)) << p;
  }
}

TYPED_TEST(RevolutionTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW(Revolution<T>(Polygon<T>(rectangle<T>(-1, 0, 1, 1))), Error);
  const Polygon<T> profile(rectangle<T>(0, 0, 1, 1));
  EXPECT_THROW((Revolution<T>(profile, {0, 0, 0}, {0, 0, 0})), Error);
  EXPECT_THROW((Revolution<T>(profile, {0, nan, 0}, {0, 0, 1})), Error);
}

TYPED_TEST(RevolutionTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const Polygon<T> profile({{0, -1}, {T(0.8), -1}, {T(0.3), 0}, {T(0.9), 1}, {T(0.7), 1}, {0, 0}});
  expectGuarantee(Revolution<T>(profile), 2,
                  {.inside =
                       [=](const Vec3<double>& p) {
                         const auto radial = static_cast<T>(std::hypot(p.x, p.y));
                         return bruteDistance<T>(profile, {radial, static_cast<T>(p.z)}) < 0;
                       },
                   .covering = 4});
  expectGuarantee(
      Revolution<T>(Polygon<T>(star<T>({1, 0}, 0.4, 0.6, 40)), {T(0.25), 0, 0}, {1, -1, T(0.5)}),
      2.5, {.covering = 4});
}

TEST(RevolutionRounding, StaysWithinItsBound) {
  const Polygon<float> ring(star<float>({1, 0}, 0.4, 0.6, 40));
  Loop<double> wide;
  for (const auto& corner : ring.loops()[0]) wide.push_back({corner.x, corner.y});
  expectRounding(Revolution<float>(ring, {1, 2, 3}, {1, -1, 0.5f}),
                 Revolution<double>(Polygon<double>(wide), {1, 2, 3}, {1, -1, 0.5}), 4);
  expectRounding(Revolution<float>(Polygon<float>(rectangle<float>(0, 0, 1, 0.001f))),
                 Revolution<double>(Polygon<double>(rectangle<double>(0, 0, 1, 0.001f))), 4);
}

}  // namespace
}  // namespace cutwater::test
