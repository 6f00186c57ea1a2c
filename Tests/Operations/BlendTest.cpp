#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class BlendTest : public ::testing::Test {
 protected:
  Sphere<T> small_{{0, 0, 0}, 1};
  Sphere<T> large_{{0, 0, 0}, 3};
  Cuboid<T> box_{{-1, -1, -1}, {1, 1, 1}};
  Torus<T> ring_{T(1.5), T(0.5)};
};
TYPED_TEST_SUITE(BlendTest, Precisions);

TYPED_TEST(BlendTest, OfConcentricBallsIsOneBetween) {
  using T = TypeParam;
  const auto ball = blended(this->small_, this->large_, T(0.25));  // radius 1.5
  EXPECT_EQ(ball.signedDistance({0, 0, 0}), T(-1.5));
  EXPECT_EQ(ball.signedDistance({5, 0, 0}), T(3.5));
  EXPECT_EQ(ball.gradient({5, 0, 0}), (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(ball.closestPoint({5, 0, 0}).point, (Vec3<T>{1.5, 0, 0}));
  EXPECT_EQ(ball.owner({1.5, 0, 0}).object, 0U);  // nearer to the small one
  EXPECT_NEAR(ball.boundingBox().upper.x, T(3), tolerance<T>(4, 64));
}

TYPED_TEST(BlendTest, AtItsEndsIsTheOperandToTheBit) {
  using T = TypeParam;
  RandomPoints<T> points(3);
  for (int i = 0; i < 300; ++i) {
    const auto p = points.next();
    EXPECT_EQ(blended(this->box_, this->ring_, T(0)).signedDistance(p),
              this->box_.signedDistance(p));
    EXPECT_EQ(blended(this->box_, this->ring_, T(1)).signedDistance(p),
              this->ring_.signedDistance(p));
  }
}

TYPED_TEST(BlendTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto between = blended(this->box_, this->ring_, T(0.3));
  EXPECT_EQ(between.guarantee().outside, Quality::LowerBound);
  EXPECT_EQ(between.guarantee().lipschitz, (1 - T(0.3)) + T(0.3));
  expectGuarantee(between, 3, {.inside = [&](const Vec3<double>& p) {
                    const auto ring = std::hypot(std::hypot(p.x, p.y) - 1.5, p.z) - 0.5;
                    const auto d = abs(p) - Vec3<double>{1, 1, 1};
                    const auto box = length(max(d, {})) + std::min(maxComponent(d), 0.0);
                    const double t = static_cast<double>(T(0.3));
                    return (1 - t) * box + t * ring < 0;
                  }});
  expectGuarantee(rotated(blended(this->box_ - this->small_, this->ring_, T(0.5)), 30, {1, 2, 3}),
                  3);
}

TYPED_TEST(BlendTest, RefusesToExtrapolate) {
  using T = TypeParam;
  for (const T bad : {T(-0.1), T(1.1), std::numeric_limits<T>::quiet_NaN()}) {
    EXPECT_THROW(static_cast<void>(blended(this->box_, this->ring_, bad)), Error);
  }
}

}  // namespace
}  // namespace cutwater::test
