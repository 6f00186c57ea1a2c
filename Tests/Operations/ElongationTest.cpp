#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/CappedTorus.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ElongationTest : public ::testing::Test {
 protected:
  Sphere<T> ball_{{0, 0, 0}, 1};
  Torus<T> ring_{1, T(0.25)};
};
TYPED_TEST_SUITE(ElongationTest, Precisions);

TYPED_TEST(ElongationTest, MakesABallACapsuleAndAPointABox) {
  using T = TypeParam;
  const auto pill = elongated(this->ball_, {0, 0, 2});
  const Capsule<T> capsule({0, 0, -2}, {0, 0, 2}, 1);
  const auto brick = elongated(this->ball_, {1, 2, 3});
  const auto same = offset(Cuboid<T>({-1, -2, -3}, {1, 2, 3}), 1);
  RandomPoints<T> points(6);
  for (int i = 0; i < 1000; ++i) {
    const auto p = points.next();
    EXPECT_NEAR(pill.signedDistance(p), capsule.signedDistance(p), tolerance<T>(8));
    if (same.signedDistance(p) <= -1) continue;  // within the box all is at depth 1
    EXPECT_NEAR(brick.signedDistance(p), same.signedDistance(p), tolerance<T>(8));
  }
  EXPECT_EQ(pill.gradient({0, 2, 1}), (Vec3<T>{0, 1, 0}));
  EXPECT_TRUE(pill.closestPoint({0, 3, 1}).exact);
  EXPECT_EQ(pill.closestPoint({0, 3, 1}).point, (Vec3<T>{0, 1, 1}));
  EXPECT_NEAR(brick.boundingBox().upper.z, T(4), tolerance<T>(8, 256));
  EXPECT_EQ(elongated(this->ball_, {}).signedDistance({3, 4, 0}), T(4));
}

TYPED_TEST(ElongationTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto link = elongated(this->ring_, {0, T(0.5), T(0.25)});
  EXPECT_EQ(link.guarantee().outside, Quality::LowerBound);
  expectGuarantee(link, 2.25, {.inside = [&](const Vec3<double>& p) {
                    const auto gap = [](double x, double half) {
                      return std::copysign(std::max(std::abs(x) - half, 0.0), x);
                    };
                    const Vec3<double> q{p.x, gap(p.y, 0.5), gap(p.z, 0.25)};
                    return std::hypot(std::hypot(q.x, q.y) - 1, q.z) < 0.25;
                  }});
  // Neither symmetric nor convex, and off the planes.
  const auto moved = translated(rotated(this->ring_, 30, {1, 2, 3}), {T(0.75), T(0.25), 0});
  expectGuarantee(elongated(moved, {T(0.5), T(0.25), 1}), 3.5);
  expectGuarantee(rotated(elongated(translated(this->ball_, {2, 0, 0}), {1, 1, 0}), 20, 2), 5);
  expectGuarantee(elongated(this->ring_ | this->ball_, {T(0.5), 0, 0}), 3);
}

TYPED_TEST(ElongationTest, BoxesAwayFromThePlanesMoveApart) {
  using T = TypeParam;
  const auto box = elongated(Cuboid<T>({1, -3, -1}, {2, -2, 1}), {1, 1, 1}).boundingBox();
  EXPECT_NEAR(box.lower.x, T(2), tolerance<T>(4, 256));
  EXPECT_NEAR(box.upper.x, T(3), tolerance<T>(4, 256));
  EXPECT_NEAR(box.upper.y, T(-3), tolerance<T>(4, 256));
  EXPECT_NEAR(box.lower.z, T(-2), tolerance<T>(4, 256));
}

TYPED_TEST(ElongationTest, RefusesImpossibleLengths) {
  using T = TypeParam;
  EXPECT_THROW(static_cast<void>(elongated(this->ball_, {0, -1, 0})), Error);
  EXPECT_THROW(
      static_cast<void>(elongated(this->ball_, {0, 0, std::numeric_limits<T>::infinity()})), Error);
}

TYPED_TEST(ElongationTest, HasAGradientWhereTheOperandHasNone) {
  using T = TypeParam;
  const CappedTorus<T> arc(1, T(0.25), 45);
  EXPECT_EQ(arc.gradient({-1, 0, 0}), Vec3<T>{});  // both ends are equally near
  const auto gradient = elongated(arc, {0, T(0.5), 0}).gradient({-1, T(0.2), 0});
  const T x = -1 - std::sqrt(T(0.5));  // from the end's x to the point
  EXPECT_NEAR(gradient.x, x / std::hypot(x, std::sqrt(T(0.5))), T(1e-3));
  EXPECT_NEAR(gradient.y, T(0), T(1e-3));
}

TYPED_TEST(ElongationTest, HasNoGradientInTheGapHoweverNearItsEnd) {
  using T = TypeParam;
  const auto slab = elongated(Cuboid<T>({-1, 1, -1}, {1, 2, 1}), {0, T(0.5), 0});
  for (const T y : {T(0), T(0.25), T(0.4999), T(-0.4999)}) {
    EXPECT_EQ(slab.gradient({T(0.25), y, T(-0.25)}), Vec3<T>{}) << y;
  }
  EXPECT_EQ(slab.gradient({T(0.25), T(0.5001), T(-0.25)}), (Vec3<T>{0, -1, 0}));
  // Nor along it where the operand has none: differences reach beyond the gap.
  const CappedTorus<T> arc(1, T(0.25), 45);
  const auto gradient = elongated(arc, {0, T(0.5), 0}).gradient({-1, T(0.4999), 0});
  EXPECT_EQ(gradient.y, T(0));
}

}  // namespace
}  // namespace cutwater::test
